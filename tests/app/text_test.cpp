#include "app/text.hpp"

#include <gtest/gtest.h>

namespace {

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

TEST(Words, EveryTextInEveryLanguage) {
  for (const Language language : {Language::english, Language::french}) {
    for (int i = 0; i < static_cast<int>(Text::count); ++i) {
      const std::string text =
          Words(language)(static_cast<Text>(i), {"a", "b", "c", "d", "e", "f", "g"});
      EXPECT_FALSE(text.empty());
      EXPECT_EQ(text.find('{'), std::string::npos) << text;
    }
  }
}

}  // namespace
