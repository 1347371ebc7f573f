#include "carom/internal/time_scale.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "carom/world.hpp"

namespace carom {

namespace {

// The binary logarithm to three digits, by arithmetic alone, which gives the same bits everywhere.
// It only chooses where a table is looked at first.
double rough_log2(double positive) {
  const auto bits = std::bit_cast<std::uint64_t>(positive);
  const auto exponent = static_cast<double>(static_cast<int>(bits >> 52) - 1023);
  const auto m = std::bit_cast<double>((bits & 0xfffffffffffff) | 0x3ff0000000000000);
  return exponent - 2.1362321 + m * (3.0111622 + m * (-1.0268049 + m * 0.15270028));
}

}  // namespace

TimeScale::TimeScale(const Scene& scene) : straight(scene.gravity == 0 && scene.obstacles.empty()) {
  // From here on the clock's steps would be too small beside its time.
  constexpr double least_power = 1.0 / 1024;
  double f = 1;
  double way = 0;
  steps = most_steps;
  for (int m = 0; m <= most_steps + 1; ++m) {
    power[static_cast<std::size_t>(m)] = f;
    time[static_cast<std::size_t>(m)] = straight ? way : m;
    if (m <= steps) horizon = way;
    if (f < least_power && m > 0 && m < steps) steps = m;
    way += time_step * f;
    f *= scene.friction;
  }
  // Where f^m hardly falls, its rough logarithm tells nothing; there the clock is nearly even.
  const double least = power[static_cast<std::size_t>(steps)];
  if (least > 0.9) return;
  if (straight) rate_ = (1 - scene.friction) / time_step;
  per_log_ = steps / rough_log2(least);
}

// A guess as a place of the tables, from `from` on.
int TimeScale::place(double guess, int from) const {
  return guess > from ? static_cast<int>(std::min<double>(guess, steps)) : from;
}

int TimeScale::last_before(double end, int from) const {
  if (!(at(steps) >= end)) return steps;
  // end ≤ at(steps), so the share is about f^steps at least.
  const double share = 1 - rate_ * end;
  const double guess = rate_ > 0 ? rough_log2(share) * per_log_ : end / at(1);
  int m = place(guess, from);
  while (m > from && at(m) >= end) --m;
  while (m < steps && at(m + 1) < end) ++m;
  return m;
}

int TimeScale::first_slower(double share, int from) const {
  const auto slower = [&](int m) { return power[static_cast<std::size_t>(m)] <= share; };
  if (!slower(steps)) return steps + 1;
  const double guess = share < 1 ? rough_log2(share) * per_log_ : 0;
  int m = place(guess, from);
  while (m > from && slower(m - 1)) --m;
  while (m < steps && !slower(m)) ++m;
  return m;
}

}  // namespace carom
