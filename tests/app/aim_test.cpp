#include "app/aim.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Aim, NothingBeforeTheFirstClick) {
  app::Aim aim;
  aim.move({300, 200});
  EXPECT_FALSE(aim.active());
  EXPECT_EQ(aim.drag(), (carom::Vec2{0, 0}));
  EXPECT_TRUE(aim.too_weak());
}

TEST(Aim, DragsFromTheFirstClickToThePointer) {
  app::Aim aim;
  aim.begin({100, 100});
  aim.move({160, 20});
  EXPECT_EQ(aim.drag(), (carom::Vec2{60, -80}));
  EXPECT_EQ(aim.velocity(), (carom::Vec2{300, -400}));
  EXPECT_DOUBLE_EQ(aim.strength(), 0.25);
  EXPECT_FALSE(aim.capped());
}

TEST(Aim, TheSpeedIsCapped) {
  app::Aim aim;
  aim.begin({0, 0});
  aim.move({400, 0});
  EXPECT_FALSE(aim.capped());
  aim.move({600, 800});
  EXPECT_TRUE(aim.capped());
  EXPECT_NEAR(aim.speed(), 2000, 1e-9);
  EXPECT_NEAR(aim.strength(), 1, 1e-12);
}

TEST(Aim, WeakerThanRestIsNoShot) {
  app::Aim aim;
  aim.begin({0, 0});
  aim.move({5.9, 0});
  EXPECT_TRUE(aim.too_weak());
  aim.move({6, 0});
  EXPECT_FALSE(aim.too_weak());
}

TEST(Aim, CancelTakesTheFirstClickBack) {
  app::Aim aim;
  aim.begin({0, 0});
  aim.move({50, 0});
  aim.cancel();
  EXPECT_FALSE(aim.active());
  EXPECT_EQ(aim.drag(), (carom::Vec2{0, 0}));
}

}  // namespace
