#include "app/clock.hpp"

#include <algorithm>

#include "carom/world.hpp"

namespace app {

static_assert(Clock::step * carom::steps_per_second == std::chrono::seconds{1});

int Clock::advance(nanoseconds elapsed, int most) {
  remainder_ += std::max(elapsed, nanoseconds{0});
  const auto due = remainder_ / step;
  remainder_ %= step;
  return static_cast<int>(std::min<nanoseconds::rep>(due, most));
}

double Clock::fraction() const {
  return static_cast<double>(remainder_.count()) / static_cast<double>(step.count());
}

}  // namespace app
