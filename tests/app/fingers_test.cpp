#include "app/input/fingers.hpp"

#include <gtest/gtest.h>

namespace {

using app::Finger;

class FingersTest : public testing::Test {
 protected:
  std::vector<app::Input> give(std::int64_t id, Finger::Phase phase, app::Point at = {5, 6}) {
    return fingers.event({id, phase, at});
  }
  std::vector<app::Input> down(std::int64_t id) { return give(id, Finger::Phase::down); }
  std::vector<app::Input> move(std::int64_t id) { return give(id, Finger::Phase::moved); }
  std::vector<app::Input> up(std::int64_t id) { return give(id, Finger::Phase::up); }
  app::Fingers fingers;
};

TEST_F(FingersTest, OneFingerIsThePointerAndThenNowhere) {
  const auto pressed = down(7);
  ASSERT_EQ(pressed.size(), 2u);
  EXPECT_EQ(std::get<app::PointerMoved>(pressed[0]).at, (app::Point{5, 6}));
  EXPECT_TRUE(std::get<app::PointerPressed>(pressed[1]).touch);
  EXPECT_EQ(move(7).size(), 1u);
  const auto lifted = up(7);
  ASSERT_EQ(lifted.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<app::PointerReleased>(lifted[1]));
  EXPECT_TRUE(std::holds_alternative<app::PointerLeft>(lifted[2]));
  EXPECT_TRUE(fingers.none());
}

TEST_F(FingersTest, ASecondOneTakesBackAndAllHaveToBeLifted) {
  down(1);
  const auto second = down(2);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<app::PointerCancelled>(second[0]));
  EXPECT_TRUE(down(3).empty());
  EXPECT_TRUE(move(1).empty());
  EXPECT_TRUE(up(1).empty());
  EXPECT_TRUE(up(3).empty());
  EXPECT_TRUE(move(2).empty());
  EXPECT_TRUE(up(2).empty());
  EXPECT_EQ(down(4).size(), 2u);
}

TEST_F(FingersTest, ReleasesOfUnknownFingersDoNothing) {
  EXPECT_TRUE(move(1).empty());
  EXPECT_TRUE(up(1).empty());
  down(1);
  EXPECT_EQ(down(1).size(), 2u) << "its lifting was lost";
  up(1);
  EXPECT_TRUE(fingers.none());
}

}  // namespace
