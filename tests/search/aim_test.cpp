#include "search/aim.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "games/launch.hpp"

namespace {

using search::Aim;

TEST(AimDirection, OfEveryTenth_IsTheCosineAndTheSine) {
  for (int tenths = -3600; tenths <= 3600; ++tenths) {
    const carom::Vec2 way = search::direction(tenths / 10.0);
    const double radians = tenths / 10.0 * std::numbers::pi / 180;
    EXPECT_NEAR(way.x, std::cos(radians), 4e-16 + std::abs(radians) * 3e-16) << tenths;
    EXPECT_NEAR(way.y, std::sin(radians), 4e-16 + std::abs(radians) * 3e-16) << tenths;
  }
}

TEST(AimDirection, OfRightAngles_IsExact) {
  EXPECT_EQ(search::direction(0), (carom::Vec2{1, 0}));
  EXPECT_EQ(search::direction(90), (carom::Vec2{0, 1}));
  EXPECT_EQ(search::direction(-180), (carom::Vec2{-1, 0}));
  EXPECT_EQ(search::direction(270), (carom::Vec2{0, -1}));
}

TEST(AimDrag, OfEveryAim_IsOnTheGridAndAsFast) {
  for (int tenths = -1799; tenths <= 1800; tenths += 7)
    for (int speed = search::least_speed; speed <= search::greatest_speed; speed += 11) {
      const carom::Vec2 drag = search::drag({.tenths = tenths, .speed = speed});
      EXPECT_EQ(drag, games::on_grid(drag));
      EXPECT_NEAR(carom::length(games::launch_velocity(drag)), speed, 0.06);
    }
}

TEST(NearestAim, OfAnAimsOwnVelocity_IsTheAim) {
  for (int tenths = -1799; tenths <= 1800; ++tenths) {
    const Aim aim{.tenths = tenths, .speed = search::least_speed + (tenths + 1799) % 1970};
    EXPECT_EQ(search::nearest_aim(aim.speed * search::direction(tenths / 10.0)), aim) << tenths;
  }
}

TEST(NearestAim, OfSpeedsOutOfRange_IsTheNearestInRange) {
  EXPECT_EQ(search::nearest_aim({1, 0}).speed, search::least_speed);
  EXPECT_EQ(search::nearest_aim({0, 1e9}).speed, search::greatest_speed);
}

}  // namespace
