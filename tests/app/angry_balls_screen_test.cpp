#include "app/screens/angry_balls_screen.hpp"

#include <filesystem>
#include <fstream>

#include "app/player.hpp"
#include "app/staged.hpp"
#include "app/view/level_view.hpp"

namespace {

using namespace std::chrono_literals;
using games::angry_balls::Phase;

/// A window in which a level of 1000 × 500 px is shown pixel by pixel: drags are exact.
constexpr int width = 1000;
constexpr int height = 720;

carom::Scene small_level() {
  carom::Scene scene;
  scene.name = "Small";
  scene.width = 1000;
  scene.height = 500;
  scene.edges = {.left = carom::Edge::open, .right = carom::Edge::open, .top = carom::Edge::open};
  scene.gravity = 600;
  scene.damage_threshold = 400;
  scene.balls = {
      {.role = carom::Role::projectile, .position = {100, 12}, .radius = 12},
      {.role = carom::Role::enemy, .position = {300, 12}, .radius = 12, .solidity = 1000},
      {.role = carom::Role::enemy, .position = {900, 12}, .radius = 12, .solidity = 1000}};
  return scene;
}

class AngryBallsScreenTest : public testing::Test {
 protected:
  AngryBallsScreenTest() {
    for (const char* identity : {"00000000000000aa", "00000000000000bb"})
      campaign.levels.push_back({"Small", small_level(), {}, identity});
    start();
  }
  void start() {
    screen =
        std::make_unique<Staged<app::AngryBallsScreen>>(app::Words(app::Language::en), session);
    screen->resize(view);
  }
  app::Navigation click(app::Point at, app::PointerButton button = app::PointerButton::left) {
    screen->event(app::PointerMoved{at});
    screen->event(app::PointerPressed{at, button});
    return screen->event(app::PointerReleased{at, button});
  }
  app::Navigation key(app::Key key) {
    return screen->event(*app::KeyBindings{}.meaning(app::KeyPressed{key}));
  }
  app::Point launch() const { return screen->viewport().to_window({100, 12}); }
  void throw_by(float x, float y) {
    click(launch());
    click(launch() + app::Point{x, -y});
  }
  void pass(std::chrono::nanoseconds time) {
    for (; time > 0ns; time -= 10ms) screen->iterate(10ms);
  }
  void until(Phase phase) {
    for (int i = 0; i < 4000 && screen->game().phase() != phase; ++i) screen->iterate(10ms);
    ASSERT_EQ(screen->game().phase(), phase);
  }
  void win() {
    throw_by(380, 0);
    until(Phase::won);
    pass(2s);
  }
  app::DrawList picture() {
    app::DrawList list;
    app::Canvas canvas{list, font, view};
    screen->draw(canvas);
    return list;
  }
  bool shows(std::string_view text) {
    for (const app::Box& box : picture().boxes)
      if (box.text.find(text) != std::string::npos) return true;
    return false;
  }
  app::Navigation press(std::string_view text) {
    app::Rect area;
    for (const app::Box& box : picture().boxes)
      if (box.kind == app::Box::Kind::button && box.text == text) area = box.area;
    EXPECT_GT(area.w, 0) << "no button " << text;
    return click(area.center());
  }

  app::View view = app::View::of(width, height);
  app::Atlas atlas;
  app::Font font{atlas};
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, {}};
  app::Campaign& campaign = session.campaign;
  std::unique_ptr<Staged<app::AngryBallsScreen>> screen;
};

TEST_F(AngryBallsScreenTest, TwoClicksThrowExactly) {
  EXPECT_EQ(screen->viewport().scale(), 1);
  click(launch());
  EXPECT_EQ(screen->game().phase(), Phase::aim);
  screen->event(app::PointerMoved{launch() + app::Point{100, -50}});
  EXPECT_TRUE(shows("28.0%"));
  click(launch() + app::Point{100, -50});
  EXPECT_EQ(screen->game().phase(), Phase::fly);
  EXPECT_EQ(screen->game().world().ball(0).velocity, (carom::Vec2{500, 250}));
}

TEST_F(AngryBallsScreenTest, OnlyAClickOnTheProjectileTakesIt) {
  app::Settings settings;
  settings.aiming.way = app::AimWay::pull;
  session.settings.set(settings);
  click(launch() + app::Point{200, -200});
  EXPECT_TRUE(shows("Click the angry ball first."));
  click(launch() + app::Point{300, -200});
  EXPECT_EQ(screen->game().phase(), Phase::aim);
}

TEST_F(AngryBallsScreenTest, EscapeAndRightClickTakeTheFirstClickBack) {
  click(launch());
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  click(launch() + app::Point{100, -50});
  EXPECT_EQ(screen->game().phase(), Phase::aim);
  click(launch());
  click(launch(), app::PointerButton::right);
  click(launch() + app::Point{100, -50});
  EXPECT_EQ(screen->game().phase(), Phase::aim);
}

