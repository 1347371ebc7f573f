#pragma once

#include <cmath>
#include <cstddef>

#include "carom/balls.hpp"
#include "carom/quadtree.hpp"
#include "carom/vec2.hpp"

namespace carom {

inline constexpr double separation_factor = 1.01;  ///< distance after a collision (§1.2.3)
/// Within this times the sum of radii two balls touch: just above the separation, so that a
/// separated pair still does (docs/physics.md).
inline constexpr double touching_factor = 1.02;
/// Balls enlarged by this reach into an obstacle's box, enlarged too, when its cap supports them.
inline constexpr double box_factor = 1.03;

[[gnu::always_inline]] inline bool overlap(const Balls& balls, std::size_t i, std::size_t j) {
  const double sum = balls.radius[i] + balls.radius[j];
  return length_squared(balls.position(j) - balls.position(i)) < sum * sum;
}

[[gnu::always_inline]] inline bool touch(const Balls& balls, std::size_t i, std::size_t j) {
  const double reach = touching_factor * (balls.radius[i] + balls.radius[j]);
  const double squared = length_squared(balls.position(j) - balls.position(i));
  // The root is rounded, so it decides where the squares are equal to within rounding; elsewhere
  // they tell the same without it.
  const double reach_squared = reach * reach;
  const bool near = squared <= reach_squared * (1 + 1e-12);
  if (near & (squared >= reach_squared * (1 - 1e-12))) return std::sqrt(squared) <= reach;
  return near;
}

}  // namespace carom
