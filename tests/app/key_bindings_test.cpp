#include "app/input/key_bindings.hpp"

#include <gtest/gtest.h>

#include "app/player.hpp"

namespace {

using app::Command;
using app::Key;
using app::KeyBindings;

TEST(KeyBindings, ALetterDoesOneThing) {
  KeyBindings keys;
  EXPECT_EQ(keys.command_of(Key::r), Command::again);
  EXPECT_EQ(keys.command_of(Key::q), std::nullopt);
  EXPECT_EQ(keys.command_of(Key::m), Command::mute);
  EXPECT_FALSE(keys.bind(Command::again, Key::n)) << "taken";
  for (const Key fixed : {Key::enter, Key::left, Key::escape, Key::tab, Key::help, Key::plus})
    EXPECT_FALSE(keys.bind(Command::again, fixed));
  EXPECT_EQ(keys, KeyBindings());
  ASSERT_TRUE(keys.bind(Command::again, Key::q));
  EXPECT_EQ(keys.command_of(Key::q), Command::again);
  EXPECT_EQ(keys.command_of(Key::r), std::nullopt);
  EXPECT_EQ(keys.command_of(Key::up), std::nullopt);
  EXPECT_TRUE(keys.bind(Command::again, Key::q)) << "again the same";
}

TEST(KeyBindings, AScreenGetsCommandsForLettersAndAllElseAsItIs) {
  KeyBindings keys;
  EXPECT_TRUE(app::is_command(*keys.meaning(app::KeyPressed{Key::p}), Command::pause));
  EXPECT_EQ(std::get<app::CommandReleased>(*keys.meaning(app::KeyReleased{Key::f})).command,
            Command::fast);
  EXPECT_FALSE(keys.meaning(app::KeyPressed{Key::q}));
  EXPECT_TRUE(app::is_key(*keys.meaning(app::KeyPressed{Key::up}), Key::up));
  EXPECT_TRUE(std::holds_alternative<app::WheelTurned>(*keys.meaning(app::WheelTurned{1})));
}

TEST(KeyBindings, AreWrittenAndRead) {
  KeyBindings keys;
  ASSERT_TRUE(keys.bind(Command::again, Key::z));
  ASSERT_TRUE(keys.bind(Command::next, Key::r));
  const auto read = KeyBindings::from_pairs(keys.to_pairs());
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value(), keys);
  EXPECT_EQ(KeyBindings::from_pairs({}).value(), KeyBindings());
  EXPECT_TRUE(KeyBindings::from_pairs({{"again", "n"}, {"next", "r"}})) << "places changed";
  const auto older = KeyBindings::from_pairs({{"again", "h"}, {"next", "a"}});
  ASSERT_TRUE(older) << "a file that does not know the newest command";
  EXPECT_EQ(older.value().key_of(Command::hint), Key::b);
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  for (const Pairs& wrong : {Pairs{{"again", "n"}}, Pairs{{"again", "a"}, {"again", "b"}},
                             Pairs{{"jump", "a"}}, Pairs{{"next", "A"}}, Pairs{{"next", ""}},
                             Pairs{{"next", "ab"}}, Pairs{{"again", "x"}, {"next", "x"}}})
    EXPECT_FALSE(KeyBindings::from_pairs(wrong));
}

TEST(Keyboard, NamesKeysByTheirPrint) {
  app::Keyboard keyboard;
  EXPECT_EQ(keyboard.name(Command::again), "R");
  keyboard.label = [](Key key) { return key == Key::r ? "Ř" : ""; };
  EXPECT_EQ(keyboard.name(Command::again), "Ř");
  EXPECT_EQ(keyboard.name(Command::next), "N");
}

class KeysTest : public testing::Test {
 protected:
  void type(std::string_view text) { game.app().event(app::TextTyped{std::string(text)}); }
  Player game{app::Language::en, 800, 600};
};

