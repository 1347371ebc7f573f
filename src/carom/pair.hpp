#pragma once

#include <cstddef>

#include "carom/scene.hpp"
#include "carom/vec2.hpp"

namespace carom {

inline constexpr double separation_factor = 1.01;  ///< distance after a collision (§1.2.3)
/// Within this times the sum of radii two balls touch: just above the separation, so that a
/// separated pair still does (spec §1).
inline constexpr double touching_factor = 1.02;

/// Two indices, first < second; compared in the order of spec §2.
struct Pair {
  std::size_t first = 0;
  std::size_t second = 0;
};

inline bool overlap(const Ball& a, const Ball& b) {
  const double sum = a.radius + b.radius;
  return length_squared(b.position - a.position) < sum * sum;
}

inline bool touch(const Ball& a, const Ball& b) {
  return length(b.position - a.position) <= touching_factor * (a.radius + b.radius);
}

}  // namespace carom
