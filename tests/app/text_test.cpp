#include "app/text/text.hpp"

#include <gtest/gtest.h>

#include "app/base/embedded.hpp"
#include "app/storage/level.hpp"

namespace {

using app::InputDevice;
using app::Language;
using app::Text;
using app::Words;

TEST(Words, LanguageOfTheLocale) {
  EXPECT_EQ(app::language_of_locale("fr_FR.UTF-8"), Language::fr);
  EXPECT_EQ(app::language_of_locale("fr"), Language::fr);
  EXPECT_EQ(app::language_of_locale("en_GB"), Language::en);
  EXPECT_EQ(app::language_of_locale("de_AT.UTF-8"), Language::de);
  EXPECT_EQ(app::language_of_locale("de_DE@euro"), Language::de);
  EXPECT_EQ(app::language_of_locale("es-MX"), Language::es);
  EXPECT_EQ(app::language_of_locale("den"), Language::en) << "another language";
  EXPECT_EQ(app::language_of_locale("C"), Language::en);
  EXPECT_EQ(app::language_of_locale(""), Language::en);
}

TEST(Words, NumbersAreGroupedAsTheLanguageDoes) {
  const Words english(Language::en);
  const Words french(Language::fr);
  EXPECT_EQ(english.number(0), "0");
  EXPECT_EQ(english.number(999), "999");
  EXPECT_EQ(english.number(1000), "1,000");
  EXPECT_EQ(english.number(1234567), "1,234,567");
  EXPECT_EQ(english.number(-1000), "-1,000");
  EXPECT_EQ(english.number(-100), "-100");
  EXPECT_EQ(french.number(12300), "12\u202f300");
}

TEST(Words, DecimalsAreWrittenAsTheLanguageDoes) {
  EXPECT_EQ(Words(Language::en).tenths(1234.56), "1,234.6");
  EXPECT_EQ(Words(Language::fr).tenths(1234.56), "1\u202f234,6");
  EXPECT_EQ(Words(Language::fr).tenths(-0.25), "−0,3");
}

TEST(Words, CopiesSpeakAlike) {
  Words one(Language::en);
  const Words copy = one;
  one.speak(Language::fr);
  one.name_players({"", "Zoé"});
  EXPECT_EQ(copy(Text::quit), "Quitter");
  EXPECT_EQ(copy.number(1000), "1\u202f000");
  EXPECT_EQ(copy.player(0), "Joueur 1");
  EXPECT_EQ(copy.player(1), "Zoé");
  EXPECT_EQ(Words(Language::fr).player(1), "Joueur 2") << "another one's names are its own";
}

TEST(Words, ShippedLevelsHaveFrenchNames) {
  EXPECT_EQ(Words(Language::fr).level_name("First steps"), "Premiers pas");
  EXPECT_EQ(Words(Language::en).level_name("First steps"), "First steps");
  EXPECT_EQ(Words(Language::fr).level_name("My own"), "My own");
}

/// A file like those of po/compile.py, of texts that are all empty but one.
std::string file_of_texts(Text text, std::string_view value) {
  const auto all = static_cast<std::size_t>(Text::count) + app::shipped_levels().size();
  std::string file = std::string(app::texts_version) + '\0';
  for (int n = 0; n < 200; ++n) file += n % 10 == 1 && n != 11 ? '0' : n < 5 ? '1' : '2';
  file += '\0';
  for (std::size_t i = 0; i < all; ++i) {
    if (i == static_cast<std::size_t>(text)) file += value;
    file += '\0';
  }
  return file;
}

/// Puts the texts back that a language has.
class LoadedTexts : public testing::Test {
 protected:
  ~LoadedTexts() override {
    for (const app::Embedded& file : app::embedded_texts)
      if (file.name == "fr.texts")
        app::load_texts(Language::fr,
                        {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
  }
};

TEST_F(LoadedTexts, AreEnglishWhereOneIsMissing) {
  ASSERT_TRUE(app::load_texts(Language::fr, file_of_texts(Text::quit, "Sortir")));
  const Words words(Language::fr);
  EXPECT_EQ(words(Text::quit), "Sortir");
  EXPECT_EQ(words(Text::cancel), "Cancel");
  EXPECT_EQ(words.level_name("First steps"), "First steps");
  EXPECT_EQ(words.number(1000), "1,000");
}

TEST_F(LoadedTexts, HavePluralForms) {
  EXPECT_EQ(Words(Language::en).count(Text::turns, 1), "1 turn");
  EXPECT_EQ(Words(Language::en).count(Text::turns, 0), "0 turns");
  EXPECT_EQ(Words(Language::fr).count(Text::turns, 0), "0 tour");
  ASSERT_TRUE(app::load_texts(Language::fr, file_of_texts(Text::turns, "{0} a\x1f{0} b\x1f{0} c")));
  const Words words(Language::fr);
  EXPECT_EQ(words.count(Text::turns, 1), "1 a");
  EXPECT_EQ(words.count(Text::turns, 2), "2 b");
  EXPECT_EQ(words.count(Text::turns, 11), "11 c");
  EXPECT_EQ(words.count(Text::turns, 321), "321 a");
  // A text without a translation has the English forms.
  EXPECT_EQ(words.count(Text::replay_count, 11), "11 replays");
}

TEST_F(LoadedTexts, AreRefusedFromAnotherVersion) {
  std::string file = file_of_texts(Text::quit, "Sortir");
  EXPECT_FALSE(app::load_texts(Language::fr, file.substr(0, file.size() - 1)));
  EXPECT_FALSE(app::load_texts(Language::fr, file + '\0'));
  file[0] = 'X';
  EXPECT_FALSE(app::load_texts(Language::fr, file));
  EXPECT_FALSE(app::load_texts(Language::fr, ""));
  EXPECT_EQ(Words(Language::fr)(Text::quit), "Quitter") << "nothing changes";
}

TEST(Words, AreThereInEveryLanguage) {
  for (const Language language : app::all_languages()) {
    EXPECT_TRUE(app::has_texts(language));
    EXPECT_FALSE(app::name_of(language).empty());
    EXPECT_EQ(Words(language)(Text::language_name), app::name_of(language));
  }
  EXPECT_EQ(app::all_languages().front(), Language::en);
}

TEST(Words, EveryTextInEveryLanguageForEveryHand) {
  for (const Language language : app::all_languages()) {
    for (const InputDevice hand : {InputDevice::mouse, InputDevice::finger, InputDevice::pad}) {
      for (int i = 0; i < static_cast<int>(Text::count); ++i) {
        Words words(language);
        words.take_hand(hand);
        const std::string text = words(static_cast<Text>(i), {"a", "b", "c", "d", "e", "f", "g"});
        EXPECT_FALSE(text.empty());
        EXPECT_EQ(text.find_first_of("{}[]|"), std::string::npos) << text;
        EXPECT_EQ(text.find("  "), std::string::npos) << text;
        const Text what = static_cast<Text>(i);
        const bool a_sign = what >= Text::start_press_mouse && what <= Text::take_back_pad;
        const bool of_the_mouse = a_sign || what == Text::help_mouse || what == Text::way_clicks;
        if (hand == InputDevice::mouse || of_the_mouse) continue;
        for (const char* const mouse : {"lick", "liqu", "clic"})
          EXPECT_EQ(text.find(mouse), std::string::npos) << text;
      }
    }
  }
}

TEST(Words, NameTheInputDevice) {
  Words words(Language::en);
  EXPECT_EQ(words(Text::hint_shoot), "Click where to send it. Esc or right click: cancel.");
  EXPECT_EQ(words(Text::next_throw, {"N"}), "Next throw (N)");
  const Words copy = words;
  words.take_hand(InputDevice::finger);
  EXPECT_EQ(copy(Text::hint_shoot), "Tap where to send it. Two fingers: cancel.");
  EXPECT_EQ(copy(Text::next_throw, {"N"}), "Next throw");
  EXPECT_EQ(copy(Text::way_clicks), "Two taps");
  words.speak(Language::fr);
  EXPECT_EQ(copy(Text::hint_take_cue_ball), "Touchez la boule blanche pour viser.");
  words.take_hand(InputDevice::mouse);
  EXPECT_EQ(copy(Text::hint_take_cue_ball), "Cliquez sur la boule blanche pour viser.");
}

TEST(Words, NameTheButtonOfTheGamepadThatShoots) {
  for (const Language language : app::all_languages()) {
    Words words(language);
    words.take_hand(InputDevice::pad);
    for (const Text how :
         {Text::hint_take_cue_ball,  Text::hint_not_cue_ball, Text::hint_shoot,
          Text::hint_too_weak,       Text::hint_place,        Text::hint_take_projectile,
          Text::hint_not_projectile, Text::hint_throw,        Text::hint_pull,
          Text::hint_turn,           Text::hint_keys,         Text::hint_next,
          Text::hint_finish,         Text::nudge_pull,        Text::nudge_click,
          Text::nudge_turn,          Text::nudge_place,       Text::lesson_3,
          Text::ready_to_throw,      Text::next_offered,      Text::finish_offered}) {
      const std::string text = " " + words(how) + " ";
      EXPECT_TRUE(text.find(" A ") != std::string::npos || text.find(" A:") != std::string::npos)
          << text;
    }
    EXPECT_TRUE(words(Text::hint_replay).starts_with("Start")) << "not by keys";
  }
}

}  // namespace
