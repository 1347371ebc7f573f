#include "app/view/interpolator.hpp"

#include <gtest/gtest.h>

namespace {

carom::World world_of(std::vector<carom::Ball> balls) {
  carom::Scene scene;
  scene.friction = 1;
  scene.holes = {{.position = {790, 390}}};
  scene.balls = std::move(balls);
  return carom::World::create(scene).value();
}

TEST(Interpolator, DrawsBetweenTheLastTwoSteps) {
  carom::World world = world_of({{.position = {100, 100}, .velocity = {200, 0}}});
  app::Interpolator motion;
  motion.record(world);
  world.step();
  EXPECT_EQ(motion.position(world, 0, 0), (carom::Vec2{100, 100}));
  EXPECT_EQ(motion.position(world, 0, 0.25), (carom::Vec2{100.5, 100}));
  EXPECT_EQ(motion.position(world, 0, 1), (carom::Vec2{102, 100}));
}

TEST(Interpolator, FollowsABallWhoseIndexChanged) {
  // Ball 0 falls at once; ball 2 takes its index.
  carom::World world = world_of({{.position = {790, 390}},
                                 {.position = {100, 100}},
                                 {.position = {300, 300}, .velocity = {100, 0}}});
  app::Interpolator motion;
  motion.record(world);
  world.step();
  ASSERT_EQ(world.size(), 2u);
  ASSERT_EQ(world.ball(0).id, 2u);
  EXPECT_EQ(motion.position(world, 0, 0.5), (carom::Vec2{300.5, 300}));
}

TEST(Interpolator, RemembersTheLastPlacesUntilABallIsMovedByHand) {
  carom::World world = world_of({{.position = {100, 100}, .velocity = {200, 0}}});
  app::Interpolator motion;
  EXPECT_TRUE(motion.past(0).empty());
  for (std::size_t i = 0; i < 20; ++i) {
    motion.record(world);
    world.step();
    EXPECT_EQ(motion.past(0).size(), std::min(i + 1, app::Interpolator::remembered));
  }
  for (std::size_t i = 0; i < app::Interpolator::remembered; ++i)
    EXPECT_NEAR(motion.past(0)[i].x, 138 - 2 * static_cast<double>(i), 1e-9);
  motion.restart(world);
  ASSERT_EQ(motion.past(0).size(), 1u);
  EXPECT_EQ(motion.past(0)[0], world.ball(0).position);
}

}  // namespace
