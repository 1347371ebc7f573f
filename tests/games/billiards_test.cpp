#include "games/billiards.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <random>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/world.hpp"

namespace {

using carom::Vec2;
using games::billiards::EventKind;
using games::billiards::Game;
using games::billiards::Obstruction;
using games::billiards::Options;
using games::billiards::Phase;
using games::billiards::Place;
using games::billiards::Rack;
using games::billiards::Restart;
using games::billiards::Shoot;
using games::billiards::Tally;

/// Runs a turn to its end and returns its events.
std::vector<games::billiards::Event> roll(Game& game) {
  std::vector<games::billiards::Event> all;
  while (game.phase() == Phase::roll) {
    game.step();
    all.insert(all.end(), game.events().begin(), game.events().end());
  }
  return all;
}

/// A player without a plan: any direction, any strength, any free place. Repeatable.
class RandomPlayer {
 public:
  explicit RandomPlayer(std::uint32_t seed) : random_(seed) {}

  void command(Game& game) {
    if (game.phase() == Phase::aim) {
      ASSERT_TRUE(game.apply(Shoot{{uniform(-400, 400), uniform(-400, 400)}}));
    } else if (game.phase() == Phase::place) {
      Vec2 position;
      do position = {uniform(0, 800), uniform(0, 400)};
      while (game.obstruction(position) != Obstruction::none);
      ASSERT_TRUE(game.apply(Place{position}));
    }
  }

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }

 private:
  std::mt19937 random_;
};

// Spec §7.
TEST(Rack, IsTheTriangleOfTheReport) {
  const carom::Scene scene = games::billiards::rack();
  ASSERT_EQ(scene.balls.size(), 37U);
  EXPECT_EQ(scene.balls[0].position, (Vec2{200, 200}));
  EXPECT_EQ(scene.balls[0].role, carom::Role::cue);
  EXPECT_EQ(scene.balls[0].radius, 8);
  EXPECT_EQ(scene.balls[1].position, (Vec2{540, 200}));
  EXPECT_EQ(scene.holes.size(), 6U);
  int touching = 0;
  for (std::size_t i = 1; i < 37; ++i) {
    for (std::size_t j = i + 1; j < 37; ++j) {
      const double distance = carom::length(scene.balls[j].position - scene.balls[i].position);
      EXPECT_GE(distance, 20) << i << ' ' << j << " overlap";
      if (distance <= 1.02 * 20) {
        ++touching;
        EXPECT_NEAR(distance, 1.01 * 20, 1e-9);
      }
    }
  }
  EXPECT_EQ(touching, 3 * 28) << "a triangle of 8 rows has 84 contacts";
}

TEST(Rack, EqualsTheStartOfTheShippedBreak) {
  std::ifstream file(SOURCE_DIR "/scenes/break.json", std::ios::binary);
  const std::string json(std::istreambuf_iterator<char>(file), {});
  carom::Scene shipped = carom::read_scene(json).value();
  EXPECT_GT(carom::length(shipped.balls[0].velocity), 1000);
  shipped.name = "Billiards";
  shipped.balls[0].velocity = {};
  EXPECT_EQ(shipped, games::billiards::rack());
}

TEST(Billiards, StartsWithTheFirstPlayerToAim) {
  const Game game;
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.player(), 0);
  EXPECT_EQ(game.reds_left(), 36);
  EXPECT_EQ(game.score(0), 0);
  EXPECT_EQ(game.score(1), 0);
  EXPECT_FALSE(game.winner());
}

TEST(Billiards, RefusesCommandsThatThePhaseDoesNotAllow) {
  Game game;
  const auto untouched = game.world().state_hash();
  EXPECT_FALSE(game.apply(Shoot{{0, 0}}));
  EXPECT_FALSE(game.apply(Shoot{{std::numeric_limits<double>::quiet_NaN(), 0}}));
  EXPECT_FALSE(game.apply(Shoot{{std::numeric_limits<double>::infinity(), 0}}));
  EXPECT_FALSE(game.apply(Place{{100, 100}}));
  EXPECT_EQ(game.world().state_hash(), untouched);
  EXPECT_EQ(game.phase(), Phase::aim);
  ASSERT_TRUE(game.apply(Shoot{{10, 0}}));
  EXPECT_FALSE(game.apply(Shoot{{10, 0}}));
  EXPECT_EQ(game.phase(), Phase::roll);
}

TEST(Billiards, StepDoesNothingWhileWaiting) {
  Game game;
  game.step();
  EXPECT_EQ(game.world().steps(), 0U);
}