TEST_F(AngryBallsScreenTest, ADoubleClickLosesNoThrow) {
  click(launch());
  click(launch());
  EXPECT_EQ(screen->game().throws_left(), 3);
  EXPECT_TRUE(shows("Too weak"));
}

TEST_F(AngryBallsScreenTest, TheNextThrowIsOfferedAndTaken) {
  throw_by(20, 0);
  EXPECT_FALSE(shows("Next throw"));
  click(launch() + app::Point{100, -100});  // while it flies, clicks do nothing
  until(Phase::offer);
  EXPECT_TRUE(shows("Next throw (N)"));
  const auto steps = screen->game().world().steps();
  pass(100ms);
  EXPECT_GT(screen->game().world().steps(), steps) << "the level goes on meanwhile";
  click(launch() + app::Point{200, -200});
  EXPECT_EQ(screen->game().phase(), Phase::aim);
  EXPECT_EQ(screen->game().world().ball(0).position, (carom::Vec2{100, 12}));
  EXPECT_EQ(screen->game().throws_left(), 2);
}

TEST_F(AngryBallsScreenTest, KeysTakeTheNextThrow) {
  app::Key keys[] = {app::Key::n, app::Key::space};
  for (const app::Key next : keys) {
    throw_by(-60, 0);
    until(Phase::offer);
    key(next);
    EXPECT_EQ(screen->game().phase(), Phase::aim);
  }
}

TEST_F(AngryBallsScreenTest, LeftAloneForAnHourItStandsStillAndIsStillKept) {
  app::LevelRecorder recorder(games::angry_balls::Game::create(small_level()).value());
  ASSERT_TRUE(recorder.apply(games::angry_balls::Throw{{-60, 0}}));
  while (recorder.game().phase() != Phase::offer) recorder.step();
  replay::Replay played = recorder.replay();
  played.moves.back().steps = replay::max_move_steps - 5;  // as if it had waited for so long
  const auto steps = recorder.game().world().steps();
  screen = std::make_unique<Staged<app::AngryBallsScreen>>(
      app::Words(app::Language::en), session, app::LevelRecorder(recorder.game(), played));
  screen->resize(view);
  pass(30ms);
  EXPECT_TRUE(screen->animating());
  pass(5s);
  EXPECT_FALSE(screen->animating());
  EXPECT_EQ(screen->game().world().steps(), steps + 5);
  key(app::Key::n);
  EXPECT_EQ(screen->game().phase(), Phase::aim);
  const auto kept = session.kept.latest();
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->game.moves.size(), 2U);
  EXPECT_EQ(kept->game.moves[0].steps, replay::max_move_steps);
}

TEST_F(AngryBallsScreenTest, PointsAreShownWhereTheyAreMade) {
  throw_by(150, 0);
  for (int i = 0; i < 300 && screen->game().score() == 0; ++i) screen->iterate(10ms);
  ASSERT_EQ(screen->game().score(), 100);
  pass(100ms);
  int points = 0;
  for (const app::Box& box : picture().boxes) points += box.text == "+100" ? 1 : 0;
  EXPECT_EQ(points, 2) << "once in the bar, once in the level";
}

TEST_F(AngryBallsScreenTest, LostAfterThreeThrows) {
  for (int i = 0; i < 3; ++i) {
    throw_by(-60, 0);
    until(Phase::offer);
    if (i == 2) {
      EXPECT_TRUE(shows("End of the level (N)"));
    }
    key(app::Key::enter);
  }
  EXPECT_EQ(screen->game().phase(), Phase::lost);
  EXPECT_TRUE(shows("Level lost"));
  EXPECT_TRUE(shows("Enemies left: 2"));
  EXPECT_FALSE(shows("Next level"));
  EXPECT_FALSE(campaign.best.of("00000000000000aa"));
  press("Restart");
  EXPECT_EQ(screen->game().phase(), Phase::aim);
  EXPECT_EQ(screen->game().throws_left(), 3);
}

TEST_F(AngryBallsScreenTest, WonAsSoonAsNoEnemyIsLeft) {
  throw_by(380, 0);
  until(Phase::won);
  EXPECT_FALSE(shows("Level won!")) << "first one sees it happen";
  EXPECT_EQ(campaign.best.of("00000000000000aa"), 300);
  pass(2s);
  EXPECT_TRUE(shows("Level won!"));
  EXPECT_TRUE(shows("300"));
  EXPECT_TRUE(shows("A new best score!"));
  while (screen->animating()) screen->iterate(10ms);
  press("Restart");
  win();
  EXPECT_TRUE(shows("Best: 300"));
  const app::Navigation next = press("Next level");
  ASSERT_TRUE(asks_for<app::PlayLevel>(next));
  EXPECT_EQ(std::get<app::PlayLevel>(next).level, 1u);
}

TEST_F(AngryBallsScreenTest, AfterTheLastLevelThereIsNoNext) {
  campaign.current = 1;
  start();
  win();
  EXPECT_FALSE(shows("Next level"));
  EXPECT_TRUE(asks_for<app::ShowLevels>(press("Menu")));
}

