#include <map>

#include "app/player.hpp"

namespace {

using namespace std::chrono_literals;

const std::string sound = R"({"carom": 1, "width": 1000, "height": 500, "balls": [
  {"x": 100, "y": 12, "role": "projectile"},
  {"x": 300, "y": 12, "role": "enemy", "solidity": 10}]})";

std::vector<app::Level> own_levels(int count) {
  std::vector<app::Level> levels;
  for (int i = 0; i < count; ++i)
    levels.push_back(app::read_level("own-" + std::to_string(i) + ".json", sound));
  return levels;
}

TEST(LevelMenu, ShowsNumbersNamesAndLevelsNotWonYet) {
  Player game(app::Language::en, 1280, 720);
  game.press("Angry Balls");
  EXPECT_EQ(game.title(), "Angry Balls · level menu · 10 levels");
  EXPECT_TRUE(game.shows("First steps"));
  EXPECT_TRUE(game.shows("10"));
  EXPECT_TRUE(game.shows("Not won yet"));
  EXPECT_FALSE(game.app().animating());
}

TEST(LevelMenu, AClickStartsTheLevelAndEscapeComesBack) {
  Player game(app::Language::en, 1280, 720);
  game.press("Angry Balls");
  game.press("Two towers");
  EXPECT_TRUE(game.says("Level 2: Two towers")) << game.title();
  game.leave();
  EXPECT_TRUE(game.says("level menu"));
  game.key(app::Key::escape);
  EXPECT_TRUE(game.says("title screen"));
}

TEST(LevelMenu, ABrokenLevelTellsItsFirstErrorAndDoesNotStart) {
  Player game(app::Language::en, 1920, 1080,
              {app::read_level(
                  "bad.json",
                  std::string("{\"carom\": 1, \"height\": 5, \"balls\": [],\n \"width\": -3}"))});
  game.press("Angry Balls");
  EXPECT_TRUE(game.shows("bad.json:2:11:"));
  game.press("bad.json");
  EXPECT_TRUE(game.says("level menu"));
  EXPECT_TRUE(game.shows("Cannot be played: bad.json:2:11: /width"));
}

app::Box button(Player& game, std::string_view name) {
  for (const app::Box& box : game.boxes())
    if (box.kind == app::Box::Kind::button && box.text.find(name) != std::string::npos) return box;
  return {};
}

TEST(LevelMenu, TenLevelsStandInTwoFullRows) {
  for (const auto& [width, height] : {std::pair{800, 600},
                                      {1024, 768},
                                      {1280, 720},
                                      {1366, 768},
                                      {1600, 900},
                                      {1920, 1080},
                                      {2560, 1440},
                                      {3840, 2160}}) {
    Player game(app::Language::en, width, height);
    game.press("Angry Balls");
    std::map<float, int> rows;
    for (const app::Level& level : app::shipped_levels()) ++rows[button(game, level.name).area.y];
    ASSERT_EQ(rows.size(), 2U) << width;
    for (const auto& [y, count] : rows) EXPECT_EQ(count, 5) << width;
  }
}

TEST(LevelMenu, ALastRowThatIsNotFullStandsInTheMiddle) {
  Player game(app::Language::en, 800, 600, own_levels(1));
  game.press("Angry Balls");
  const auto level = [&](std::string_view name) { return button(game, name); };
  // Eleven in rows of four.
  const app::Rect ninth = level("The crown").area;
  const app::Rect last = level("own-0").area;
  EXPECT_GT(ninth.y, level("Sentinels").area.bottom());
  EXPECT_NEAR(ninth.x + last.right(), 800, 2);
  // Keys go by where they stand.
  game.key(app::Key::tab);
  for (int i = 0; i < 3; ++i) game.key(app::Key::right);
  for (int i = 0; i < 2; ++i) game.key(app::Key::down);
  EXPECT_TRUE(level("own-0").focused);
  game.key(app::Key::up);
  EXPECT_TRUE(level("The pit").focused || level("Sentinels").focused);
}

