#include "app/play/game_speed.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "app/app.hpp"
#include "app/screens/angry_balls_screen.hpp"
#include "app/screens/billiards_screen.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;
using app::nanoseconds;
namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;

constexpr nanoseconds frame = 16'666'667ns;

/// A level that one throw wins after 0.7 s.
carom::Scene one_enemy() {
  carom::Scene level;
  level.friction = 1;
  level.balls = {{.role = carom::Role::projectile, .position = {100, 200}},
                 {.role = carom::Role::enemy, .position = {820, 200}, .solidity = 10}};
  level.width = 1000;
  return level;
}

class GameSpeedTest : public testing::Test {
 protected:
  template <class Screen>
  static void key(Screen& screen, Key key) {
    screen.event(*app::KeyBindings{}.meaning(app::KeyPressed{key}));
  }
  app::BilliardsScreen table() {
    app::BilliardsRecorder recorder{billiards::Game()};
    EXPECT_TRUE(recorder.apply(billiards::Shoot{{300, 7}}).ok());
    app::BilliardsScreen screen(words, session, std::move(recorder));
    screen.resize(app::View::of(1280, 720));
    return screen;
  }
  app::AngryBallsScreen level() {
    app::LevelRecorder recorder{angry_balls::Game::create(one_enemy()).value()};
    EXPECT_TRUE(recorder.apply(angry_balls::Throw{{200, 0}}).ok());
    app::AngryBallsScreen screen(words, session, std::move(recorder));
    screen.resize(app::View::of(1280, 720));
    return screen;
  }

  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, app::shipped_levels()};
  app::Words words{app::Language::en};
};

TEST_F(GameSpeedTest, PauseAndFastForwardChangeNoBit) {
  auto plain = table();
  auto hurried = table();
  int frames = 0;
  for (; plain.game().phase() == billiards::Phase::roll; ++frames) plain.iterate(frame);
  int hurried_frames = 0;
  for (; hurried.game().phase() == billiards::Phase::roll; ++hurried_frames) {
    if (hurried_frames % 40 == 10) key(hurried, Key::f);
    if (hurried_frames % 40 == 30) hurried.event(app::CommandReleased{app::Command::fast});
    if (hurried_frames % 40 == 35) key(hurried, Key::p);
    if (hurried_frames % 40 == 39) key(hurried, Key::p);
    hurried.iterate(frame);
  }
  EXPECT_LT(hurried_frames, frames * 2 / 3);
  EXPECT_EQ(hurried.game().world().steps(), plain.game().world().steps());
  EXPECT_EQ(hurried.game().world().state_hash(), plain.game().world().state_hash());
}

TEST_F(GameSpeedTest, WhilePausedNothingMovesAndTheClickThatEndsItDoesNothingElse) {
  auto screen = table();
  screen.iterate(500ms);
  const auto steps = screen.game().world().steps();
  EXPECT_GT(steps, 0u);
  key(screen, Key::p);
  EXPECT_FALSE(screen.animating());
  EXPECT_NE(screen.describe().find("paused"), std::string::npos);
  screen.event(app::PointerMoved{{300, 300}});
  screen.event(app::CommandReleased{app::Command::pause});
  screen.iterate(5s);
  EXPECT_EQ(screen.game().world().steps(), steps);
  // The button below asks whether to leave.
  app::DrawList list;
  app::Atlas atlas;
  app::Font font{atlas};
  const app::View view = app::View::of(1280, 720);
  app::Canvas canvas{list, font, view};
  screen.draw(canvas);
  app::Point leave;
  for (const app::Box& box : list.boxes)
    if (box.text == "Leave") leave = box.area.center();
  screen.event(app::PointerMoved{leave});
  screen.event(app::PointerPressed{leave});
  screen.event(app::PointerReleased{leave});
  EXPECT_EQ(screen.describe().find("paused"), std::string::npos);
  EXPECT_TRUE(screen.animating());
  screen.iterate(20ms);
  EXPECT_EQ(screen.game().world().steps(), steps + 2);
}

