#pragma once

#include <array>
#include <cstddef>

#include "carom/scene.hpp"

namespace carom {

/// The clock of a Forecast. Without gravity and obstacles all balls share the friction f, so one
/// that meets nothing has gone v·Σ h·f^i (i < m) after m steps: on a clock that shows this sum
/// instead of m·h it moves straight at constant speed. In other scenes the clock counts steps.
struct TimeScale {
  explicit TimeScale(const Scene& scene);

  /// The clock begins anew after so many steps at the latest.
  static constexpr int most_steps = 1023;

  bool straight = true;  ///< balls move straight at constant speed on this clock
  int steps = 0;         ///< after which it begins anew: until then no digits are lost in f^m
  double horizon = 0;    ///< s, the longest way of a ball until then, divided by its speed
  std::array<double, most_steps + 2> power{};  ///< f^m
  std::array<double, most_steps + 2> time{};   ///< of the clock after m steps

  /// The worth of a unit of the clock after m steps.
  double unit(int m) const { return straight ? power[static_cast<std::size_t>(m)] : 1; }
  double at(int m) const { return time[static_cast<std::size_t>(m)]; }

  /// The last m ≤ steps with at(m) < end, or `from`, if that is later; from ≤ steps.
  int last_before(double end, int from) const;
  /// The first m ≥ from with f^m ≤ share; steps + 1, if there is none up to `steps`.
  int first_slower(double share, int from) const;

 private:
  int place(double guess, int from) const;

  double rate_ = 0;     ///< f^m = 1 - rate·at(m), or 0: all steps of the clock are about as long
  double per_log_ = 0;  ///< m / log2(f^m), or 0
};

}  // namespace carom
