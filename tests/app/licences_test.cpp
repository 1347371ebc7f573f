// The licences in the help: every word of every text can be read, by keys and by buttons.

#include "licences/licences.hpp"

#include <set>
#include <sstream>

#include "player.hpp"

namespace {

using app::Key;

std::set<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

struct Licences : testing::Test {
  Licences() {
    game.key(Key::help);
    game.press("Licences");
    EXPECT_TRUE(game.says("Licences"));
  }
  std::string shown() {
    std::string text;
    for (const app::Box& box : game.boxes())
      if (box.kind == app::Box::Kind::text) text += box.text + "\n";
    return text;
  }
  Player game{app::Language::en, 800, 600};
};

TEST_F(Licences, EveryWordIsOnOneOfThePages) {
  std::set<std::string> words = words_of(licences::text);
  ASSERT_GT(words.size(), 500u);
  std::erase_if(words, [](const std::string& word) { return word.size() > 60; });  // rules, broken
  std::string last;
  for (std::string page = shown(); page != last; page = shown()) {
    for (const std::string& word : words_of(page)) words.erase(word);
    last = std::move(page);
    game.key(Key::right);
  }
  EXPECT_TRUE(words.empty()) << words.size() << " words, of them " << *words.begin();
}

TEST_F(Licences, KeysWheelAndButtonsMoveTheText) {
  const std::string first = shown();
  for (const auto& [there, back] : {std::pair{Key::down, Key::up}, {Key::right, Key::left}}) {
    game.key(there);
    EXPECT_NE(shown(), first);
    game.key(back);
    EXPECT_EQ(shown(), first);
    game.key(back);
    EXPECT_EQ(shown(), first) << "before the first line";
  }
  game.app().event(app::WheelTurned{-1});
  EXPECT_NE(shown(), first);
  game.app().event(app::WheelTurned{1});
  EXPECT_EQ(shown(), first);
  game.press("›");
  EXPECT_TRUE(game.shows("Page 2"));
  game.press("‹");
  EXPECT_EQ(shown(), first);
  game.press("Back");
  EXPECT_TRUE(game.says("Help"));
}

TEST_F(Licences, TheLineOnTopStaysThereWhenTheWindowChanges) {
  for (int i = 0; i < 10; ++i) game.key(Key::right);
  const std::string before = shown();
  game.app().event(app::Resized{390, 844});
  game.app().event(app::Resized{800, 600});
  EXPECT_EQ(shown(), before);
}

}  // namespace