TEST(Billiards, TurnsAlternateWhenAllStand) {
  Game game;
  ASSERT_TRUE(game.apply(Shoot{{-10, 3}}));
  const auto events = roll(game);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::turn);
  EXPECT_EQ(events[0].player, 1);
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.player(), 1);
  for (std::size_t i = 0; i < game.world().size(); ++i)
    EXPECT_EQ(game.world().ball(i).velocity, (Vec2{})) << "all speeds become zero";
}

/// Shoots the cue ball straight into the corner hole at the origin.
void pocket_the_cue_ball(Game& game) {
  ASSERT_TRUE(game.apply(Shoot{Vec2{10, 10} - games::billiards::cue_start}));
  const auto events = roll(game);
  ASSERT_EQ(game.phase(), Phase::place);
  ASSERT_EQ(events[0].kind, EventKind::cue_pocketed);
  ASSERT_EQ(events[0].player, 0);
  ASSERT_EQ(events[1].kind, EventKind::turn);
}

TEST(Billiards, TheNextPlayerPlacesAPocketedCueBall) {
  Game game;
  pocket_the_cue_ball(game);
  EXPECT_EQ(game.player(), 1);
  EXPECT_EQ(game.reds_left(), 36);
  EXPECT_FALSE(game.apply(Shoot{{10, 0}})) << "there is nothing to shoot";

  EXPECT_EQ(game.obstruction({540, 200}), Obstruction::ball);
  EXPECT_EQ(game.obstruction({10, 10}), Obstruction::hole);
  EXPECT_EQ(game.obstruction({400, 33}), Obstruction::hole);
  EXPECT_EQ(game.obstruction({400, 35}), Obstruction::none);
  EXPECT_EQ(game.obstruction({100, 7.9}), Obstruction::cushion);
  EXPECT_EQ(game.obstruction({100, 8}), Obstruction::none);
  EXPECT_EQ(game.obstruction({-500, 100}), Obstruction::cushion);
  EXPECT_EQ(game.obstruction({std::numeric_limits<double>::quiet_NaN(), 100}),
            Obstruction::cushion);
  EXPECT_FALSE(game.apply(Place{{540, 200}}));
  EXPECT_EQ(game.phase(), Phase::place);

  ASSERT_TRUE(game.apply(Place{{300, 100}}));
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.player(), 1);
  EXPECT_EQ(game.world().ball(0).position, (Vec2{300, 100}));
}

// Spec §7: the other balls keep the speeds they had and go on with the shot.
TEST(Billiards, TheOtherBallsWaitWithTheirSpeedsForThePlacement) {
  RandomPlayer player(7);
  for (int games_played = 0; games_played < 200; ++games_played) {
    Game game;
    while (game.phase() != Phase::place && game.phase() != Phase::over) {
      player.command(game);
      roll(game);
    }
    const carom::World at_foul = game.world();
    if (at_foul.at_rest()) continue;
    game.step();
    EXPECT_EQ(game.world().state_hash(), at_foul.state_hash()) << "the table stands still";
    player.command(game);
    for (std::size_t i = 1; i < at_foul.size(); ++i)
      ASSERT_EQ(game.world().ball(i).velocity, at_foul.ball(i).velocity);
    return;
  }
  FAIL() << "no cue ball was ever pocketed while others moved";
}

TEST(Billiards, TheIthBallOfATurnMakes100TimesI) {
  RandomPlayer player(3);
  int best_turn = 0;
  for (int n = 0; n < 40; ++n) {
    Game game;
    player.command(game);
    std::int64_t points = 0;
    int balls = 0;
    for (const auto& event : roll(game)) {
      if (event.kind != EventKind::scored) continue;
      ++balls;
      EXPECT_EQ(event.points, 100 * balls);
      EXPECT_EQ(event.player, 0);
      points += event.points;
    }
    EXPECT_EQ(game.score(0), points);
    EXPECT_EQ(game.score(1), 0);
    EXPECT_EQ(game.reds_left(), 36 - balls);
    EXPECT_EQ(game.turn_balls(), 0) << "the next turn starts at nought";
    best_turn = std::max(best_turn, balls);
  }
  EXPECT_GE(best_turn, 2) << "no turn of these tells 100·i from 100";
}

