#include "app/view/viewport.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "app/view/table_view.hpp"
#include "games/billiards.hpp"

namespace {

using app::Viewport;

TEST(Viewport, FitsTheWorldInTheMiddle) {
  const Viewport wide({100, 50, 1000, 250}, {-50, -50}, {850, 450});
  EXPECT_DOUBLE_EQ(wide.scale(), 0.5);
  EXPECT_EQ(wide.to_window({400, 200}), (app::Point{600, 175}));
  EXPECT_EQ(wide.to_window({0, 400}), (app::Point{400, 75}));  // y up becomes y down
  EXPECT_EQ(wide.seen_as({3, 4}), (carom::Vec2{3, 4}));
}

TEST(Viewport, TurnedTheWorldsRightIsUp) {
  const Viewport upright({50, 100, 250, 1000}, {-50, -50}, {850, 450}, true);
  EXPECT_DOUBLE_EQ(upright.scale(), 0.5);
  const app::Point middle = upright.to_window({400, 200});
  EXPECT_EQ(middle, (app::Point{175, 600}));
  EXPECT_EQ(upright.to_window({800, 200}), (middle + app::Point{0, -200}));
  EXPECT_EQ(upright.to_window({400, 400}), (middle + app::Point{-100, 0}));
  EXPECT_EQ(upright.seen_as({0, 1}), (carom::Vec2{1, 0})) << "up is the world's right";
  EXPECT_EQ(upright.seen_as({1, 0}), (carom::Vec2{0, -1}));
  const app::Rect table = upright.to_window({0, 0}, {800, 400});
  EXPECT_EQ(table.center(), middle);
  EXPECT_EQ(table.w, 200);
  EXPECT_EQ(table.h, 400);
}

TEST(Viewport, ThereAndBack) {
  const bool ok = rc::check([] {
    const auto side = static_cast<float>(*rc::gen::inRange(100, 4000));
    const Viewport viewport({0, 0, side, side}, {-46, -46}, {846, 446},
                            *rc::gen::arbitrary<bool>());
    const carom::Vec2 world{*rc::gen::inRange(-2000, 2000) / 3.0,
                            *rc::gen::inRange(-2000, 2000) / 3.0};
    const carom::Vec2 back = viewport.to_world(viewport.to_window(world));
    RC_ASSERT(carom::length(back - world) < 0.01);
  });
  EXPECT_TRUE(ok);
}

TEST(Viewport, AWindowOfNoSizeIsSurvived) {
  const Viewport none({0, 0, 0, 0}, {-46, -46}, {846, 446});
  EXPECT_GT(none.scale(), 0);
}

/// On a phone held upright the table stands; anywhere else it lies, as in the report.
TEST(Viewport, TheTableStandsInAnUprightWindow) {
  const carom::Scene table = games::billiards::rack();
  const app::Rect phone{0, 60, 390, 700};
  const Viewport standing = app::table_viewport(phone, table);
  const app::Point cue = standing.to_window(games::billiards::cue_start);
  const app::Point far = standing.to_window({700, 200});
  EXPECT_EQ(cue.x, far.x);
  EXPECT_GT(cue.y, far.y) << "one shoots away from oneself";
  const app::Rect box = app::table_box(standing, table);
  EXPECT_GT(box.h, 1.4f * phone.w) << "and larger than lying";
  EXPECT_GE(box.x, phone.x - 1);
  EXPECT_LE(box.right(), phone.right() + 1);
  for (const app::Rect area : {app::Rect{0, 0, 844, 300}, {0, 0, 600, 600}, {0, 0, 600, 640}}) {
    const Viewport lying = app::table_viewport(area, table);
    EXPECT_EQ(lying.to_window(games::billiards::cue_start).y, lying.to_window({700, 200}).y);
  }
}

}  // namespace
