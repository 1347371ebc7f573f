#pragma once

#include <array>
#include <cstddef>

#include "carom/scene.hpp"

namespace carom {

/// The clock of a Forecast, in which it notes when balls may meet.
///
/// Without gravity and obstacles every ball that meets nothing has the same friction f, so after m
/// steps it has gone its velocity times T(m) = Σ h·fⁱ, i < m: on this clock it moves straight at
/// constant speed. Elsewhere there is no such clock, only bounds: it counts the steps.
struct TimeScale {
  explicit TimeScale(const Scene& scene);

  /// The clock begins anew after so many steps at the latest.
  static constexpr int most_steps = 1023;

  bool straight = true;  ///< balls move straight at constant speed on this clock
  int steps = 0;         ///< after which it begins anew: until then no digits are lost in f^m
  double horizon = 0;    ///< s, the longest way of a ball until then, divided by its speed
  std::array<double, most_steps + 2> power{};  ///< f^m
  std::array<double, most_steps + 2> time{};   ///< of the clock after m steps

  /// What a unit of the clock is worth after m steps.
  double unit(int m) const { return straight ? power[static_cast<std::size_t>(m)] : 1; }
  double at(int m) const { return time[static_cast<std::size_t>(m)]; }
};

}  // namespace carom
