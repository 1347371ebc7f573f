#include "platform/null_platform.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace {

using platform::NullPlatform;

constexpr const char* one_shot = R"({"at": 0.5, "key": "Return"}
{"at": 1, "click": [418, 379]}
{"at": 1.5, "click": [780, 420]}
{"at": 1.87, "move": [3, 3]}
)";

constexpr const char* one_throw = R"({"at": 0.5, "click": [221, 483]}
{"at": 1, "click": [138, 190]}
{"at": 1.5, "click": [231, 494]}
{"at": 2, "click": [393, 509]}
{"at": 2.8, "move": [3, 3]}
)";

struct Played : NullPlatform {
  explicit Played(const char* script, app::Language language = app::Language::en)
      : NullPlatform(language, 1280, 720) {
    const auto parsed = platform::parse_script(script);
    EXPECT_TRUE(parsed);
    EXPECT_TRUE(run(parsed.value()));
  }
};

TEST(NullPlatform, SameScriptSamePicture) {
  Played one(one_shot);
  Played two(one_shot);
  EXPECT_EQ(one.app().describe(), two.app().describe());
  const app::Image picture = one.picture();
  EXPECT_EQ(picture.pixels, two.picture().pixels);
  EXPECT_EQ(picture.pixels, one.picture().pixels);
}

TEST(NullPlatform, SameThrowSamePicture) {
  Played one(one_throw);
  Played two(one_throw);
  EXPECT_NE(one.app().describe().find("watching the throw · score: 100"), std::string::npos)
      << one.app().describe();
  EXPECT_EQ(one.picture().pixels, two.picture().pixels);
}

TEST(NullPlatform, DescribesTheScreen) {
  EXPECT_EQ(Played("").app().describe(), "Angry Balls · title screen");
  EXPECT_EQ(Played(one_shot).app().describe(),
            "Angry Balls · Player 1 watches the shot · Player 1: 0 · Player 2: 0 · balls left: 36");
  EXPECT_EQ(Played("{\"at\":1,\"key\":\"Return\"}", app::Language::fr).app().describe(),
            "Angry Balls · Joueur 1 vise · Joueur 1 : 0 · Joueur 2 : 0 · boules restantes : 36");
}

TEST(NullPlatform, PrintsTheScreenAndKeepsGamesInAStore) {
  app::MemoryStore store;
  NullPlatform game(app::Language::en, 1280, 720, {}, store);
  const auto script =
      platform::parse_script(std::string(one_shot) + R"({"at": 30, "print": true})");
  ASSERT_TRUE(script);
  std::vector<std::string> printed;
  ASSERT_TRUE(game.run(script.value(), [&](const std::string& line) { printed.push_back(line); }));
  EXPECT_EQ(printed, std::vector{game.app().describe()});
  EXPECT_TRUE(store.load("continue-billiards-0001.json").value());
}

TEST(NullPlatform, EscapeOpensThePauseMenuAndClosesIt) {
  Played game(R"({"at": 0.5, "key": "Return"}
{"at": 1, "key": "Escape"})");
  EXPECT_TRUE(game.app().describe().starts_with("Angry Balls · paused")) << game.app().describe();
  game.app().event(app::KeyPressed{app::Key::escape});
  EXPECT_TRUE(game.app().describe().starts_with("Angry Balls · Player 1 aims"))
      << game.app().describe();
  EXPECT_FALSE(game.app().quit_requested());
}

TEST(NullPlatform, EscapeOnTheTitleQuits) {
  Played game(R"({"at": 0.5, "key": "Escape"})");
  EXPECT_TRUE(game.app().quit_requested());
}

std::string demonstration(const std::string& name) {
  std::ifstream file(SOURCE_DIR "/demos/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(NullPlatform, TheDemonstrationOfAngryBallsWinsTwoLevels) {
  Played game(demonstration("angry-balls.jsonl").c_str());
  EXPECT_NE(game.app().describe().find("Level 2: Two towers · Level won!"), std::string::npos)
      << game.app().describe();
}

TEST(NullPlatform, TheDemonstrationPlaysThreeTurns) {
  Played game(demonstration("billiards.jsonl").c_str());
  EXPECT_TRUE(game.app().animating());
  EXPECT_NE(game.app().describe().find("Player 1 watches the shot"), std::string::npos)
      << game.app().describe();
}

TEST(NullPlatform, NothingMovesOnTheTitle) { EXPECT_FALSE(Played("").app().animating()); }

TEST(NullPlatform, APictureThatCannotBeWrittenIsAnError) {
  NullPlatform game(app::Language::en, 200, 200);
  EXPECT_FALSE(game.screenshot("/nonexistent/folder/a.png"));
}

}  // namespace