TEST_F(GameSpeedTest, FastForwardIsFourStepsForOneAsLongAsTheKeyIsDown) {
  auto screen = table();
  screen.iterate(30ms);
  EXPECT_EQ(screen.game().world().steps(), 3u);
  key(screen, Key::f);
  screen.iterate(30ms);
  EXPECT_EQ(screen.game().world().steps(), 15u);
  screen.event(app::CommandReleased{app::Command::fast});
  screen.iterate(30ms);
  EXPECT_EQ(screen.game().world().steps(), 18u);
}

TEST_F(GameSpeedTest, AFingerHeldOnTheTableIsAsTheKey) {
  auto screen = table();
  const app::Point at{640, 360};
  const auto steps_of_next_30_ms = [&] {
    const auto before = screen.game().world().steps();
    screen.iterate(30ms);
    return screen.game().world().steps() - before;
  };
  screen.event(app::PointerPressed{at, app::PointerButton::left, true});
  EXPECT_EQ(steps_of_next_30_ms(), 3u) << "a tap is none";
  for (int i = 0; i < 8; ++i) screen.iterate(30ms);
  EXPECT_EQ(steps_of_next_30_ms(), 12u);
  screen.event(app::PointerReleased{at});
  EXPECT_EQ(steps_of_next_30_ms(), 3u);
  screen.event(app::PointerPressed{at, app::PointerButton::left, true});
  for (int i = 0; i < 10; ++i) screen.iterate(30ms);
  screen.event(app::PointerCancelled{});  // a second finger
  EXPECT_EQ(steps_of_next_30_ms(), 3u);
}

/// The finger that has just shot is not one that waits.
TEST_F(GameSpeedTest, ThePressThatShootsHurriesNothing) {
  app::BilliardsScreen screen(words, session);
  screen.resize(app::View::of(1280, 720));
  const app::Point cue = screen.viewport().to_window(billiards::cue_start);
  for (const app::Point at : {cue, cue + app::Point{100, 7}}) {
    screen.event(app::PointerMoved{at});
    screen.event(app::PointerPressed{at});
    if (at == cue) screen.event(app::PointerReleased{at});
  }
  ASSERT_EQ(screen.game().phase(), billiards::Phase::roll);
  for (int i = 0; i < 20; ++i) screen.iterate(30ms);
  EXPECT_EQ(screen.game().world().steps(), 60u);
}

TEST_F(GameSpeedTest, TheBreakOfTheLastEnemyPassesSlowly) {
  struct Shown {
    int frames = 0;
    int slow_frames = 0;  // with less than half a step
    std::uint64_t first_slow = 0;
    std::uint64_t won_at = 0;
    std::uint64_t hash = 0;
  };
  const auto watch = [&] {
    Shown shown;
    auto screen = level();
    std::uint64_t before = 0;
    int still = 0;
    while (screen.game().phase() == angry_balls::Phase::fly) {
      screen.iterate(10ms);
      ++shown.frames;
      const std::uint64_t steps = screen.game().world().steps();
      still = steps == before ? still + 1 : 0;
      if (still == 2 && shown.first_slow == 0) shown.first_slow = steps;
      shown.slow_frames += steps == before ? 1 : 0;
      before = steps;
    }
    EXPECT_EQ(screen.game().phase(), angry_balls::Phase::won);
    shown.won_at = screen.game().world().steps();
    shown.hash = screen.game().world().state_hash();
    return shown;
  };
  const Shown slowly = watch();
  app::Settings calm;
  calm.reduced_motion = app::ReducedMotion::on;
  session.settings.set(calm);
  const Shown plainly = watch();
  EXPECT_EQ(slowly.hash, plainly.hash);
  EXPECT_EQ(slowly.won_at, plainly.won_at);
  EXPECT_EQ(plainly.slow_frames, 0);
  EXPECT_EQ(static_cast<std::uint64_t>(plainly.frames), plainly.won_at);
  // It begins before the enemy breaks, and takes a frame of 10 ms for a quarter of a step.
  EXPECT_GE(slowly.first_slow + app::Foresight<angry_balls::Game>::steps, slowly.won_at);
  EXPECT_LT(slowly.first_slow + 15, slowly.won_at);
  EXPECT_GT(slowly.frames, plainly.frames + 60);
  EXPECT_LE(slowly.frames, plainly.frames + 150);
}