TEST_F(KeysTest, HelpIsThereAnywhereAndGoesByAnyOfItsWays) {
  for (const bool in_game : {false, true}) {
    if (in_game) game.key(Key::enter);
    const std::string before = game.title();
    type("?");
    EXPECT_TRUE(game.says("Help"));
    type("?");
    EXPECT_EQ(game.title(), before);
    game.key(Key::help);
    EXPECT_TRUE(game.says("Help"));
    game.key(Key::escape);
    EXPECT_EQ(game.title(), before);
    game.key(Key::help);
    game.click({400, 300});
    EXPECT_EQ(game.title(), before);
    game.app().event(app::PadPressed{app::PadButton::y});
    EXPECT_TRUE(game.says("Help"));
    game.app().event(app::PadPressed{app::PadButton::b});
    EXPECT_EQ(game.title(), before);
  }
}

TEST_F(KeysTest, HelpIsReadByKeysAlone) {
  for (const bool several : {false, true}) {
    Player reader(app::Language::en, several ? 800 : 1280, several ? 600 : 720);
    reader.key(Key::help);
    EXPECT_EQ(reader.shows("Page 1"), several);
    if (several) {
      reader.key(Key::right);
      EXPECT_TRUE(reader.shows("Page 2"));
      reader.key(Key::tab);
      reader.key(Key::enter);
      EXPECT_TRUE(reader.shows("Page 1"));
      reader.key(Key::tab);
    }
    reader.key(Key::tab);
    reader.key(Key::enter);
    EXPECT_TRUE(reader.says("Keys")) << "no button that is not there has the focus";
    reader.key(Key::escape);
    reader.key(Key::tab);
    reader.key(Key::enter);
    EXPECT_TRUE(reader.says("title screen"));
  }
}

TEST_F(KeysTest, TheGameWaitsWhileHelpIsRead) {
  game.key(Key::enter);
  game.key(Key::enter);
  game.key(Key::enter);
  ASSERT_TRUE(game.says("watches"));
  game.key(Key::help);
  EXPECT_FALSE(game.app().animating());
  game.pass(std::chrono::seconds{100});
  game.key(Key::escape);
  EXPECT_TRUE(game.says("watches"));
}

TEST_F(KeysTest, ACommandIsPutOnAnotherLetter) {
  game.key(Key::help);
  game.press("Keys…");
  EXPECT_TRUE(game.says("Keys"));
  game.press("Restart, ");
  EXPECT_TRUE(game.shows("press a letter"));
  game.key(Key::tab);
  EXPECT_TRUE(game.shows("Only letters"));
  game.key(Key::n);
  EXPECT_TRUE(game.shows("taken"));
  game.key(Key::q);
  EXPECT_TRUE(game.shows("repeat: Q"));
  game.key(Key::escape);
  EXPECT_TRUE(game.shows("Q"));
  game.key(Key::escape);

  game.key(Key::enter);
  for (int i = 0; i < 2; ++i) game.key(Key::enter);
  game.pass(std::chrono::milliseconds{100});
  game.key(Key::r);
  EXPECT_TRUE(game.says("watches")) << "R does nothing any more";
  game.key(Key::q);
  EXPECT_TRUE(game.says("Restart?"));
  game.key(Key::escape);

  game.key(Key::help);
  game.press("Keys…");
  game.press("Defaults");
  EXPECT_TRUE(game.shows("repeat: R"));
}

TEST(KeptKeys, AreThereAtTheNextStart) {
  app::MemoryStore store;
  const auto again_on = [](Player& game) {
    game.key(Key::help);
    game.press("Keys…");
    return game.shows("repeat: Q") ? 'q' : game.shows("repeat: R") ? 'r' : '?';
  };
  {
    Player game(app::Language::en, 800, 600, {}, store);
    ASSERT_EQ(again_on(game), 'r');
    EXPECT_FALSE(store.load(app::settings_file).value()) << "nothing is changed yet";
    game.press("Restart, ");
    game.key(Key::q);
  }
  Player game(app::Language::en, 800, 600, {}, store);
  game.app().settings().set(game.app().settings().get());
  EXPECT_EQ(again_on(game), 'q') << "and other settings leave it alone";
  game.key(Key::escape);
  game.key(Key::escape);
  for (int i = 0; i < 3; ++i) game.key(Key::enter);
  game.pass(std::chrono::milliseconds{100});
  game.key(Key::q);
  EXPECT_TRUE(game.says("Restart?"));
  game.key(Key::escape);
  game.key(Key::help);
  game.press("Keys…");
  game.press("Defaults");
  Player last(app::Language::en, 800, 600, {}, store);
  EXPECT_EQ(again_on(last), 'r');
}