// Spec §7, whatever the order of the holes they fall into.
TEST(Billiards, RedsThatFallInTheSameStepCountInIndexOrder) {
  RandomPlayer player(47);  // one of its first games has such a step
  int told_apart = 0;
  for (int n = 0; n < 60 && told_apart == 0; ++n) {
    Game game;
    for (int turn = 0; turn < 4 && game.phase() != Phase::over; ++turn) {
      player.command(game);
      while (game.phase() == Phase::roll) {
        std::vector<std::uint32_t> ids;
        for (std::size_t i = 0; i < game.world().size(); ++i)
          ids.push_back(game.world().ball(i).id);
        game.step();
        std::vector<std::ptrdiff_t> scored;
        for (const auto& event : game.events())
          if (event.kind == EventKind::scored)
            scored.push_back(std::ranges::find(ids, event.ball) - ids.begin());
        ASSERT_TRUE(std::ranges::is_sorted(scored));
        std::vector<std::ptrdiff_t> fell;
        for (const auto& event : game.physics_events())
          if (event.kind == carom::EventKind::pocketed && event.ball != 0)
            fell.push_back(std::ranges::find(ids, event.ball) - ids.begin());
        if (!std::ranges::is_sorted(fell)) ++told_apart;
      }
    }
  }
  EXPECT_EQ(told_apart, 1) << "no step tells index order from the order of the holes";
}

TEST(Billiards, RestartsAtAnyTime) {
  const auto fresh = Game().world().state_hash();
  Game game;
  ASSERT_TRUE(game.apply(Shoot{{400, 3}}));
  for (int i = 0; i < 100; ++i) game.step();
  ASSERT_TRUE(game.apply(Restart{}));
  EXPECT_EQ(game.world().state_hash(), fresh);
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.player(), 0);
  pocket_the_cue_ball(game);
  ASSERT_TRUE(game.apply(Restart{}));
  EXPECT_EQ(game.world().state_hash(), fresh);
}

TEST(Billiards, AGameOfARandomPlayerEndsAndIsWonByTheHigherScore) {
  constexpr int most_turns = 2000;  // eight times what the longest of these 20 games takes
  int draws = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    RandomPlayer player(seed);
    Game game;
    int turns = 0;
    std::uint64_t longest_turn = 0;
    while (game.phase() != Phase::over) {
      ASSERT_LT(++turns, most_turns) << "seed " << seed;
      const auto before = game.world().steps();
      player.command(game);
      roll(game);
      longest_turn = std::max(longest_turn, game.world().steps() - before);
    }
    EXPECT_LT(longest_turn, games::billiards::max_turn_steps) << "the guard never has to act";
    EXPECT_EQ(game.reds_left(), 0);
    if (game.winner()) {
      EXPECT_GT(game.score(*game.winner()), game.score(1 - *game.winner()));
    } else {
      ++draws;
      EXPECT_EQ(game.score(0), game.score(1));
    }
    EXPECT_GE(game.score(0) + game.score(1), 3600);
    EXPECT_FALSE(game.apply(Shoot{{10, 0}})) << "the game is over";
  }
  EXPECT_LT(draws, 20);
}

TEST(Billiards, TheFirstPlayerIsAgreedOn) {
  EXPECT_EQ(Game().player(), 0);
  EXPECT_EQ(Game({.first_player = 7}).player(), 0);
  Game game({.first_player = 1});
  EXPECT_EQ(game.player(), 1);
  ASSERT_TRUE(game.apply(Shoot{{-10, 3}}));
  roll(game);
  EXPECT_EQ(game.player(), 0);
  ASSERT_TRUE(game.apply(Restart{}));
  EXPECT_EQ(game.player(), 1);
  EXPECT_EQ(game.options(), Options{.first_player = 1});
}

TEST(Rack, TheQuickOneHas15RedsAtTheSameApex) {
  const carom::Scene classic = games::billiards::rack();
  const carom::Scene quick = games::billiards::rack(Rack::quick);
  ASSERT_EQ(quick.balls.size(), 16U);
  for (std::size_t i = 0; i < quick.balls.size(); ++i)
    EXPECT_EQ(quick.balls[i], classic.balls[i]) << "the first five rows";
  EXPECT_EQ(quick.holes, classic.holes);
  Game game({.rack = Rack::quick});
  EXPECT_EQ(game.reds_left(), 15);
  ASSERT_TRUE(game.apply(Shoot{{400, 3}}));
  roll(game);
  ASSERT_TRUE(game.apply(Restart{}));
  EXPECT_EQ(game.reds_left(), 15);
}

