#include "app/play/clock.hpp"

#include <algorithm>

#include "carom/world.hpp"

namespace app {

static_assert(Clock::step * carom::steps_per_second == seconds{1});

namespace {
/// Quarters of a nanosecond: no speed rounds any time away.
constexpr nanoseconds::rep whole = 4 * Clock::step.count();
}  // namespace

int Clock::advance(nanoseconds elapsed, Speed speed) {
  remainder_ += std::max(elapsed, nanoseconds{0}).count() * speed.quarters;
  const auto due = remainder_ / whole;
  remainder_ %= whole;
  return static_cast<int>(std::min<nanoseconds::rep>(
      due, nanoseconds::rep{catch_up} * std::max(speed.quarters / 4, 1)));
}

double Clock::fraction() const {
  return static_cast<double>(remainder_) / static_cast<double>(whole);
}

}  // namespace app
