#include "search/generator.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "carom/scene_file.hpp"
#include "carom/world.hpp"
#include "games/angry_balls.hpp"
#include "games/level_check.hpp"
#include "games/settling.hpp"
#include "search/level_games.hpp"
#include "search/solver.hpp"

namespace {

using games::angry_balls::Game;
using search::Generated;
using search::Order;
using search::Part;

const Generated& easy_level() {
  static const Generated made = [] {
    carom::Rollouts rollouts;
    return search::generate({.difficulty = 0.05, .seed = 1}, rollouts).value();
  }();
  return made;
}

TEST(Parts, OfEveryKind_MakeSoundLevelsWithEnemies) {
  for (std::size_t kind = 0; kind < search::part_names.size(); ++kind)
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      games::Random random(seed);
      const carom::Scene level = search::assemble(static_cast<Part>(kind), 1 + seed % 5, random);
      EXPECT_TRUE(carom::check(level).empty()) << search::part_names[kind] << " " << seed;
      EXPECT_TRUE(games::angry_balls::check_level(level).empty()) << seed;
    }
}

TEST(Parts, OfOneKind_HaveWhatItsNameSays) {
  games::Random random(1);
  const auto level = [&](Part part) { return search::assemble(part, 1, random); };
  EXPECT_EQ(level(Part::pit).obstacles.size(), 2U);
  EXPECT_EQ(level(Part::pyramid).balls.size(), 7U);
  EXPECT_EQ(level(Part::sentinel).obstacles.size(), 1U);
  EXPECT_EQ(level(Part::room).edges.top, carom::Edge::solid);
  EXPECT_EQ(level(Part::ball).edges.top, carom::Edge::open);
  const carom::Scene tower = level(Part::tower);
  ASSERT_GE(tower.balls.size(), 3U);
  EXPECT_EQ(tower.balls[1].position.x, tower.balls.back().position.x);
  EXPECT_EQ(tower.balls.back().role, carom::Role::enemy);
}

TEST(Generator, AnOrder_GivesALevelThatStaysAndCanBeWon) {
  const carom::Scene& level = easy_level().level;
  EXPECT_TRUE(games::angry_balls::level_warnings(level).empty());
  EXPECT_FALSE(level.name.empty());
  const auto read = carom::read_scene(carom::write_scene(level));
  ASSERT_TRUE(read);
  EXPECT_EQ(carom::write_scene(read.value()), carom::write_scene(level));
  carom::Rollouts rollouts;
  const Game game = Game::create(level).value();
  EXPECT_FALSE(search::solve(game, 20'000, 99, rollouts).found.empty());
  carom::Scene others = level;
  others.balls.erase(others.balls.begin());
  const auto settling =
      games::look_ahead(carom::World::create(others).value(), std::uint64_t{1} << 40U);
  EXPECT_TRUE(settling.restless.empty());
}

TEST(Generator, FreshGames_AreLostAboutAsOftenAsWanted) {
  EXPECT_NEAR(easy_level().difficulty.mean, 0.05, 0.04);
  carom::Rollouts rollouts;
  const auto games = search::play_level(Game::create(easy_level().level).value(),
                                        search::reference_player, 100, 12'345, rollouts);
  EXPECT_NEAR(1 - games.rate().mean, 0.05, 0.1);
}

TEST(Generator, TheSameOrderOnOtherThreads_GivesTheSameLevel) {
  carom::Rollouts rollouts(3);
  const auto again = search::generate({.difficulty = 0.05, .seed = 1}, rollouts);
  ASSERT_TRUE(again);
  EXPECT_EQ(again.value().level, easy_level().level);
  EXPECT_EQ(again.value().candidates, easy_level().candidates);
}

TEST(Generator, ABudgetThatIsUsedUp_IsTold) {
  carom::Rollouts rollouts;
  const auto made = search::generate({.difficulty = 0.95, .seed = 1, .candidates = 1}, rollouts);
  ASSERT_FALSE(made);
  EXPECT_EQ(carom::to_string(made.errors()[0].problem),
            "none of 1 candidates has the difficulty wanted");
}

TEST(Generator, ADifficultyOutOfRange_IsRefused) {
  carom::Rollouts rollouts;
  for (const double wrong : {-0.1, 1.1, std::nan("")})
    EXPECT_FALSE(search::generate({.difficulty = wrong}, rollouts)) << wrong;
}

}  // namespace