/// The cue ball in hand after a shot that touches no red, as a house rule only.
TEST(Billiards, AShotThatTouchesNoRedIsAFoulIfThatIsAgreedOn) {
  Game plain;
  Game strict({.touch_red = true});
  for (Game* const game : {&plain, &strict}) ASSERT_TRUE(game->apply(Shoot{{-10, 3}}));
  roll(plain);
  EXPECT_EQ(plain.phase(), Phase::aim);
  const auto events = roll(strict);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0], (games::billiards::Event{.kind = EventKind::missed, .player = 0}));
  EXPECT_EQ(events[1], (games::billiards::Event{.kind = EventKind::turn, .player = 1}));
  EXPECT_EQ(strict.phase(), Phase::place);
  EXPECT_EQ(strict.tally(0).fouls, 1);
  EXPECT_EQ(strict.player(), 1);
  const Vec2 where_it_lay = strict.world().ball(0).position;
  EXPECT_EQ(strict.obstruction(where_it_lay), Obstruction::none);
  ASSERT_TRUE(strict.apply(Place{where_it_lay}));
  EXPECT_EQ(strict.world().state_hash(), plain.world().state_hash());
  ASSERT_TRUE(strict.apply(Shoot{{400, 3}})) << "into the rack";
  for (const auto& event : roll(strict)) EXPECT_NE(event.kind, EventKind::missed);
}

TEST(Billiards, WhoPlaysAloneHasEveryTurn) {
  RandomPlayer player(3);
  Game game({.touch_red = true, .rack = Rack::quick, .alone = true});
  while (game.phase() != Phase::over) {
    EXPECT_EQ(game.player(), 0);
    player.command(game);
    roll(game);
  }
  EXPECT_EQ(game.tally(0).balls, 15);
  EXPECT_EQ(game.tally(1), Tally{});
}

/// Whole games by the report's rules and by the house rule: the turn passes as agreed, points start
/// from 100 in each, and the tallies are what the events add up to.
TEST(Billiards, TheTurnPassesAsAgreedAndEverythingIsCounted) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Options options{.first_player = static_cast<int>(seed / 2 % 2),
                          .keep_turn = seed % 2 != 0};
    RandomPlayer player(seed);
    Game game(options);
    std::array<Tally, 2> counted{};
    int kept = 0;
    while (game.phase() != Phase::over) {
      player.command(game);
      if (game.phase() != Phase::roll) continue;
      const int shooter = game.player();
      Tally& tally = counted[static_cast<std::size_t>(shooter)];
      ++tally.shots;
      std::int64_t points = 0;
      int balls = 0;
      bool foul = false;
      for (const auto& event : roll(game)) {
        EXPECT_EQ(event.player == shooter,
                  event.kind != EventKind::turn || game.player() == shooter);
        if (event.kind == EventKind::scored) {
          EXPECT_EQ(event.points, 100 * ++balls);
          points += event.points;
        }
        foul |= event.kind == EventKind::cue_pocketed;
      }
      tally.balls += balls;
      tally.best_turn = std::max(tally.best_turn, points);
      tally.fouls += foul ? 1 : 0;
      if (game.phase() == Phase::over) break;
      const bool keeps = options.keep_turn && balls > 0 && !foul;
      EXPECT_EQ(game.player(), keeps ? shooter : 1 - shooter) << "seed " << seed;
      EXPECT_EQ(game.turn_points(), 0);
      kept += keeps ? 1 : 0;
    }
    for (int of = 0; of < 2; ++of)
      EXPECT_EQ(game.tally(of), counted[static_cast<std::size_t>(of)]) << "seed " << seed;
    EXPECT_EQ(counted[0].balls + counted[1].balls, games::billiards::reds);
    EXPECT_GT(counted[0].fouls + counted[1].fouls, 0) << "no game tells a foul from a shot";
    EXPECT_EQ(kept > 0, options.keep_turn);
  }
}

carom::Scene small_table() {
  carom::Scene table;
  table.holes = {{.position = {10, 200}}};
  table.balls = {{.role = carom::Role::cue, .position = {200, 200}, .radius = 8},
                 {.role = carom::Role::neutral, .position = {100, 200}}};
  return table;
}

TEST(BilliardsFromAnywhere, TheRackIsATableLikeOthers) {
  RandomPlayer player(5);
  Game usual;
  Game given = Game::create(games::billiards::rack()).value();
  for (int turn = 0; turn < 10; ++turn) {
    RandomPlayer twin = player;
    player.command(usual);
    twin.command(given);
    roll(usual);
    roll(given);
    ASSERT_EQ(usual.world().state_hash(), given.world().state_hash());
    ASSERT_EQ(usual.player(), given.player());
  }
}

