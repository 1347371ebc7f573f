#include "app/first_contact.hpp"

#include <gtest/gtest.h>

namespace {

carom::World world_of(carom::Edges edges) {
  carom::Scene scene;
  scene.edges = edges;
  scene.balls = {{.role = carom::Role::cue, .position = {100, 200}, .radius = 8},
                 {.position = {500, 200}},
                 {.position = {300, 200}}};
  return carom::World::create(scene).value();
}

TEST(FirstContact, StopsAtTheNearestBall) {
  const auto contact = app::first_contact(world_of({}), 0, {3, 0});
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->center.x, 282, 1e-9);
  EXPECT_EQ(contact->target, (carom::Vec2{300, 200}));
}

TEST(FirstContact, AGrazedBallIsMetAtTheDistanceOfTheCentres) {
  const auto contact = app::first_contact(world_of({}), 0, {200, 10});
  ASSERT_TRUE(contact && contact->target);
  EXPECT_NEAR(carom::length(contact->center - *contact->target), 18, 1e-9);
}

TEST(FirstContact, OtherwiseAtTheCushion) {
  const auto contact = app::first_contact(world_of({}), 0, {0, 2});
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->center.y, 392, 1e-9);
  EXPECT_FALSE(contact->target);
}

TEST(FirstContact, NoneThroughAnOpenEdge) {
  EXPECT_FALSE(app::first_contact(world_of({.top = carom::Edge::open}), 0, {0, 2}));
}

}  // namespace
