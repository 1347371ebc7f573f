#include "app/view/trails.hpp"

#include <gtest/gtest.h>

#include "app/graphics/palette.hpp"
#include "app/view/effects.hpp"

namespace {

using namespace std::chrono_literals;

/// The trail of a ball of this speed (px/s) after ten steps.
app::DrawList trail_at(double speed, bool moved_by_hand = false) {
  carom::Scene scene;
  scene.friction = 1;
  scene.balls = {{.position = {100, 100}, .velocity = {speed, 0}}};
  carom::World world = carom::World::create(scene).value();
  app::Interpolator motion;
  for (int i = 0; i < 10; ++i) {
    motion.record(world);
    world.step();
  }
  if (moved_by_hand) motion.restart(world);
  app::DrawList list;
  const app::Viewport viewport({0, 0, 800, 400}, {0, 0}, {800, 400});
  app::draw_trails(list, viewport, world, motion, 1,
                   [](const carom::Ball&) { return app::palette::ivory; });
  return list;
}

TEST(Trails, FollowQuickBallsOnly) {
  EXPECT_TRUE(trail_at(0).vertices.empty());
  EXPECT_TRUE(trail_at(200).vertices.empty());
  const auto opacity = [](const app::DrawList& list) {
    int most = 0;
    for (const app::Vertex& vertex : list.vertices) most = std::max<int>(most, vertex.color.a);
    return most;
  };
  EXPECT_GT(opacity(trail_at(600)), 20);
  EXPECT_GT(opacity(trail_at(1200)), opacity(trail_at(600)));
}

TEST(Trails, AreAsLongAsTheLastStepsAndEndInNothing) {
  const app::DrawList list = trail_at(1000);
  float left = 800;
  float right = 0;
  for (const app::Vertex& vertex : list.vertices) {
    left = std::min(left, vertex.position.x);
    right = std::max(right, vertex.position.x);
  }
  EXPECT_NEAR(right, 200, 0.01);
  // Seven whole steps: the eighth has just ended.
  EXPECT_NEAR(right - left, 70, 0.01);
  for (const app::Vertex& vertex : list.vertices) {
    const bool at_the_end = vertex.position.x < left + 0.01f;
    EXPECT_TRUE(!at_the_end || vertex.color.a == 0);
  }
}

TEST(Trails, DoNotReachBackBeforeABallWasMovedByHand) {
  EXPECT_TRUE(trail_at(1000, true).vertices.empty());
}

TEST(Shake, LastsAsLongAsABallBreaksAndShowsNoEdge) {
  app::Effects effects;
  const app::Rect area{100, 50, 800, 400};
  const auto shaken = [&] {
    app::DrawList list;
    list.add({0, 0}, {});
    for (const app::Point corner :
         {app::Point{100, 50}, app::Point{900, 50}, app::Point{900, 450}, app::Point{100, 450}})
      list.add(corner, {});
    effects.shake(list, 1, area);
    EXPECT_EQ(list.vertices[0].position, (app::Point{0, 0}));
    return list.vertices;
  };
  EXPECT_EQ(shaken()[1].position, (app::Point{100, 50}));
  effects.burst({400, 200}, 20, app::BallKind::red, 3);
  for (int i = 0; i < 17; ++i) {
    effects.advance(20ms);
    const auto at = shaken();
    EXPECT_NE(at[1].position, (app::Point{100, 50})) << i;
    EXPECT_LE(std::max(at[1].position.x, at[4].position.x), 100);
    EXPECT_GE(std::min(at[2].position.x, at[3].position.x), 900);
    EXPECT_LE(std::max(at[1].position.y, at[2].position.y), 50);
    EXPECT_GE(std::min(at[3].position.y, at[4].position.y), 450);
  }
  effects.advance(20ms);
  EXPECT_EQ(shaken()[1].position, (app::Point{100, 50}));
  EXPECT_TRUE(effects.active());
}

}  // namespace
