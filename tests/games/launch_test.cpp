#include "games/launch.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "games/billiards.hpp"

namespace {

using carom::Vec2;

TEST(Launch, IsFiveTimesTheDragAndCapped) {
  EXPECT_EQ(games::launch_velocity({10, -20}), (Vec2{50, -100}));
  EXPECT_EQ(games::launch_velocity({400, 0}), (Vec2{2000, 0}));
  EXPECT_EQ(games::launch_velocity({800, 0}), (Vec2{2000, 0}));
  const Vec2 capped = games::launch_velocity({900, -1200});
  EXPECT_DOUBLE_EQ(capped.x, 1200);
  EXPECT_DOUBLE_EQ(capped.y, -1600);
}

TEST(OnGrid, OfAnyVector_IsTheNearestMultipleOfASixtyFourth) {
  EXPECT_EQ(games::on_grid({1.0 / 64, -3.5}), (Vec2{1.0 / 64, -3.5}));
  EXPECT_EQ(games::on_grid({0.1, -0.1}), (Vec2{6.0 / 64, -6.0 / 64}));
}

TEST(Launch, RefusesADragWithoutDirection) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  auto world = carom::World::create(games::billiards::rack()).value();
  const auto untouched = world.state_hash();
  for (const Vec2 drag : {Vec2{0, 0}, Vec2{nan, 1}, Vec2{1, inf}, Vec2{1e300, 1e300}})
    EXPECT_FALSE(games::launch(world, drag)) << drag.x;
  EXPECT_EQ(world.state_hash(), untouched);
  EXPECT_TRUE(games::launch(world, {1, 0}));
}

}  // namespace
