#include <gtest/gtest.h>
#include <string>

#include "carom/scene_file.hpp"
#include "carom/state_bytes.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "games/launch.hpp"
#include "project_file.hpp"

namespace {

namespace ab = games::angry_balls;
namespace bi = games::billiards;

// All that a game tells.
bool same(const bi::Game& a, const bi::Game& b) {
  return a.world().state_hash() == b.world().state_hash() && a.options() == b.options() &&
         a.phase() == b.phase() && a.player() == b.player() && a.score(0) == b.score(0) &&
         a.score(1) == b.score(1) && a.tally(0) == b.tally(0) && a.tally(1) == b.tally(1) &&
         a.turn_balls() == b.turn_balls() && a.turn_points() == b.turn_points() &&
         a.save_state() == b.save_state();
}
bool same(const ab::Game& a, const ab::Game& b) {
  return a.world().state_hash() == b.world().state_hash() && a.phase() == b.phase() &&
         a.level() == b.level() && a.throws_left() == b.throws_left() && a.score() == b.score() &&
         a.turn_balls() == b.turn_balls() && a.save_state() == b.save_state();
}

template <class Game>
void expect_the_same_future(const Game& game) {
  auto loaded = Game::load_state(game.save_state());
  ASSERT_TRUE(loaded) << carom::to_string(loaded.errors().front());
  Game one = game;
  Game other = loaded.value();
  ASSERT_TRUE(same(one, other));
  for (int step = 0; step < 1000; ++step) {
    one.step();
    other.step();
  }
  ASSERT_TRUE(same(one, other));
}

ab::Game level(const char* name) {
  return ab::Game::create(ab::read_level(project_file(name)).value()).value();
}

TEST(GameState, ALoadedGameOfBilliardsGoesOnAsTheSavedOne) {
  bi::Game game({.first_player = 1, .keep_turn = true});
  expect_the_same_future(game);
  for (int turn = 0; turn < 4; ++turn) {
    ASSERT_TRUE(game.apply(bi::Shoot{{300, 17.0 * turn}}).ok());
    for (int step = 0; game.phase() == bi::Phase::roll; ++step) {
      if (step % 400 == 60) expect_the_same_future(game);
      game.step();
    }
    expect_the_same_future(game);
    if (game.phase() == bi::Phase::place) {
      for (double x = 20; game.phase() == bi::Phase::place; x += 7)
        (void)game.apply(bi::Place{{x, 300}}).ok();
    }
  }
}

TEST(GameState, ALoadedLevelGoesOnAsTheSavedOne) {
  ab::Game game = level("levels/03-pass-it-on.json");
  expect_the_same_future(game);
  while (game.throws_left() > 0 && game.phase() == ab::Phase::aim) {
    ASSERT_TRUE(game.apply(ab::Throw{{150, 60}}).ok());
    for (int step = 0; game.phase() == ab::Phase::fly; ++step) {
      if (step % 500 == 90) expect_the_same_future(game);
      game.step();
    }
    if (game.phase() == ab::Phase::offer) {
      expect_the_same_future(game);
      ASSERT_TRUE(game.apply(ab::Next{}).ok());
    }
  }
  expect_the_same_future(game);
}

TEST(GameState, ARestartAfterLoadingIsTheWholeGameAnew) {
  bi::Game game;
  ASSERT_TRUE(game.apply(bi::Shoot::at({1500, 40})).ok());
  for (int step = 0; step < 300; ++step) game.step();
  bi::Game loaded = bi::Game::load_state(game.save_state()).value();
  ASSERT_TRUE(loaded.apply(bi::Restart{}).ok());
  EXPECT_EQ(loaded.world().state_hash(), bi::Game().world().state_hash());
  EXPECT_EQ(loaded.world().steps(), 0U);
}

TEST(GameState, ChangedBytesAndOtherStatesAreRefused) {
  const ab::Game game = level("levels/01-first-steps.json");
  const std::string state = game.save_state();
  for (std::size_t i = 0; i < state.size(); i += 7) {
    std::string changed = state;
    changed[i] = static_cast<char>(changed[i] ^ 4);
    EXPECT_FALSE(ab::Game::load_state(changed)) << i;
  }
  EXPECT_FALSE(ab::Game::load_state(bi::Game().save_state()));
  EXPECT_FALSE(bi::Game::load_state(state));
  EXPECT_FALSE(carom::World::load_state(state));
  EXPECT_FALSE(ab::Game::load_state({}));
}

// The last numbers of a payload are the rules': one of them changed, sealed anew.
template <class Game>
bool takes(char kind, const Game& game, std::size_t from_end, char value) {
  std::string payload(carom::bytes::unseal(kind, game.save_state()).value());
  payload[payload.size() - 8 * from_end] = value;
  return Game::load_state(carom::bytes::seal(kind, payload)).ok();
}

TEST(GameState, NumbersThatNoGameHasAreRefused) {
  const ab::Game thrown = level("levels/01-first-steps.json");
  EXPECT_TRUE(takes('a', thrown, 3, 7)) << "a score";
  EXPECT_FALSE(takes('a', thrown, 5, 5)) << "a phase that is none";
  EXPECT_FALSE(takes('a', thrown, 5, 3)) << "won, with an enemy left";
  EXPECT_FALSE(takes('a', thrown, 5, 4)) << "lost, with a throw left";
  EXPECT_FALSE(takes('a', thrown, 4, 4)) << "more throws than the level has";
  EXPECT_FALSE(takes('a', thrown, 4, 0)) << "none to aim";
  const bi::Game table;
  EXPECT_TRUE(takes('b', table, 13, 7)) << "a score";
  EXPECT_FALSE(takes('b', table, 14, 2)) << "a third player";
  EXPECT_FALSE(takes('b', table, 15, 2)) << "placing a cue ball that is on the table";
  EXPECT_FALSE(takes('b', table, 15, 3)) << "over, with reds left";
  EXPECT_FALSE(takes('b', table, 18, 2)) << "a first player that is none";
}

TEST(LaunchDrag, GivesTheVelocityToTheLastBit) {
  for (double x = -1800; x <= 1800; x += 97.3) {
    const carom::Vec2 velocity{x, 300 - x / 4};
    const carom::Vec2 given = games::launch_velocity(games::launch_drag(velocity));
    EXPECT_DOUBLE_EQ(given.x, velocity.x);
    EXPECT_DOUBLE_EQ(given.y, velocity.y);
  }
  EXPECT_EQ(ab::Throw::at({500, -250}), (ab::Throw{{100, -50}}));
}

}  // namespace