TEST(LevelMenu, ManyLevelsArePaged) {
  Player game(app::Language::en, 800, 600, own_levels(50));
  game.press("Angry Balls");
  EXPECT_TRUE(game.shows("Page 1 of "));
  EXPECT_FALSE(game.shows("own-49"));
  game.press("Previous");  // round to the last
  EXPECT_TRUE(game.shows("own-49"));
  game.press("own-49");
  EXPECT_TRUE(game.says("Level 60: “own-49” (your level)")) << game.title();
  game.leave();
  EXPECT_TRUE(game.shows("own-49")) << "the page of the level that was played";
  game.press("Next");
  EXPECT_TRUE(game.shows("First steps"));
}

TEST(LevelMenu, TheFocusStaysWherePagesAreTurnedAndPracticeIsSwitched) {
  Player game(app::Language::en, 800, 600, own_levels(50));
  game.press("Angry Balls");
  const auto focused = [&]() -> std::string {
    for (const app::Box& box : game.boxes())
      if (box.focused) return box.text;
    return {};
  };
  for (int i = 0; i < 3; ++i) game.key(app::Key::back_tab);
  ASSERT_EQ(focused(), "Next ›");
  for (int page = 2; page < 5; ++page) {
    game.key(app::Key::enter);
    EXPECT_TRUE(game.shows("Page " + std::to_string(page)));
    EXPECT_EQ(focused(), "Next ›");
  }
  game.key(app::Key::tab);
  game.key(app::Key::enter);
  EXPECT_EQ(focused(), "Practice: on");
}

TEST(LevelMenu, TheFocusStaysOnALevelInAWindowOfAnotherSize) {
  Player game(app::Language::en, 1280, 720);
  game.press("Angry Balls");
  for (int i = 0; i < 2; ++i) game.key(app::Key::tab);
  game.app().event(app::Resized{800, 600, 1});
  game.key(app::Key::enter);
  EXPECT_TRUE(game.says("Level 2")) << game.title();
}

TEST(LevelMenu, IsPlayedByKeysToo) {
  Player game(app::Language::en, 1280, 720);
  for (int i = 0; i < 4; ++i) game.key(app::Key::tab);
  game.key(app::Key::enter);
  game.key(app::Key::tab);
  game.key(app::Key::right);
  game.key(app::Key::enter);
  EXPECT_TRUE(game.says("Level 2")) << game.title();
}

TEST(LevelMenu, BestScoresOutliveTheApp) {
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  const auto play = [&](auto&& use) {
    app::App game(app::Language::en, 1280, 720, store, clipboard, own_levels(1));
    use(game);
  };
  const std::string identity = own_levels(1)[0].identity;
  app::BestScores(store).record(identity, 12300);
  play([](app::App& game) {
    for (const app::Key key :
         {app::Key::tab, app::Key::tab, app::Key::tab, app::Key::tab, app::Key::enter})
      game.event(app::KeyPressed{key});
    bool shown = false;
    for (const app::Box& box : game.draw().boxes) shown |= box.text == "Best: 12,300";
    EXPECT_TRUE(shown);
  });
}

TEST(LevelMenu, TellsOfScoresThatWereSetAside) {
  Player game(app::Language::en, 1280, 720);
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  ASSERT_TRUE(store.save("scores.json", "?"));
  app::App app(app::Language::en, 1280, 720, store, clipboard);
  for (const app::Key key :
       {app::Key::tab, app::Key::tab, app::Key::tab, app::Key::tab, app::Key::enter})
    app.event(app::KeyPressed{key});
  bool shown = false;
  for (const app::Box& box : app.draw().boxes)
    shown |= box.text.find("scores.json.broken") != std::string::npos;
  EXPECT_TRUE(shown);
}

}  // namespace