TEST_F(AngryBallsScreenTest, TheNextLevelIsOneThatCanBePlayed) {
  campaign.levels.insert(campaign.levels.begin() + 1,
                         {"bad", carom::Error{.problem = "is bad"}, "is bad", {}});
  start();
  win();
  const app::Navigation next = key(app::Key::enter);
  ASSERT_TRUE(asks_for<app::PlayLevel>(next));
  EXPECT_EQ(std::get<app::PlayLevel>(next).level, 2u);
}

TEST_F(AngryBallsScreenTest, EscapeLeavesTheFocusThenPauses) {
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  EXPECT_TRUE(asks_for<app::ShowLevels>(press("Leave")));
  throw_by(20, 10);
  pass(50ms);
  key(app::Key::tab);
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  const auto steps = screen->game().world().steps();
  pass(50ms);
  EXPECT_GT(screen->game().world().steps(), steps) << "only the focus is gone";
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  const auto there = screen->game().world().steps();
  pass(50ms);
  EXPECT_EQ(screen->game().world().steps(), there) << "it waits";
  EXPECT_TRUE(asks_for<app::ShowLevels>(press("Leave")));
  EXPECT_TRUE(asks_for<app::ShowLevels>(press("Menu")));
}

TEST_F(AngryBallsScreenTest, RestartStartsTheLevelAgainAfterAQuestion) {
  key(app::Key::r);
  EXPECT_FALSE(shows("Restart?")) << "nothing would be lost";
  throw_by(150, 0);
  pass(1s);
  key(app::Key::r);
  EXPECT_TRUE(shows("Restart?"));
  EXPECT_EQ(screen->game().throws_left(), 2);
  press("Keep playing");
  EXPECT_EQ(screen->game().throws_left(), 2);
  key(app::Key::r);
  key(app::Key::enter);
  EXPECT_EQ(screen->game().throws_left(), 3);
  EXPECT_EQ(screen->game().world().steps(), 0u);
  throw_by(20, 10);
  pass(50ms);
  press("Restart");
  press("New game");
  EXPECT_EQ(screen->game().throws_left(), 3);
}

TEST_F(AngryBallsScreenTest, TheSameThrowWhateverTheFrameRate) {
  const auto hash_after = [&](std::chrono::nanoseconds frame) {
    start();
    throw_by(150, 40);
    while (screen->game().phase() == Phase::fly) screen->iterate(frame);
    return screen->game().score();
  };
  EXPECT_EQ(hash_after(16'666'667ns), hash_after(4'166'667ns));
  EXPECT_EQ(hash_after(500ms), hash_after(10ms));
}

TEST_F(AngryBallsScreenTest, ABallAboveTheOpenTopIsMarked) {
  throw_by(1, 400);
  pass(100ms);
  const auto high = [&] { return screen->game().world().ball(0).position.y > 700; };
  for (int i = 0; i < 200 && !high(); ++i) screen->iterate(10ms);
  ASSERT_TRUE(high());
  // Something of the marker's colour lies at the top edge.
  const app::GameLayout layout = app::GameLayout::of(view);
  bool marked = false;
  for (const app::Vertex& vertex : picture().vertices)
    marked |= vertex.color == app::rgb(0xf7e3a4) && vertex.position.y > layout.world.y &&
              vertex.position.y < layout.world.y + 60 && std::abs(vertex.position.x - 100) < 60;
  EXPECT_TRUE(marked);
}

std::vector<std::filesystem::path> recorded_throws() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/tests/levels/original"))
    if (entry.path().extension() == ".throws") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class ShippedLevel : public testing::TestWithParam<std::size_t> {};

TEST_P(ShippedLevel, IsWonByClicks) {
  const auto files = recorded_throws();
  const app::Level level = app::shipped_levels()[GetParam()];
  const app::Viewport viewport = app::level_viewport(
      app::GameLayout::of(app::View::of(width, height)).world, level.scene.value());
  ASSERT_EQ(viewport.scale(), 1) << "the window does not show this level pixel by pixel";

  Player game(app::Language::en, width, height);
  game.press("Angry Balls");
  ASSERT_TRUE(game.says("level menu"));
  game.press(level.name);
  ASSERT_TRUE(game.says(level.name)) << game.title();
  std::ifstream throws(files[GetParam()]);
  for (carom::Vec2 drag; throws >> drag.x >> drag.y;) {
    if (game.says("click for the next throw")) game.key(app::Key::n);
    const app::Point launch = viewport.to_window(level.scene.value().balls[0].position);
    game.click(launch);
    game.click(launch + app::Point{static_cast<float>(drag.x), -static_cast<float>(drag.y)});
    for (int i = 0; i < 4000 && game.says("watching the throw"); ++i) game.pass(10ms);
  }
  EXPECT_TRUE(game.says("Level won!")) << game.title();
  game.pass(2s);
  game.press("Menu");
  EXPECT_TRUE(game.shows("Best: "));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLevel,
                         testing::Range(std::size_t{0}, recorded_throws().size()),
                         [](const auto& test) {
                           std::string name = recorded_throws()[test.param].stem().string();
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
