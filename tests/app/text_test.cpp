#include "app/text/text.hpp"

#include <gtest/gtest.h>

namespace {

using app::InputDevice;
using app::Language;
using app::Text;
using app::Words;

TEST(Words, LanguageOfTheLocale) {
  EXPECT_EQ(app::language_of_locale("fr_FR.UTF-8"), Language::french);
  EXPECT_EQ(app::language_of_locale("fr"), Language::french);
  EXPECT_EQ(app::language_of_locale("en_GB"), Language::english);
  EXPECT_EQ(app::language_of_locale("C"), Language::english);
  EXPECT_EQ(app::language_of_locale(""), Language::english);
}

TEST(Words, NumbersAreGroupedAsTheLanguageDoes) {
  const Words english(Language::english);
  const Words french(Language::french);
  EXPECT_EQ(english.number(0), "0");
  EXPECT_EQ(english.number(999), "999");
  EXPECT_EQ(english.number(1000), "1,000");
  EXPECT_EQ(english.number(1234567), "1,234,567");
  EXPECT_EQ(english.number(-1000), "-1,000");
  EXPECT_EQ(english.number(-100), "-100");
  EXPECT_EQ(french.number(12300), "12\u202f300");
}

TEST(Words, DecimalsAreWrittenAsTheLanguageDoes) {
  EXPECT_EQ(Words(Language::english).tenths(1234.56), "1,234.6");
  EXPECT_EQ(Words(Language::french).tenths(1234.56), "1\u202f234,6");
  EXPECT_EQ(Words(Language::french).tenths(-0.25), "−0,3");
}

TEST(Words, CopiesSpeakAlike) {
  Words one(Language::english);
  const Words copy = one;
  one.speak(Language::french);
  one.name_players({"", "Zoé"});
  EXPECT_EQ(copy(Text::quit), "Quitter");
  EXPECT_EQ(copy.number(1000), "1\u202f000");
  EXPECT_EQ(copy.player(0), "Joueur 1");
  EXPECT_EQ(copy.player(1), "Zoé");
  EXPECT_EQ(Words(Language::french).player(1), "Joueur 2") << "another one's names are its own";
}

TEST(Words, ShippedLevelsHaveFrenchNames) {
  EXPECT_EQ(Words(Language::french).level_name("First steps"), "Premiers pas");
  EXPECT_EQ(Words(Language::english).level_name("First steps"), "First steps");
  EXPECT_EQ(Words(Language::french).level_name("My own"), "My own");
}

TEST(Words, EveryTextInEveryLanguageForEveryHand) {
  for (const Language language : {Language::english, Language::french}) {
    for (const InputDevice hand : {InputDevice::mouse, InputDevice::finger, InputDevice::pad}) {
      for (int i = 0; i < static_cast<int>(Text::count); ++i) {
        Words words(language);
        words.take_hand(hand);
        const std::string text = words(static_cast<Text>(i), {"a", "b", "c", "d", "e", "f", "g"});
        EXPECT_FALSE(text.empty());
        EXPECT_EQ(text.find_first_of("{}[]|"), std::string::npos) << text;
        EXPECT_EQ(text.find("  "), std::string::npos) << text;
        const Text what = static_cast<Text>(i);
        const bool of_the_mouse = what == Text::help_mouse || what == Text::way_clicks;
        if (hand == InputDevice::mouse || of_the_mouse) continue;
        for (const char* const mouse : {"lick", "liqu", "clic"})
          EXPECT_EQ(text.find(mouse), std::string::npos) << text;
      }
    }
  }
}

TEST(Words, TellWhatTheHandDoes) {
  Words words(Language::english);
  EXPECT_EQ(words(Text::hint_shoot), "Click where to send it. Esc or right click: take it back.");
  EXPECT_EQ(words(Text::next_throw, {"N"}), "Next throw (N)");
  const Words copy = words;
  words.take_hand(InputDevice::finger);
  EXPECT_EQ(copy(Text::hint_shoot), "Tap where to send it. Two fingers: take it back.");
  EXPECT_EQ(copy(Text::next_throw, {"N"}), "Next throw");
  EXPECT_EQ(copy(Text::way_clicks), "Two taps");
  words.speak(Language::french);
  EXPECT_EQ(copy(Text::hint_take_cue_ball), "Touchez la boule blanche pour viser.");
  words.take_hand(InputDevice::mouse);
  EXPECT_EQ(copy(Text::hint_take_cue_ball), "Cliquez sur la boule blanche pour viser.");
}

TEST(Words, NameTheButtonOfTheGamepadThatShoots) {
  for (const Language language : {Language::english, Language::french}) {
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
