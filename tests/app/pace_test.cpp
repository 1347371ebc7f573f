// The pace: rolling that is quickened and skipped, the next throw that comes by itself, and what
// both save.

#include <cstdio>
#include <gtest/gtest.h>

#include "app/play/clock.hpp"
#include "app/play/game_speed.hpp"
#include "app/play/runout.hpp"
#include "app/play/stillness.hpp"
#include "app/player.hpp"
#include "app/screens/angry_balls_screen.hpp"
#include "app/screens/billiards_screen.hpp"
#include "project_file.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;

namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;

constexpr app::nanoseconds frame = 16'666'667ns;

/// Looks until the answer is there.
bool still(const carom::World& world) {
  app::Stillness stillness;
  for (int i = 0; i <= app::Stillness::horizon / app::Stillness::slice; ++i) stillness.look(world);
  return stillness.still();
}

carom::World world(std::vector<carom::Ball> balls, double gravity = 0) {
  carom::Scene scene;
  scene.gravity = gravity;
  scene.balls = std::move(balls);
  return carom::World::create(scene).value();
}

TEST(Stillness, IsTrueOnlyIfNothingMovesByAPixelNorIsLost) {
  EXPECT_TRUE(still(world({{.position = {100, 100}}})));
  // 0.9 and 1.1 px to the end, at a friction of 0.995 a step.
  EXPECT_TRUE(still(world({{.position = {100, 100}, .velocity = {0.45, 0}}})));
  EXPECT_FALSE(still(world({{.position = {100, 100}, .velocity = {0.55, 0}}})));
  EXPECT_FALSE(still(world({{.position = {100, 100}}}, 600))) << "it falls";
  EXPECT_TRUE(still(world({{.position = {100, 10}}}, 600))) << "it lies";
}

TEST(Stillness, LooksAgainAsTheWorldGoesOn) {
  carom::World ball = world({{.position = {100, 100}, .velocity = {50, 0}}});
  app::Stillness stillness;
  int steps = 0;
  for (; !stillness.still() && steps < 3000; ++steps) {
    stillness.look(ball);
    ball.step();
  }
  EXPECT_GT(steps, 500) << "50 px/s become 0.5";
  EXPECT_LT(steps, 1100);
}

/// A shot that ends slowly, by itself.
billiards::Game shot(carom::Vec2 drag) {
  billiards::Game game;
  EXPECT_TRUE(game.apply(billiards::Shoot{drag}));
  return game;
}

TEST(Runout, IsQuietWhenAllIsSlowAndNothingMeetsAnyMore) {
  for (const carom::Vec2 drag : {carom::Vec2{-40, 3}, {300, 20}}) {
    billiards::Game game = shot(drag);
    app::Runout<billiards::Game> runout;
    std::uint64_t quiet_at = 0;
    while (game.phase() == billiards::Phase::roll) {
      runout.look(game);
      if (runout.quiet() && quiet_at == 0) {
        quiet_at = game.world().steps();
        for (std::size_t i = 0; i < game.world().size(); ++i)
          EXPECT_LE(carom::length(game.world().ball(i).velocity), 80);
      }
      game.step();
      EXPECT_TRUE(quiet_at == 0 || game.physics_events().empty());
    }
    EXPECT_GT(quiet_at, 0U) << drag.x;
    EXPECT_LT(quiet_at, game.world().steps()) << drag.x;
  }
}

TEST(GameSpeed, GrowsGentlyWhereNothingMoreWillHappen) {
  app::GameSpeed speed;
  speed.ease(true);
  int before = 4;
  for (int i = 0; i < 60; ++i) {
    const int now = speed.pass(frame).quarters;
    EXPECT_GE(now, before);
    EXPECT_LE(now, before + 1);
    before = now;
  }
  EXPECT_EQ(before, app::GameSpeed::eased_quarters);
  speed.ease(false);
  EXPECT_EQ(speed.pass(frame).quarters, 4);
}

