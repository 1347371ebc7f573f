#include "app/viewport.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace {

using app::Viewport;

TEST(Viewport, FitsTheWorldWithItsMarginInTheMiddle) {
  const Viewport wide({100, 50, 1000, 250}, {800, 400}, 50);
  EXPECT_DOUBLE_EQ(wide.scale(), 0.5);
  EXPECT_EQ(wide.to_window({400, 200}), (app::Point{600, 175}));
  EXPECT_EQ(wide.to_window({0, 400}), (app::Point{400, 75}));  // y up becomes y down
}

TEST(Viewport, ThereAndBack) {
  const bool ok = rc::check([] {
    const auto side = rc::gen::inRange(100, 4000);
    const Viewport viewport({0, 0, static_cast<float>(*side), static_cast<float>(*side)},
                            {800, 400}, 46);
    const carom::Vec2 world{*rc::gen::inRange(-2000, 2000) / 3.0,
                            *rc::gen::inRange(-2000, 2000) / 3.0};
    const carom::Vec2 back = viewport.to_world(viewport.to_window(world));
    RC_ASSERT(carom::length(back - world) < 0.01);
  });
  EXPECT_TRUE(ok);
}

TEST(Viewport, AWindowOfNoSizeIsSurvived) {
  const Viewport none({0, 0, 0, 0}, {800, 400}, 46);
  EXPECT_GT(none.scale(), 0);
}

}  // namespace
