#include "app/play/clock.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace {

using namespace std::chrono_literals;
using app::Clock;

TEST(Clock, KeepsWhatIsLeftOfAFrame) {
  Clock clock;
  EXPECT_EQ(clock.advance(15ms), 1);
  EXPECT_DOUBLE_EQ(clock.fraction(), 0.5);
  EXPECT_EQ(clock.advance(5ms), 1);
  EXPECT_DOUBLE_EQ(clock.fraction(), 0);
}

TEST(Clock, LosesNoTimeAtAnyFrameRate) {
  const bool ok = rc::check([] {
    Clock clock;
    const auto frames = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 80'000'000));
    std::int64_t total = 0;
    std::int64_t steps = 0;
    for (const int frame : frames) {
      total += frame;
      steps += clock.advance(std::chrono::nanoseconds(frame));
    }
    RC_ASSERT(steps == total / Clock::step.count());
  });
  EXPECT_TRUE(ok);
}

TEST(Clock, ForgetsAStallButNotTheRemainder) {
  Clock clock;
  EXPECT_EQ(clock.advance(5s + 4ms), Clock::catch_up);
  EXPECT_DOUBLE_EQ(clock.fraction(), 0.4);
  EXPECT_EQ(clock.advance(6ms), 1);
}

class AtRate : public testing::TestWithParam<int> {};

TEST_P(AtRate, EveryFrameShowsTheTimeThatPassed) {
  Clock clock;
  const std::chrono::nanoseconds frame{1'000'000'000 / GetParam()};
  const double a_frame =
      static_cast<double>(frame.count()) / static_cast<double>(Clock::step.count());
  int steps = 0;
  double shown = 0;
  for (int i = 0; i < 10 * GetParam(); ++i) {
    const int due = clock.advance(frame);
    // No step is doubled, none is made up for.
    EXPECT_GE(due, static_cast<int>(a_frame));
    EXPECT_LE(due, static_cast<int>(a_frame) + 1);
    steps += due;
    const double now = steps + clock.fraction();
    EXPECT_NEAR(now - shown, a_frame, 1e-9);
    shown = now;
  }
  // A frame's length is a whole number of nanoseconds.
  EXPECT_EQ(steps, frame * 10 * GetParam() / Clock::step);
  EXPECT_GE(steps, 999);
  EXPECT_LE(steps, 1000);
}

INSTANTIATE_TEST_SUITE_P(Displays, AtRate, testing::Values(50, 60, 75, 144, 240));

TEST(Clock, LosesNoTimeAtAnySpeed) {
  const bool ok = rc::check([] {
    Clock clock;
    std::int64_t quarters = 0;
    std::int64_t steps = 0;
    const auto frames = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 40'000'000));
    for (const int frame : frames) {
      const app::Speed speed{*rc::gen::element(1, 2, 4, 8, 16, 64)};
      quarters += std::int64_t{frame} * speed.quarters;
      steps += clock.advance(std::chrono::nanoseconds(frame), speed);
    }
    RC_ASSERT(steps == quarters / (4 * Clock::step.count()));
  });
  EXPECT_TRUE(ok);
}

TEST(Clock, KeepsQuartersOfANanosecond) {
  Clock clock;
  EXPECT_EQ(clock.advance(39'999'999ns, app::slow_motion), 0);
  EXPECT_EQ(clock.advance(1ns, app::slow_motion), 1);
  EXPECT_EQ(clock.fraction(), 0);
}

TEST(Clock, MakesUpForMoreWhenItIsQuicker) {
  Clock clock;
  EXPECT_EQ(clock.advance(5s, app::fast_forward), 4 * Clock::catch_up);
  EXPECT_EQ(clock.advance(5s, app::slow_motion), Clock::catch_up);
}

TEST(Clock, TimeNeverRunsBackwards) {
  Clock clock;
  EXPECT_EQ(clock.advance(-5ms), 0);
  EXPECT_DOUBLE_EQ(clock.fraction(), 0);
}

}  // namespace
