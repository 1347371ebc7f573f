#include "search/hand.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "games/launch.hpp"

namespace {

// 200 000 numbers: a moment's standard error is some 2^-9 of its size.
TEST(Normal, OfManyNumbers_HasTheMomentsAndTailsOfTheNormalDistribution) {
  games::Random random(1);
  constexpr int count = 200'000;
  double sum = 0;
  double squares = 0;
  double fourths = 0;
  int beyond_1 = 0;
  int beyond_2 = 0;
  int beyond_3 = 0;
  for (int i = 0; i < count; ++i) {
    const double x = search::normal(random);
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
    beyond_1 += std::abs(x) > 1 ? 1 : 0;
    beyond_2 += std::abs(x) > 2 ? 1 : 0;
    beyond_3 += std::abs(x) > 3 ? 1 : 0;
  }
  EXPECT_NEAR(sum / count, 0, 0.01);
  EXPECT_NEAR(squares / count, 1, 0.015);
  EXPECT_NEAR(fourths / count, 3, 0.1);
  EXPECT_NEAR(1.0 * beyond_1 / count, 0.31731, 0.005);
  EXPECT_NEAR(1.0 * beyond_2 / count, 0.04550, 0.002);
  EXPECT_NEAR(1.0 * beyond_3 / count, 0.00270, 0.0006);
}

TEST(Launched, ByAnExactHand_IsWhatWasMeant) {
  games::Random random(1);
  EXPECT_EQ(search::launched({3.25, -7}, {.error = 0}, random), (carom::Vec2{3.25, -7}));
}

TEST(Launched, ByAHand_IsOnTheGridAndErrsByItsPixelsInBothDirections) {
  games::Random random(2);
  const carom::Vec2 meant{100, 50};
  carom::Vec2 squares{};
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const carom::Vec2 made = search::launched(meant, {.error = 7}, random);
    EXPECT_EQ(made, games::on_grid(made));
    const carom::Vec2 error = made - meant;
    squares += {error.x * error.x, error.y * error.y};
  }
  EXPECT_NEAR(std::sqrt(squares.x / count), 7, 0.15);
  EXPECT_NEAR(std::sqrt(squares.y / count), 7, 0.15);
}

TEST(Launched, WhereTheErrorMayUndoTheDrag_IsNeverZero) {
  games::Random random(3);
  for (int i = 0; i < 20'000; ++i)
    EXPECT_NE(search::launched({1.0 / 64, 0}, {.error = 0.01}, random), carom::Vec2{});
}

}  // namespace