TEST_F(GameSpeedTest, ReducedMotionShowsNoTrailAndNothingThatFlies) {
  auto screen = level();
  const auto vertices = [&](bool calm) {
    app::DrawList list;
    app::Atlas atlas;
    app::Font font{atlas};
    const app::View view = app::View::of(1280, 720);
    app::Canvas canvas{list, font, view, calm};
    screen.draw(canvas);
    return list.vertices.size();
  };
  screen.iterate(80ms);
  ASSERT_EQ(screen.game().phase(), angry_balls::Phase::fly);
  EXPECT_LT(vertices(true), vertices(false)) << "a trail";
  while (screen.game().phase() == angry_balls::Phase::fly) screen.iterate(frame);
  for (int i = 0; i < 20; ++i) screen.iterate(frame);
  EXPECT_LT(vertices(true) + 50, vertices(false)) << "the pieces of the enemy";
}

TEST_F(GameSpeedTest, ThePictureShakesOnlyIfAllowedAndMotionIsNotReduced) {
  std::ifstream file(SOURCE_DIR "/tests/replays/level-01-won.json");
  const std::string json{std::istreambuf_iterator<char>(file), {}};
  app::App game(app::Language::en, 1280, 720, store, clipboard);
  EXPECT_FALSE(game.settings().get().screen_shake) << "not before the player allows it";
  game.watch(replay::read_replay(json).value());
  const auto broken = [&] {
    const auto sounds = game.take_sounds();
    return std::ranges::find(sounds, app::SoundKind::burst, &app::SoundEvent::kind) != sounds.end();
  };
  for (int i = 0; i < 1000 && !broken(); ++i) game.iterate(10ms);
  game.iterate(30ms);
  // The sky's corner.
  const auto corner = [&](bool shake, bool reduced) {
    app::Settings settings;
    settings.screen_shake = shake;
    settings.reduced_motion = reduced ? app::ReducedMotion::on : app::ReducedMotion::off;
    game.settings().set(settings);
    return game.draw().vertices.front().position;
  };
  EXPECT_NE(corner(true, false), corner(false, false));
  EXPECT_EQ(corner(true, true), corner(false, false));
}

TEST(GameSpeed, ADecisiveMomentIsSlowOncePerGameAndNotDuringFastForward) {
  app::GameSpeed pace;
  EXPECT_EQ(pace.pass(1s).quarters, 4);
  pace.decisive();
  EXPECT_EQ(pace.pass(1s).quarters, 1);
  EXPECT_EQ(pace.pass(500ms).quarters, 1);
  EXPECT_EQ(pace.pass(1ms).quarters, 4);
  pace.decisive();
  EXPECT_EQ(pace.pass(1ms).quarters, 4);
  pace.new_game();
  pace.decisive();
  EXPECT_TRUE(pace.event(app::CommandPressed{app::Command::fast}, true, true));
  EXPECT_EQ(pace.pass(1ms).quarters, 16);
  EXPECT_FALSE(pace.event(app::CommandReleased{app::Command::fast}, true, true));
  EXPECT_EQ(pace.pass(1ms).quarters, 1);
}

TEST(GameSpeed, UnderAWindowOnlyTheReleaseIsHeard) {
  app::GameSpeed pace;
  EXPECT_FALSE(pace.event(app::CommandPressed{app::Command::pause}, false, false));
  EXPECT_FALSE(pace.paused());
  EXPECT_TRUE(pace.event(app::CommandPressed{app::Command::fast}, true, true));
  pace.event(app::CommandReleased{app::Command::fast}, false, false);
  EXPECT_EQ(pace.pass(1ms).quarters, 4);
}

}  // namespace
