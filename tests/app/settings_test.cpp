#include "app/storage/settings.hpp"

#include <gtest/gtest.h>
#include <string>

namespace {

using app::AimWay;
using app::Breaks;
using app::KeptSettings;
using app::MemoryStore;
using app::Settings;

const std::string file = "settings.json";

std::optional<std::string> stored(app::Store& store, const std::string& name = file) {
  return store.load(name).value();
}

/// Nothing in it is the default.
Settings all_changed() {
  Settings settings;
  settings.language = app::Language::fr;
  settings.volume = 35;
  settings.mute = true;
  settings.reduced_motion = app::ReducedMotion::off;
  settings.screen_shake = true;
  settings.colours = app::Colours::high_contrast;
  settings.aiming = {app::PreviewLength::full, AimWay::turn};
  settings.hints = false;
  settings.taught = true;
  settings.names = {"Zoé", "Émile le 2ᵉ"};
  settings.breaks = Breaks::loser;
  settings.keep_turn = true;
  settings.seats = app::Seats::alone;
  settings.rack = games::billiards::Rack::quick;
  settings.touch_red = true;
  settings.opponent = 10;
  settings.match = app::BestOf::five;
  settings.hand = app::Steadiness::half;
  settings.go_on = true;
  settings.go_on_offered = true;
  settings.quick_rolling = false;
  // "next" and "pause" have changed places.
  settings.keys = app::KeyBindings::from_pairs(
                      {{"again", "z"}, {"next", "p"}, {"pause", "n"}, {"mute", "a"}, {"fast", "q"}})
                      .value();
  return settings;
}

TEST(Settings, AreTheDefaultsAtFirst) {
  MemoryStore store;
  const KeptSettings settings(store);
  EXPECT_EQ(settings.get(), Settings{});
  EXPECT_EQ(settings.trouble(), KeptSettings::Trouble::none);
  EXPECT_FALSE(stored(store)) << "nothing is saved before something is chosen";
}

TEST(Settings, AreSavedAfterEveryChange) {
  MemoryStore store;
  KeptSettings settings(store);
  Settings wanted;
  wanted.mute = true;
  settings.set(wanted);
  EXPECT_EQ(KeptSettings(store).get(), wanted);
  settings.set(all_changed());
  EXPECT_EQ(KeptSettings(store).get(), all_changed());
  EXPECT_EQ(*stored(store),
            "{\n  \"angry-balls-settings\": 1,\n  \"language\": \"fr\",\n  \"volume\": 35,\n"
            "  \"mute\": true,\n  \"reduced-motion\": \"off\",\n  \"screen-shake\": true,\n"
            "  \"colours\": \"high-contrast\",\n  \"aiming\": \"turn-then-power\",\n"
            "  \"preview\": \"full\",\n  \"hints\": false,\n  \"taught\": true,\n  \"names\": [\n  "
            "  \"Zoé\",\n"
            "    \"Émile le 2ᵉ\"\n  ],\n  \"breaks\": \"loser\",\n  \"keep-turn\": true,\n"
            "  \"players\": \"alone\",\n  \"rack\": \"quick\",\n  \"touch-red\": true,\n"
            "  \"opponent\": 10,\n  \"match\": \"5\",\n  \"hand\": \"0.5\",\n"
            "  \"go-on\": true,\n  \"go-on-offered\": true,\n  \"quick-rolling\": false,\n"
            "  \"keys\": {\n    \"again\": \"z\",\n    \"next\": \"p\",\n    \"pause\": \"n\",\n"
            "    \"fast\": \"q\",\n    \"mute\": \"a\",\n    \"hint\": \"h\"\n  }\n}\n");
}

TEST(Settings, AMissingKeyHasItsDefault) {
  MemoryStore store;
  ASSERT_TRUE(store.save(file, R"({"volume": 100, "angry-balls-settings": 1})"));
  Settings expected;
  expected.volume = 100;
  const KeptSettings settings(store);
  EXPECT_EQ(settings.get(), expected);
  EXPECT_EQ(settings.trouble(), KeptSettings::Trouble::none);
}

TEST(Settings, NamesAndVolumeAreMadeFit) {
  MemoryStore store;
  KeptSettings settings(store);
  Settings wild;
  wild.names = {"  Anna\n ", "\xff"};
  wild.volume = 1000;
  settings.set(wild);
  EXPECT_EQ(settings.get().names[0], "Anna");
  EXPECT_EQ(settings.get().names[1], "");
  EXPECT_EQ(settings.get().volume, 100);
  EXPECT_EQ(KeptSettings(store).get(), settings.get());
}

TEST(Settings, ANameHoldsOnlyCharactersThatCanBeShown) {
  EXPECT_EQ(app::name_of(""), "");
  EXPECT_EQ(app::name_of("   "), "");
  EXPECT_EQ(app::name_of(" a b "), "a b");
  EXPECT_EQ(app::name_of("a\tb\x7f\n\x01"), "ab");
  EXPECT_EQ(app::name_of("Zoé € 𝄞"), "Zoé € 𝄞");
  EXPECT_EQ(app::name_of("a\xff\xc3"
                         "b\xc0\x80\xed\xa0\x80\xf4\x90\x80\x80"
                         "c\xe2\x82"),
            "abc");
  EXPECT_EQ(app::name_of("a\xc2\x85"
                         "b\xe2\x80\xa8"
                         "c"),
            "abc")
      << "line ends of Unicode";
  EXPECT_EQ(app::name_of(" a  ", true), "a  ");
  std::string longest;
  for (int i = 0; i < 24; ++i) longest += "é";
  EXPECT_EQ(app::name_of(longest + "é"), longest);
  EXPECT_EQ(app::name_of("12345678901234567890123 5"), "12345678901234567890123");
}

TEST(Settings, ANameHasNothingThatSteersOtherTextOrCannotBeSeen) {
  EXPECT_EQ(app::name_of("a\u202eb\u2066c\u200ed\ufeffe\u00adf\u3164"), "abcdef");
  EXPECT_EQ(app::name_of("\u202e\u200b"), "");
  EXPECT_EQ(app::name_of("\U0001f469\u200d\U0001f680"), "\U0001f469\u200d\U0001f680")
      << "a joiner is part of a sign";
}

TEST(Settings, ANameOfAFileIsMadeFitAndCostsNoOtherSetting) {
  MemoryStore store;
  ASSERT_TRUE(store.save(file, R"({"angry-balls-settings": 1, "volume": 5,
      "names": [" a\u202eb\n", "1234567890123456789012345"]})"));
  const KeptSettings settings(store);
  EXPECT_EQ(settings.trouble(), KeptSettings::Trouble::none);
  EXPECT_EQ(settings.get().volume, 5);
  EXPECT_EQ(settings.get().names[0], "ab");
  EXPECT_EQ(settings.get().names[1], "123456789012345678901234");
}

class ForeignSettings : public testing::TestWithParam<const char*> {};

TEST_P(ForeignSettings, AreSetAsideAndNeverOverwritten) {
  MemoryStore store;
  ASSERT_TRUE(store.save(file, GetParam()));
  KeptSettings settings(store);
  EXPECT_EQ(settings.trouble(), KeptSettings::Trouble::set_aside);
  EXPECT_EQ(settings.get(), Settings{}) << "nothing is taken of it";
  EXPECT_FALSE(stored(store));
  settings.set(all_changed());
  EXPECT_EQ(stored(store, file + ".broken"), GetParam());
  EXPECT_EQ(KeptSettings(store).get(), all_changed());
}

INSTANTIATE_TEST_SUITE_P(
    All, ForeignSettings,
    testing::Values("", "{", "[]", "7", "{}", "null", R"({"volume": 10})",
                    R"({"angry-balls-settings": 2})", R"({"angry-balls-settings": 1.0})",
                    R"({"angry-balls-settings": "1"})", R"({"angry-balls-settings": true})",
                    R"({"angry-balls-settings": 1, "news": 1})",
                    R"({"angry-balls-settings": 1, "volume": 10, "language": "tlh"})",
                    R"({"angry-balls-settings": 1, "language": 1})",
                    R"({"angry-balls-settings": 1, "volume": 101})",
                    R"({"angry-balls-settings": 1, "volume": -1})",
                    R"({"angry-balls-settings": 1, "volume": 5.5})",
                    R"({"angry-balls-settings": 1, "volume": 18446744073709551615})",
                    R"({"angry-balls-settings": 1, "mute": 0})",
                    R"({"angry-balls-settings": 1, "opponent": 0})",
                    R"({"angry-balls-settings": 1, "opponent": 11})",
                    R"({"angry-balls-settings": 1, "match": 3})",
                    R"({"angry-balls-settings": 1, "hand": "3"})",
                    R"({"angry-balls-settings": 1, "hints": null})",
                    R"({"angry-balls-settings": 1, "names": "Anna"})",
                    R"({"angry-balls-settings": 1, "names": ["Anna"]})",
                    R"({"angry-balls-settings": 1, "names": ["Anna", "Bob", "Cem"]})",
                    R"({"angry-balls-settings": 1, "names": ["Anna", 2]})",
                    R"({"angry-balls-settings": 1, "breaks": "winner"})",
                    R"({"angry-balls-settings": 1, "keep-turn": "true"})",
                    R"({"angry-balls-settings": 1, "keys": "r"})",
                    R"({"angry-balls-settings": 1, "keys": [["again", "r"]]})",
                    R"({"angry-balls-settings": 1, "keys": {"again": 1}})",
                    R"({"angry-balls-settings": 1, "keys": {"jump": "a"}})",
                    R"({"angry-balls-settings": 1, "keys": {"again": "R"}})",
                    R"({"angry-balls-settings": 1, "volume": 5, "keys": {"again": "n"}})",
                    "{\"angry-balls-settings\": 1, \"names\": [\"\xff\", \"\"]}"));

TEST(Settings, ChangesOfAnotherProgramAreNotOverwritten) {
  MemoryStore store;
  KeptSettings settings(store);
  ASSERT_TRUE(store.save(file, "newer"));
  settings.set(all_changed());
  EXPECT_EQ(stored(store, file + ".broken"), "newer");
  EXPECT_EQ(KeptSettings(store).get(), all_changed());
}

/// A disk that refuses some things.
struct BadStore : MemoryStore {
  bool loads = true, saves = true, moves = true;
  carom::Result<std::optional<std::string>> load(const std::string& name) override {
    if (!loads) return carom::Error{.problem = "cannot be read"};
    return MemoryStore::load(name);
  }
  carom::Status save(const std::string& name, const std::string& text) override {
    if (!saves) return carom::Error{.problem = "cannot be written"};
    return MemoryStore::save(name, text);
  }
  carom::Status set_aside(const std::string& name) override {
    if (!moves) return carom::Error{.problem = "cannot be moved"};
    return MemoryStore::set_aside(name);
  }
};

TEST(Settings, LastUntilTheEndOnADiskThatCannotBeWritten) {
  BadStore store;
  KeptSettings settings(store);
  store.saves = false;
  settings.set(all_changed());
  EXPECT_EQ(settings.get(), all_changed());
  EXPECT_EQ(settings.trouble(), KeptSettings::Trouble::not_kept);
  store.saves = true;
  settings.set(all_changed());
  EXPECT_EQ(settings.trouble(), KeptSettings::Trouble::none);
}

TEST(Settings, AFileThatCannotBeReadOrMovedIsNotOverwritten) {
  for (const bool readable : {false, true}) {
    BadStore store;
    ASSERT_TRUE(store.save(file, "foreign"));
    store.loads = readable;
    store.moves = false;
    KeptSettings settings(store);
    settings.set(all_changed());
    EXPECT_EQ(settings.get(), all_changed());
    EXPECT_EQ(settings.trouble(), KeptSettings::Trouble::not_kept);
    store.loads = true;
    EXPECT_EQ(stored(store), "foreign");
  }
}

TEST(Breaks, AreGivenByTheSettingAndTheLastGame) {
  using app::first_player;
  const app::FinishedGame second_won{.first_player = 0, .winner = 1};
  const app::FinishedGame first_won{.first_player = 0, .winner = 0};
  const app::FinishedGame drawn{.first_player = 1, .winner = {}};
  for (const Breaks any : {Breaks::player_1, Breaks::alternate, Breaks::loser})
    EXPECT_EQ(first_player(any, {}), 0);
  EXPECT_EQ(first_player(Breaks::player_1, first_won), 0);
  EXPECT_EQ(first_player(Breaks::player_2, {}), 1);
  EXPECT_EQ(first_player(Breaks::player_2, second_won), 1);
  EXPECT_EQ(first_player(Breaks::alternate, second_won), 1);
  EXPECT_EQ(first_player(Breaks::alternate, drawn), 0);
  EXPECT_EQ(first_player(Breaks::loser, second_won), 0);
  EXPECT_EQ(first_player(Breaks::loser, first_won), 1);
  EXPECT_EQ(first_player(Breaks::loser, drawn), 0);
}

}  // namespace
