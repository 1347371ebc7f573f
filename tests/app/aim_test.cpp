#include "app/play/aim.hpp"

#include <gtest/gtest.h>

#include "app/play/aim_entry.hpp"
#include "games/launch.hpp"
#include "search/aim.hpp"

namespace {

using app::Key;

app::Aim aim_at(carom::Vec2 drag) {
  app::Aim aim;
  aim.set(drag);
  return aim;
}

TEST(Aim, NothingUntilItIsSet) {
  app::Aim aim;
  aim.turn(10);
  aim.strengthen(100);
  aim.set_speed(100);
  aim.set_degrees(10);
  EXPECT_FALSE(aim.active());
  EXPECT_EQ(aim.drag(), (carom::Vec2{0, 0}));
  EXPECT_TRUE(aim.too_weak());
}

TEST(Aim, ADragIsAVelocity) {
  const app::Aim aim = aim_at({60, -80});
  EXPECT_EQ(aim.drag(), (carom::Vec2{60, -80}));
  EXPECT_EQ(aim.velocity(), (carom::Vec2{300, -400}));
  EXPECT_DOUBLE_EQ(aim.strength(), 0.25);
  EXPECT_NEAR(aim.degrees(), -53.1301, 1e-4);
  EXPECT_FALSE(aim.capped());
}

TEST(Aim, TheSpeedIsCapped) {
  EXPECT_FALSE(aim_at({400, 0}).capped());
  const app::Aim aim = aim_at({600, 800});
  EXPECT_TRUE(aim.capped());
  EXPECT_NEAR(aim.speed(), 2000, 1e-9);
  EXPECT_NEAR(aim.strength(), 1, 1e-12);
}

TEST(Aim, ADragBelowTheRestSpeedIsNotAShot) {
  EXPECT_TRUE(aim_at({5.9, 0}).too_weak());
  EXPECT_FALSE(aim_at({6, 0}).too_weak());
}

TEST(Aim, CancelEndsIt) {
  app::Aim aim = aim_at({50, 0});
  aim.cancel();
  EXPECT_FALSE(aim.active());
  EXPECT_EQ(aim.drag(), (carom::Vec2{0, 0}));
}

TEST(Aim, SmallStepsAddUpAndLieOnTheGrid) {
  for (const double start : {31.0, 77.0, 500.0, 1999.0}) {
    app::Aim aim = aim_at({start / 5, 0});
    for (int i = 1; i <= 900; ++i) {
      aim.turn(0.1);
      EXPECT_EQ(aim.drag(), games::on_grid(aim.drag()));
      // Half a grid step of 1/64 px, on both axes.
      EXPECT_NEAR(aim.degrees(), 0.1 * i, 0.0111 / (start / 5) * 57.3) << start;
      EXPECT_NEAR(aim.speed(), start, 0.06);
      EXPECT_FALSE(aim.too_weak());
    }
    for (int i = 0; i < 900; ++i) aim.turn(-0.1);
    EXPECT_EQ(aim.drag(), games::on_grid({start / 5, 0})) << "there and back again";
  }
}

TEST(Aim, TheStrengthStaysWithinWhatMovesABall) {
  app::Aim aim = aim_at({4000, 0});
  aim.strengthen(-1);
  EXPECT_NEAR(aim.speed(), 1999, 0.06) << "a drag beyond the greatest speed counts as one of it";
  aim.strengthen(10);
  EXPECT_NEAR(aim.speed(), 2000, 0.06);
  for (int degrees = 0; degrees < 360; ++degrees) {
    aim.set_degrees(degrees);
    aim.strengthen(-5000);
    EXPECT_NEAR(aim.speed(), app::least_aim_speed, 0.06);
    EXPECT_FALSE(aim.too_weak()) << degrees;
  }
}

TEST(Aim, ANewDirectionKeepsTheStrength) {
  app::Aim aim = aim_at({100, 0});
  aim.point({-3, 4});
  EXPECT_NEAR(aim.drag().x, -60, 0.01);
  EXPECT_NEAR(aim.drag().y, 80, 0.01);
  aim.set_degrees(-90);
  EXPECT_EQ(aim.drag(), (carom::Vec2{0, -100}));
}

TEST(Aim, TypedNumbers_GiveTheDragOfTheSearchsAimBitByBit) {
  for (int tenths = -1799; tenths <= 1800; ++tenths)
    for (int speed = search::least_speed + (tenths + 1799) % 7; speed <= search::greatest_speed;
         speed += 7) {
      app::Aim aim = aim_at({37, -11});
      aim.set_degrees(tenths / 10.0);
      aim.set_speed(speed);
      ASSERT_EQ(aim.drag(), search::drag({.tenths = tenths, .speed = speed}))
          << tenths << ' ' << speed;
    }
}

TEST(AimEntry, TakesAnAngleAndASpeed) {
  app::AimEntry entry;
  const auto type = [&](std::string_view text) {
    for (const char sign : text) entry.event(app::TextTyped{{sign}});
  };
  app::Aim aim = aim_at({100, 0});
  EXPECT_TRUE(entry.empty());
  type("-47,3.-x ");  // a second point, a minus inside and letters are no part of a number
  entry.apply(aim);
  EXPECT_NEAR(aim.degrees(), -47.3, 0.01);
  EXPECT_NEAR(aim.speed(), 500, 0.06) << "what is left empty stays";
  entry.event(app::KeyPressed{Key::tab});
  type("-8129");  // no minus
  entry.event(app::KeyPressed{Key::backspace});
  entry.apply(aim);
  EXPECT_NEAR(aim.speed(), 812, 0.06);
  EXPECT_NEAR(aim.degrees(), -47.3, 0.01);
  type("99999");
  entry.apply(aim);
  EXPECT_NEAR(aim.speed(), 2000, 0.06);
}

TEST(AimEntry, ATextThatIsNotANumberChangesNothing) {
  for (const char* text : {"", "-", ".", "-.", "400", "-361"}) {
    app::AimEntry entry;
    for (const char* sign = text; *sign != 0; ++sign) entry.event(app::TextTyped{{*sign}});
    app::Aim aim = aim_at({64, 32});
    entry.apply(aim);
    EXPECT_EQ(aim.drag(), (carom::Vec2{64, 32})) << text;
  }
}

}  // namespace