TEST(BilliardsFromAnywhere, IsWonByWhoPocketsTheOnlyBallAndRestartsThere) {
  Game game = Game::create(small_table(), {.first_player = 1}).value();
  const auto start = game.world().state_hash();
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.player(), 1);
  EXPECT_EQ(game.reds_left(), 1);
  ASSERT_TRUE(game.apply(Shoot{{-100, 0}}));
  roll(game);
  EXPECT_EQ(game.phase(), Phase::over);
  EXPECT_EQ(game.score(1), 100);
  EXPECT_EQ(game.winner(), 1);
  const Game copy = game;
  ASSERT_TRUE(game.apply(Restart{}));
  EXPECT_EQ(game.world().state_hash(), start);
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.player(), 1);
  EXPECT_EQ(copy.phase(), Phase::over) << "a copy is a game of its own";
}

TEST(BilliardsFromAnywhere, BallsInMotionWaitForTheFirstShot) {
  carom::Scene table = small_table();
  table.balls[0].velocity = {10, 20};
  table.balls[1].velocity = {0, 300};
  Game game = Game::create(table).value();
  game.step();
  EXPECT_EQ(game.world().steps(), 0U);
  ASSERT_TRUE(game.apply(Shoot{{50, 0}}));
  EXPECT_EQ(game.world().ball(0).velocity, (Vec2{250, 0}));
  EXPECT_EQ(game.world().ball(1).velocity, (Vec2{0, 300}));
}

TEST(BilliardsFromAnywhere, IsOverAtOnceWhereThereIsNothingToPocket) {
  carom::Scene table = small_table();
  table.balls.pop_back();
  Game game = Game::create(table).value();
  EXPECT_EQ(game.phase(), Phase::over);
  EXPECT_FALSE(game.winner());
  EXPECT_FALSE(game.apply(Shoot{{10, 0}}));
}

TEST(BilliardsFromAnywhere, RefusesAWorldThatIsNotATable) {
  const auto problem = [](const carom::Scene& scene) {
    const auto game = Game::create(scene);
    return game ? "" : carom::to_string(game.errors().front());
  };
  carom::Scene none = small_table();
  none.balls.clear();
  EXPECT_EQ(problem(none),
            "/balls: have no cue ball; expected the first ball to have the role \"cue\"");
  carom::Scene projectile = small_table();
  projectile.balls[0].role = carom::Role::projectile;
  EXPECT_EQ(problem(projectile), problem(none));
  carom::Scene outside = small_table();
  outside.balls[1].position.x = -50;
  EXPECT_EQ(problem(outside).substr(0, 8), "/balls/1") << problem(outside);
}

// A place that obstruction() accepts can be taken, obstacles and open sides included.
TEST(BilliardsFromAnywhere, APlaceThatNothingObstructsIsTaken) {
  carom::Scene table = small_table();
  table.edges.left = carom::Edge::open;
  table.obstacles = {{.x = 400, .height = 120, .radius = 12}};
  Game game = Game::create(table).value();
  ASSERT_TRUE(game.apply(Shoot{{-200, 60}}));
  const auto events = roll(game);
  ASSERT_EQ(game.phase(), Phase::place) << "the cue ball did not leave by the open side";
  EXPECT_EQ(game.obstruction({385, 50}), Obstruction::cushion);
  EXPECT_EQ(game.obstruction({400, 139.9}), Obstruction::cushion);
  EXPECT_EQ(game.obstruction({400, 140}), Obstruction::none);
  EXPECT_EQ(game.obstruction({4, 50}), Obstruction::cushion);
  RandomPlayer player(1);
  for (int n = 0; n < 2000; ++n) {
    Game copy = game;
    const Vec2 position{player.uniform(-20, 820), player.uniform(-20, 420)};
    EXPECT_EQ(static_cast<bool>(copy.apply(Place{position})),
              game.obstruction(position) == Obstruction::none);
  }
}

TEST(Billiards, NoBallEverLeavesTheTableOrTurnsNaNIn1000RandomBreaks) {
  RandomPlayer player(11);
  for (int n = 0; n < 1000; ++n) {
    Game game;
    player.command(game);
    while (game.phase() == Phase::roll) {
      game.step();
      const carom::World& world = game.world();
      for (std::size_t i = 0; i < world.size(); ++i) {
        if (!world.in_play(i)) continue;
        const carom::Ball ball = world.ball(i);
        // Comparisons that NaN fails.
        ASSERT_TRUE(ball.position.x >= ball.radius && ball.position.x <= 800 - ball.radius &&
                    ball.position.y >= ball.radius && ball.position.y <= 400 - ball.radius &&
                    carom::length(ball.velocity) < 1e5)
            << "break " << n << " step " << world.steps() << " ball " << ball.id;
      }
    }
  }
}

}  // namespace
