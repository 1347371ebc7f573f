#include "app/play/first_aim.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "app/storage/level.hpp"

namespace {

using carom::Role;
using carom::Vec2;

carom::World world(const std::vector<carom::Ball>& balls,
                   const std::vector<carom::Hole>& holes = {},
                   const std::vector<carom::Obstacle>& obstacles = {}) {
  carom::Scene scene;
  scene.balls = balls;
  scene.holes = holes;
  scene.obstacles = obstacles;
  return carom::World::create(scene).value();
}

double degrees(Vec2 drag) { return std::atan2(drag.y, drag.x) * 180 / 3.14159265358979; }

const carom::Ball cue{.role = Role::cue, .position = {100, 200}, .radius = 8};
carom::Ball red(double x, double y) { return {.role = Role::red, .position = {x, y}}; }

TEST(FirstAim, PointsAtTheNearestBallOfTheRole) {
  const Vec2 drag = app::first_aim(world({cue, red(400, 200), red(100, 300)}), Role::red);
  EXPECT_NEAR(drag.x, 0, 1e-9);
  EXPECT_NEAR(drag.y, 100, 1e-9);
}

TEST(FirstAim, PassesOverWhatAnotherBallAHoleOrAWallLiesBefore) {
  const carom::Ball neutral{.role = Role::neutral, .position = {130, 200}};
  EXPECT_NEAR(
      degrees(app::first_aim(world({cue, neutral, red(200, 200), red(100, 390)}), Role::red)), 90,
      1e-9);
  EXPECT_NEAR(
      degrees(app::first_aim(world({cue, red(200, 200), red(100, 390)}, {{.position = {150, 205}}}),
                             Role::red)),
      90, 1e-9);
  EXPECT_NEAR(degrees(app::first_aim(world({cue, red(200, 200), red(100, 390)}, {},
                                           {{.x = 150, .height = 250, .radius = 12}}),
                                     Role::red)),
              90, 1e-9);
}

TEST(FirstAim, PointsAtTheNearestIfSomethingLiesBeforeEach) {
  const carom::Ball neutral{.role = Role::neutral, .position = {130, 200}};
  EXPECT_NEAR(degrees(app::first_aim(world({cue, neutral, red(200, 200)}), Role::red)), 0, 1e-9);
  EXPECT_NEAR(degrees(app::first_aim(world({cue}), Role::red)), 0, 1e-9);
}

TEST(FirstAim, PointsAtAnEnemyInEveryShippedLevel) {
  for (const app::Level& level : app::shipped_levels()) {
    const carom::World at_start = carom::World::create(level.scene.value()).value();
    const Vec2 way = carom::unit(app::first_aim(at_start, Role::enemy));
    double least = 1e9;  // px, from the line to an enemy's centre
    for (std::size_t i = 1; i < at_start.size(); ++i) {
      const Vec2 to = at_start.ball(i).position - at_start.ball(0).position;
      if (at_start.ball(i).role == Role::enemy)
        least = std::min(least, std::abs(way.x * to.y - way.y * to.x));
    }
    EXPECT_LT(least, 1e-9) << level.name;
  }
}

}  // namespace
