#include "app/clock.hpp"

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

TEST(Clock, TimeNeverRunsBackwards) {
  Clock clock;
  EXPECT_EQ(clock.advance(-5ms), 0);
  EXPECT_DOUBLE_EQ(clock.fraction(), 0);
}

}  // namespace