TEST_F(KeysTest, LabelsAreThoseOfThePlayersKeyboard) {
  game.app().name_keys([](Key key) { return key == Key::n ? "Й" : ""; });
  game.key(Key::help);
  EXPECT_TRUE(game.shows("Й"));
}

TEST_F(KeysTest, ButtonsTellWhatTheyDo) {
  EXPECT_FALSE(game.shows("A game for two"));
  game.key(Key::tab);
  EXPECT_TRUE(game.shows("A game for two"));
  game.key(Key::tab);
  EXPECT_TRUE(game.shows("house rules"));
  game.key(Key::tab);
  EXPECT_TRUE(game.shows("shots can be undone"));
  game.app().event(app::PointerMoved{{1, 1}});
  game.key(Key::enter);
  ASSERT_TRUE(game.says("practice"));
  EXPECT_FALSE(game.shows("Leaves the game"));
  for (const app::Box& box : game.boxes())
    if (box.text == "Leave") game.app().event(app::PointerMoved{box.area.center()});
  EXPECT_TRUE(game.shows("Leaves the game"));
  game.key(Key::help);
  EXPECT_FALSE(game.shows("Leaves the game")) << "what lies beneath tells nothing";
}

TEST_F(KeysTest, BeginnersAreTaughtUntilTheyDoSomething) {
  game.app().teach_beginners();
  EXPECT_FALSE(game.shows("Set the strength"));
  game.key(Key::enter);
  game.pass(std::chrono::milliseconds{600});
  EXPECT_TRUE(game.shows("Set the strength"));
  EXPECT_FALSE(game.shows("Player 1 to play")) << "the lesson would cover it";
  game.app().event(app::PointerMoved{{300, 300}});
  EXPECT_TRUE(game.shows("Set the strength"));
  game.key(Key::left);
  EXPECT_FALSE(game.shows("Set the strength"));
  EXPECT_TRUE(game.shows("°")) << "and what was done counts";

  app::MemoryStore store;
  ASSERT_TRUE(store.save("replays/a.json", "{}"));
  Player knows(app::Language::en, 800, 600, {}, store);
  knows.app().teach_beginners();
  knows.key(Key::enter);
  knows.pass(std::chrono::milliseconds{600});
  EXPECT_FALSE(knows.shows("Set the strength"));
  EXPECT_TRUE(knows.shows("Player 1 to play"));
}

TEST_F(KeysTest, TheLessonIsNotRepeatedAtTheNextStart) {
  app::MemoryStore store;
  for (const bool first : {true, false}) {
    Player starts(app::Language::en, 800, 600, {}, store);
    starts.app().teach_beginners();
    starts.key(Key::enter);
    EXPECT_EQ(starts.shows("Set the strength"), first);
    starts.key(Key::left);
  }
}

TEST_F(KeysTest, APlayerWhoDoesNothingGetsAHint) {
  using std::chrono::seconds;
  game.app().rest(seconds{25});
  EXPECT_FALSE(game.shows("Your turn")) << "there is no ball";
  game.key(Key::enter);
  game.pass(seconds{3});
  game.app().rest(seconds{16});
  EXPECT_FALSE(game.shows("Your turn"));
  EXPECT_FALSE(game.app().animating());
  game.app().rest(seconds{1});
  EXPECT_TRUE(game.shows("Your turn"));
  EXPECT_TRUE(game.app().animating());
  game.pass(seconds{4});
  EXPECT_TRUE(game.shows("Your turn"));
  EXPECT_FALSE(game.app().animating()) << "an idle window rests";
  game.key(Key::left);
  EXPECT_FALSE(game.shows("Your turn"));
}

}  // namespace
