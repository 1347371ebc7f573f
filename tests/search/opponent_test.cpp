#include "search/opponent.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "games/launch.hpp"
#include "project_file.hpp"
#include "search/match.hpp"

namespace {

using games::billiards::Phase;
using search::Decision;
using search::Game;
using search::Level;
using search::Opponent;

Decision decision_of(const Game& game, const Level& level, search::Seed seed, std::uint64_t turn,
                     int threads = 1, std::uint64_t slice = 1000) {
  carom::Rollouts rollouts(threads);
  Opponent opponent = Opponent::create(game, level, seed, turn).value();
  while (!opponent.done()) opponent.advance(slice, rollouts);
  return opponent.decision();
}

void expect_equal(const Decision& a, const Decision& b) {
  EXPECT_EQ(a.meant, b.meant);
  EXPECT_EQ(a.drag, b.drag);
}

TEST(Levels, FromTheFirstToTheLast_HaveSteadierHandsOrMoreSimulations) {
  for (std::size_t i = 1; i < search::levels.size(); ++i) {
    const Level& weaker = search::levels[i - 1];
    const Level& stronger = search::levels[i];
    EXPECT_LE(stronger.hand.error, weaker.hand.error) << i;
    EXPECT_TRUE(stronger.hand.error < weaker.hand.error ||
                stronger.simulations > weaker.simulations)
        << i;
  }
  EXPECT_TRUE(search::levels.back().hand.exact());
}

TEST(Opponent, InSlicesAndByMoreThreads_DecidesTheSame) {
  const games::billiards::Game rack;
  for (const std::size_t level : {0U, 4U, 8U}) {
    const Decision once = decision_of(rack, search::levels[level], 3, 0);
    expect_equal(decision_of(rack, search::levels[level], 3, 0, 3, 5), once);
  }
}

TEST(Opponent, OfAnotherTurnOrSeed_ErrsOtherwise) {
  const games::billiards::Game rack;
  const Decision first = decision_of(rack, search::levels[0], 3, 0);
  EXPECT_NE(decision_of(rack, search::levels[0], 3, 1).drag, first.drag);
  EXPECT_NE(decision_of(rack, search::levels[0], 4, 0).drag, first.drag);
}

TEST(Opponent, ByItsHand_MissesWhatItMeantByThatMuch) {
  const games::billiards::Game rack;
  const Level level{.name = "test", .hand = {10}, .simulations = 1};
  double squares = 0;
  constexpr int turns = 400;
  for (std::uint64_t turn = 0; turn < turns; ++turn) {
    const Decision decision = decision_of(rack, level, 1, turn);
    const carom::Vec2 error = decision.drag - search::drag(decision.meant.aim);
    squares += carom::length_squared(error);
  }
  EXPECT_NEAR(std::sqrt(squares / (2 * turns)), 10, 0.8);
}

TEST(Opponent, ByAnExactHand_ShootsWhatItMeant) {
  const games::billiards::Game rack;
  const Decision decision = decision_of(rack, {.name = "test", .hand = {}, .simulations = 5}, 1, 0);
  EXPECT_EQ(decision.drag, search::drag(decision.meant.aim));
}

TEST(Opponent, WhileItThinks_TellsHowFarItIs) {
  const games::billiards::Game rack;
  carom::Rollouts rollouts(1);
  Opponent opponent =
      Opponent::create(rack, {.name = "test", .hand = {5}, .simulations = 40}, 1, 0).value();
  double last = 0;
  EXPECT_EQ(opponent.progress(), 0);
  while (!opponent.done()) {
    opponent.advance(4, rollouts);
    EXPECT_GT(opponent.progress(), last);
    last = opponent.progress();
  }
  EXPECT_EQ(last, 1);
}

TEST(Opponent, InALevel_Throws) {
  const std::string json = project_file("levels/01-first-steps.json");
  games::angry_balls::Game game =
      games::angry_balls::Game::create(games::angry_balls::read_level(json).value()).value();
  const Decision decision =
      decision_of(game, {.name = "test", .hand = {}, .simulations = 200}, 1, 0);
  ASSERT_TRUE(game.apply(games::angry_balls::Throw{decision.drag}).ok());
  while (game.phase() == games::angry_balls::Phase::fly) game.step();
  EXPECT_EQ(game.phase(), games::angry_balls::Phase::won);
}

TEST(PlayGame, OfTwoLevels_EndsWithAllPointsCountedAndIsTheSameAgain) {
  carom::Rollouts rollouts(1);
  const std::array<Level, 2> sides{{{.name = "a", .hand = {}, .simulations = 10},
                                    {.name = "b", .hand = {20}, .simulations = 5}}};
  const search::GameResult game = search::play_game(sides, 0, 7, rollouts);
  // 36 reds, 100 points each at least.
  EXPECT_GE(game.points[0] + game.points[1], 3600);
  EXPECT_EQ(game.points[0] % 100, 0);
  EXPECT_EQ(game.winner, game.points[0] > game.points[1] ? 0 : 1);
  EXPECT_LE(std::abs(game.turns[0] - game.turns[1]), 1);
  EXPECT_EQ(game.simulations[0], 10U * static_cast<unsigned>(game.turns[0]));
  EXPECT_EQ(search::play_game(sides, 0, 7, rollouts), game);
  EXPECT_NE(search::play_game(sides, 0, 8, rollouts).hash, game.hash);
}

TEST(PlayGame, MirroredWithEqualSides_IsTheSameGameFromTheOtherSide) {
  carom::Rollouts rollouts(1);
  const Level level{.name = "a", .hand = {12}, .simulations = 8};
  const search::GameResult game = search::play_game({level, level}, 0, 5, rollouts);
  const search::GameResult mirrored = search::play_game({level, level}, 1, 5, rollouts);
  EXPECT_EQ(mirrored.hash, game.hash);
  EXPECT_EQ(mirrored.points[0], game.points[1]);
  EXPECT_EQ(mirrored.turns[1], game.turns[0]);
}

TEST(PlayGame, OfDistantLevels_IsMostlyWonByTheStronger) {
  carom::Rollouts rollouts(1);
  int won = 0;
  for (int game = 0; game < 10; ++game)
    won += search::play_game({search::levels[7], search::levels[0]}, game % 2,
                             static_cast<search::Seed>(game / 2), rollouts)
                       .winner == 0
               ? 1
               : 0;
  EXPECT_GE(won, 8);
}

}  // namespace
