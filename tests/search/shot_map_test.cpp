#include "search/shot_map.hpp"

#include <gtest/gtest.h>
#include <set>

#include "games/launch.hpp"
#include "project_file.hpp"
#include "search/search.hpp"

namespace {

using search::Aim;
using search::Game;
using search::MapArea;
using search::ShotMap;

games::angry_balls::Game first_level() {
  const std::string json = project_file("levels/01-first-steps.json");
  return games::angry_balls::Game::create(games::angry_balls::read_level(json).value()).value();
}

constexpr MapArea wide{.first_tenths = -900,
                       .tenths_step = 60,
                       .columns = 30,
                       .first_speed = 100,
                       .speed_step = 190,
                       .rows = 10};

TEST(MapArea, OfItsCells_GivesEveryAimOnceAndTurnsBeyondHalfATurn) {
  const MapArea area{.first_tenths = 1790,
                     .tenths_step = 10,
                     .columns = 3,
                     .first_speed = 100,
                     .speed_step = 50,
                     .rows = 2};
  EXPECT_EQ(area.aim(0), (Aim{.tenths = 1790, .speed = 100}));
  EXPECT_EQ(area.aim(1), (Aim{.tenths = 1800, .speed = 100}));
  EXPECT_EQ(area.aim(2), (Aim{.tenths = -1790, .speed = 100}));
  EXPECT_EQ(area.aim(3), (Aim{.tenths = 1790, .speed = 150}));
}

TEST(AreaAround, NearTheGreatestSpeed_KeepsTheAimOnItsNetAndSpeedsInRange) {
  const Aim aim{.tenths = -335, .speed = 1985};
  const MapArea area = search::area_around(aim, 10, 5, 10);
  EXPECT_EQ(area.columns, 21);
  EXPECT_EQ(area.rows, 12);
  bool found = false;
  for (std::size_t i = 0; i < area.cells(); ++i) {
    found = found || area.aim(i) == aim;
    EXPECT_LE(area.aim(i).speed, search::greatest_speed);
  }
  EXPECT_TRUE(found);
}

TEST(ShotMap, InSlicesAndByMoreThreads_HasInEachCellWhatThatShotComesTo) {
  const Game game = first_level();
  for (const int threads : {1, 3}) {
    carom::Rollouts rollouts(threads);
    ShotMap map = ShotMap::create(game, wide).value();
    EXPECT_FALSE(map.cell(0) && map.cell(1));
    std::uint64_t slices = 0;
    while (!map.done()) {
      map.advance(37, rollouts);
      ++slices;
    }
    EXPECT_EQ(slices, (wide.cells() + 36) / 37);
    for (std::size_t i = 0; i < wide.cells(); ++i) {
      carom::World world = search::world_of(game);
      const search::Trial trial = search::simulate(world, {}, search::drag(wide.aim(i)));
      ASSERT_TRUE(map.cell(i).has_value());
      EXPECT_EQ(map.cell(i)->points, trial.points);
      EXPECT_EQ(map.cell(i)->cleared, trial.cleared);
      EXPECT_EQ(map.cell(i)->enemies_out, trial.enemies_out);
    }
  }
}

TEST(ShotMap, AfterAFewCells_HasSomeInEveryPart) {
  carom::Rollouts rollouts(1);
  ShotMap map = ShotMap::create(first_level(), wide).value();
  map.advance(60, rollouts);
  std::set<std::size_t> parts;  // of 15 columns by 2 rows each
  for (std::size_t i = 0; i < wide.cells(); ++i)
    if (map.cell(i)) parts.insert(i / 60 * 2 + i % 30 / 15);
  EXPECT_EQ(parts.size(), 10U);
}

TEST(ShotMap, OfTheCellsThatClear_NamesTheNearestToAnAim) {
  carom::Rollouts rollouts(1);
  ShotMap map = ShotMap::create(first_level(), wide).value();
  const Aim aim{.tenths = 300, .speed = 800};
  EXPECT_FALSE(map.nearest_clearing(aim));
  map.advance(wide.cells(), rollouts);
  const auto nearest = map.nearest_clearing(aim);
  ASSERT_TRUE(nearest.has_value());
  EXPECT_TRUE(map.cell(*nearest)->cleared);
  const auto distance = [&](std::size_t i) {
    return carom::length(search::drag(wide.aim(i)) - search::drag(aim));
  };
  for (std::size_t i = 0; i < wide.cells(); ++i) {
    if (map.cell(i)->cleared) {
      EXPECT_GE(distance(i), distance(*nearest));
    }
  }
}

TEST(ShotMap, OfAWrongArea_IsRefused) {
  const Game game = first_level();
  MapArea area = wide;
  area.columns = 0;
  EXPECT_FALSE(ShotMap::create(game, area).ok());
  area = wide;
  area.rows = 12;  // 2190 px/s
  EXPECT_FALSE(ShotMap::create(game, area).ok());
  area = wide;
  area.columns = 1'000'000;
  EXPECT_FALSE(ShotMap::create(game, area).ok());
}

}  // namespace
