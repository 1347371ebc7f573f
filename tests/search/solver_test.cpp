#include "search/solver.hpp"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

#include "carom/scene_file.hpp"
#include "project_file.hpp"
#include "replay/player.hpp"
#include "search/proof_file.hpp"

namespace {

using games::angry_balls::Game;
using games::angry_balls::Phase;
using search::Aim;
using search::Margin;
using search::margin;
using search::most_robust;
using search::solve;
using search::Solved;
using search::Throws;

Game level(const std::string& name) {
  return Game::create(carom::read_scene(project_file("levels/" + name + ".json")).value()).value();
}

bool wins(Game game, const Throws& throws) {
  for (const Aim& aim : throws) {
    if (game.phase() == Phase::offer && !game.apply(games::angry_balls::Next{})) return false;
    if (!game.apply(games::angry_balls::Throw{drag(aim)})) return false;
    while (game.phase() == Phase::fly) game.step();
  }
  return game.phase() == Phase::won;
}

TEST(Solver, EveryShippedLevel_IsWonByAllThatIsFound) {
  carom::Rollouts rollouts;
  int levels = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/levels")) {
    if (entry.path().extension() != ".json" ||
        search::lies_beside_levels(entry.path().filename().string()))
      continue;
    ++levels;
    const Game game = level(entry.path().stem().string());
    const Solved solved = solve(game, 20'000, 1, rollouts);
    EXPECT_FALSE(solved.found.empty()) << entry.path();
    EXPECT_LE(solved.simulations, 20'000U);
    for (const Throws& throws : solved.found) {
      EXPECT_EQ(throws.size(), solved.found.front().size());
      EXPECT_TRUE(wins(game, throws)) << entry.path();
    }
  }
  EXPECT_GE(levels, 10);
}

TEST(Solver, ALevelThatNothingWins_UsesItsSimulationsAndFindsNothing) {
  carom::Scene scene = level("02-two-towers").level();
  for (carom::Ball& ball : scene.balls)
    if (ball.role == carom::Role::enemy) ball.solidity = carom::infinite_solidity;
  scene.edges = {};
  carom::Rollouts rollouts;
  const Solved solved = solve(Game::create(scene).value(), 5000, 1, rollouts);
  EXPECT_TRUE(solved.found.empty());
  EXPECT_EQ(solved.simulations, 5000U);
}

TEST(Solver, AnyNumberOfThreads_FindsTheSame) {
  const Game game = level("09-the-crown");
  carom::Rollouts one(1);
  carom::Rollouts three(3);
  const Solved solved = solve(game, 20'000, 7, one);
  EXPECT_EQ(solved.found, solve(game, 20'000, 7, three).found);
  EXPECT_EQ(most_robust(game, solved, 7, one), most_robust(game, solved, 7, three));
}

TEST(Margins, AnAimThatWins_IsTheMiddleOfABoxThatWinsAndCannotGrow) {
  carom::Rollouts rollouts;
  const Game game = level("02-two-towers");
  const Throws best = most_robust(game, solve(game, 20'000, 1, rollouts), 1, rollouts);
  ASSERT_EQ(best.size(), 1U);
  const Margin size = margin(game, best, 0, rollouts);
  ASSERT_GE(size, 1);
  ASSERT_LT(size, search::widest_margin);
  int lost_in_the_ring = 0;
  for (int turn = -size - 1; turn <= size + 1; ++turn)
    for (int step = -size - 1; step <= size + 1; ++step) {
      const bool ring = std::abs(turn) > size || std::abs(step) > size;
      Aim aim = turned(best[0], turn);
      aim.speed += step * search::margin_speed;
      const bool won = wins(game, {aim});
      EXPECT_TRUE(won || ring) << turn << " " << step;
      lost_in_the_ring += won ? 0 : 1;
    }
  EXPECT_GT(lost_in_the_ring, 0);
}

TEST(Margins, OfTheSecondThrow_ThatOfWhatFollowsTheFirst) {
  carom::Rollouts rollouts;
  const Game game = level("08-sentinels");
  const Solved solved = solve(game, 20'000, 1, rollouts);
  ASSERT_EQ(solved.found.front().size(), 2U);
  const Throws& way = solved.found.front();
  EXPECT_GE(margin(game, way, 0, rollouts), 0);
  EXPECT_GE(margin(game, way, 1, rollouts), 0);
  // Without what the first one did, the second alone does not win.
  EXPECT_EQ(margin(game, {way[1]}, 0, rollouts), search::no_margin);
}

TEST(Replays, OfWinningThrows_VerifyAndAreWon) {
  carom::Rollouts rollouts;
  const Game game = level("08-sentinels");
  const Throws way = solve(game, 20'000, 1, rollouts).found.front();
  auto player = replay::verify(search::replay_of(game, way)).value();
  EXPECT_FALSE(player.divergence());
  ASSERT_TRUE(player.seek(player.turns().size()));
  EXPECT_EQ(std::get<Game>(player.game()).phase(), Phase::won);
}

}  // namespace