class Pace : public testing::Test {
 protected:
  const app::BilliardsScreen& table() {
    return dynamic_cast<const app::BilliardsScreen&>(game.app().screen());
  }
  const app::AngryBallsScreen& level() {
    return dynamic_cast<const app::AngryBallsScreen&>(game.app().screen());
  }
  void set(bool app::Settings::*member, bool value) {
    app::Settings settings = game.app().settings().get();
    settings.*member = value;
    game.app().settings().set(settings);
  }
  void shoot() {
    const app::Point cue = game.app().screen().aim_prompt()->at;
    game.click(cue);
    game.click(cue - app::Point{60, 5});
    ASSERT_TRUE(game.says("watches"));
  }
  /// Seconds until the other player is on; the hash then.
  std::pair<double, std::uint64_t> watch() {
    int frames = 0;
    while (table().game().phase() == billiards::Phase::roll && ++frames < 5000)
      game.app().iterate(frame);
    return {frames / 60.0, table().game().world().state_hash()};
  }
  /// A throw that breaks nothing, up to where the next one is offered.
  void throw_away() {
    const app::Point ball = game.app().screen().aim_prompt()->at;
    game.click(ball);
    game.click(ball + app::Point{-30, 0});
    ASSERT_EQ(level().game().phase(), angry_balls::Phase::fly);
    for (int i = 0; i < 5000 && level().game().phase() == angry_balls::Phase::fly; ++i)
      game.app().iterate(frame);
    ASSERT_EQ(level().game().phase(), angry_balls::Phase::offer);
  }
  void rest_until_nothing_can_change() {
    for (int i = 0; i < 60; ++i) game.app().iterate(frame);
  }

  app::MemoryStore store;
  Player game{app::Language::en, 1280, 720, {}, store};
};

TEST_F(Pace, RollingIsQuickenedAndComesToTheSameBits) {
  std::array<std::pair<double, std::uint64_t>, 2> watched;
  for (const bool quick : {false, true}) {
    set(&app::Settings::quick_rolling, quick);
    game.press("Billiards");
    shoot();
    watched[quick ? 1 : 0] = watch();
    game.leave();
  }
  EXPECT_EQ(watched[1].second, watched[0].second);
  EXPECT_LT(watched[1].first, watched[0].first - 0.5);
}

TEST_F(Pace, AKeyOrATapSkipsToTheEndAndOnlyWhereNothingMoreHappens) {
  game.press("Billiards");
  shoot();
  const auto [seconds, hash] = watch();
  for (const bool by_key : {true, false}) {
    game.leave();
    game.press("Billiards");
    shoot();
    game.key(Key::space);
    EXPECT_TRUE(game.says("watches")) << "it is quick yet";
    for (int i = 0; i < 2000 && !game.shows("Nothing more will happen"); ++i)
      game.app().iterate(frame);
    ASSERT_TRUE(game.says("watches"));
    if (by_key)
      game.key(Key::space);
    else
      game.click({640, 300});
    EXPECT_TRUE(game.says("Player 2 aims")) << game.title();
    EXPECT_EQ(table().game().world().state_hash(), hash);
  }
}

TEST_F(Pace, TheNextThrowComesByItselfIfThatIsWanted) {
  set(&app::Settings::go_on, true);
  game.press("Angry Balls");
  game.press("First steps");
  for (int left = 2; left >= 0; --left) {
    throw_away();
    const std::string offered = game.title();
    int frames = 0;
    while (game.title() == offered && ++frames < 600) game.app().iterate(frame);
    EXPECT_GE(frames, 90) << "1.5 s";
    EXPECT_LT(frames, 400);
    EXPECT_TRUE(left == 0 || level().game().throws_left() == left);
  }
  EXPECT_TRUE(game.says("Level lost")) << game.title();
}

TEST_F(Pace, NothingComesByItselfAtFirst) {
  game.press("Angry Balls");
  game.press("First steps");
  throw_away();
  for (int i = 0; i < 1000; ++i) game.app().iterate(frame);
  EXPECT_EQ(level().game().phase(), angry_balls::Phase::offer);
}

TEST_F(Pace, AfterThreeNeedlessClicksAPlayerIsAskedOnce) {
  game.press("Angry Balls");
  for (const bool again : {false, true}) {
    game.press("First steps");
    for (int i = 0; i < 2; ++i) {
      throw_away();
      rest_until_nothing_can_change();
      EXPECT_FALSE(game.says("Go on by itself?"));
      game.key(Key::n);
    }
    if (again) break;
    throw_away();
    game.leave();
    game.press("First steps");
    throw_away();
    rest_until_nothing_can_change();
    game.key(Key::n);
    ASSERT_TRUE(game.says("Go on by itself?")) << game.title();
    game.press("No");
    EXPECT_FALSE(game.app().settings().get().go_on);
    EXPECT_TRUE(game.app().settings().get().go_on_offered);
    game.leave();
  }
  EXPECT_FALSE(game.says("Go on by itself?"));
}

