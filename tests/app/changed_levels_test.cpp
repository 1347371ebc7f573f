#include "app/player.hpp"
#include "app/storage/level.hpp"

namespace {

/// A level file of the player's with an enemy at x.
app::Level level(const std::string& file, int x) {
  return app::read_level(
      file, R"({"carom": 1, "name": "Mine", "width": 600, "height": 300, "gravity": 600, "balls": [
              {"x": 100, "y": 12, "role": "projectile"}, {"x": )" +
                std::to_string(x) + R"(, "y": 12, "role": "enemy", "solidity": 900}]})");
}

struct ChangedLevels : testing::Test {
  Player game{app::Language::en, 1280, 720, {level("a.json", 300), level("b.json", 400)}};

  void play(std::string_view number) {
    game.press("Angry Balls");
    game.press(number);
    ASSERT_TRUE(game.says("Level")) << game.title();
  }
  void take(std::vector<app::Level> levels) { game.app().take_levels(std::move(levels)); }
};

TEST_F(ChangedLevels, TheOneInPlay_BeginsAnew) {
  play("12");
  ASSERT_TRUE(game.says("Level 12")) << game.title();
  take({level("a.json", 300), level("b.json", 450)});
  EXPECT_TRUE(game.says("Level 12")) << game.title();
  EXPECT_TRUE(game.shows("Level read again"));
}

TEST_F(ChangedLevels, AnotherThanTheOneInPlay_DoesNotDisturbIt) {
  play("12");
  game.key(app::Key::escape);
  const std::string before = game.title();
  take({level("a.json", 310), level("b.json", 400)});
  EXPECT_EQ(game.title(), before) << "the pause menu stays";
  EXPECT_FALSE(game.shows("Level read again"));
}

TEST_F(ChangedLevels, ABrokenOne_IsToldAndThePlayGoesOn_UntilItIsMended) {
  play("12");
  take({level("a.json", 300), app::read_level("b.json", std::string("{"))});
  EXPECT_TRUE(game.shows("b.json:1:2"));
  EXPECT_TRUE(game.says("Mine")) << game.title();
  take({level("a.json", 300), level("b.json", 500)});
  EXPECT_TRUE(game.shows("Level read again"));
  EXPECT_TRUE(game.says("Level 12")) << game.title();
  game.leave();
  EXPECT_TRUE(game.says("12 levels")) << game.title();
}

TEST_F(ChangedLevels, OneThatIsGone_IsPlayedToItsEnd) {
  play("12");
  take({level("a.json", 300)});
  EXPECT_TRUE(game.says("Mine")) << game.title();
}

TEST_F(ChangedLevels, TheMenuShowsNewOnes) {
  game.press("Angry Balls");
  take({level("a.json", 300), level("b.json", 400), level("c.json", 500)});
  EXPECT_TRUE(game.says("13 levels")) << game.title();
}

TEST_F(ChangedLevels, OneOpenedMeanwhile_StaysOnce) {
  const std::string opened =
      R"({"carom": 1, "name": "Opened", "width": 600, "height": 300, "gravity": 600, "balls": [
        {"x": 100, "y": 12, "role": "projectile"}, {"x": 410, "y": 12, "role": "enemy"}]})";
  game.app().open_file("opened.json", opened);
  take({level("a.json", 300), level("b.json", 400)});
  EXPECT_TRUE(game.says("Opened")) << game.title();
  take({level("a.json", 300), level("b.json", 400), app::read_level("0123.angry-level", opened)});
  EXPECT_TRUE(game.says("Opened")) << game.title();
  game.leave();
  EXPECT_TRUE(game.says("13 levels")) << game.title();
}

}  // namespace