TEST_F(Pace, AYesIsKept) {
  game.press("Angry Balls");
  for (int i = 0; i < 3; ++i) {
    game.press("First steps");
    throw_away();
    rest_until_nothing_can_change();
    game.key(Key::n);
    if (i < 2) game.leave();
  }
  ASSERT_TRUE(game.says("Go on by itself?")) << game.title();
  game.press("Yes");
  EXPECT_TRUE(game.app().settings().get().go_on);
}

TEST_F(Pace, ClicksBeforeAllIsStillAreNotNeedless) {
  game.press("Angry Balls");
  for (int i = 0; i < 4; ++i) {
    game.press("First steps");
    throw_away();
    game.key(Key::n);
    EXPECT_FALSE(game.says("Go on by itself?"));
    game.leave();
  }
}

/// What a game takes that goes as recorded, at 60 pictures a second, without the time for aiming.
template <class Game>
double seconds_of_rolling(Game& game, bool quick) {
  app::Runout<Game> runout;
  app::GameSpeed speed;
  app::Clock clock;
  const auto phase = game.phase();
  int frames = 0;
  for (; game.phase() == phase; ++frames) {
    if (quick) runout.look(game);
    speed.ease(runout.quiet());
    for (int due = clock.advance(frame, speed.pass(frame)); due > 0 && game.phase() == phase; --due)
      game.step();
  }
  return frames / 60.0;
}

TEST(PaceTable, SecondsAndClicksOfAWonGameAndALostLevel) {
  const auto whole =
      replay::read_replay(project_file("tests/replays/billiards-whole.json")).value();
  std::array<double, 2> table{};
  int shots = 0;
  for (const bool quick : {false, true}) {
    billiards::Game game(whole.options);
    shots = 0;
    for (const replay::Move& move : whole.moves) {
      if (const auto* shoot = std::get_if<billiards::Shoot>(&move.command)) {
        ASSERT_TRUE(game.apply(*shoot));
        ++shots;
        table[quick ? 1 : 0] += seconds_of_rolling(game, quick);
      } else {
        ASSERT_TRUE(game.apply(std::get<billiards::Place>(move.command)));
      }
    }
    ASSERT_EQ(game.phase(), billiards::Phase::over);
  }
  std::printf("a won game of %d shots: %.0f s before, %.0f s now\n", shots, table[0], table[1]);
  EXPECT_LT(table[1], table[0] * 0.95);

  // Three throws that hit nothing.
  const carom::Scene scene =
      angry_balls::read_level(project_file("levels/01-first-steps.json")).value();
  std::array<double, 3> level{};  // a click at once; quick; by itself
  std::array<int, 3> clicks{};
  for (int way = 0; way < 3; ++way) {
    auto& seconds = level[static_cast<std::size_t>(way)];
    auto game = angry_balls::Game::create(scene).value();
    for (const carom::Vec2 drag : {carom::Vec2{-60, 10}, {-60, 30}, {-30, 0}}) {
      ASSERT_TRUE(game.apply(angry_balls::Throw{drag}));
      seconds += seconds_of_rolling(game, way > 0);
      if (game.phase() != angry_balls::Phase::offer) break;
      if (way == 2) {
        app::Stillness stillness;
        for (int frames = 0; frames < 60'000 && !stillness.still(); ++frames) {
          stillness.look(game.world());
          for (int step = 0; step < (frames % 3 == 0 ? 1 : 2); ++step) game.step();
          seconds += 1 / 60.0;
        }
        seconds += 1.5;
      } else {
        ++clicks[static_cast<std::size_t>(way)];
      }
      ASSERT_TRUE(game.apply(angry_balls::Next{}));
    }
    EXPECT_EQ(game.phase(), angry_balls::Phase::lost);
  }
  std::printf(
      "a lost level: %.1f s, %d clicks before; %.1f s, %d clicks now; %.1f s, %d clicks by "
      "itself\n",
      level[0], clicks[0], level[1], clicks[1], level[2], clicks[2]);
  EXPECT_LE(level[1], level[0]);
  EXPECT_EQ(clicks[2], 0);
}

}  // namespace
