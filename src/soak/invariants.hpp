#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carom/scene.hpp"
#include "carom/world.hpp"

namespace soak {

/// Invariants after every step of a world, whatever happened in it:
/// - every number of every ball is finite (a solidity may be infinite);
/// - no ball sticks out of a solid edge;
/// - no ball appears: those in play are some of those before, each under its own id;
/// - energy comes only from gravity and holes. In a step that is not divided the sum of the squares
///   of the speeds ends at most at that of |f·v + a·dt| with the v and a from before the step;
///   rounding apart, no collision adds to it. In a divided step the accelerations within are not
///   known, but their bounds are: gravity, and half of the hole pull within a hole.
class Invariants {
 public:
  /// `world`: as it is now, before a step.
  void before_step(const carom::World& world);

  /// Returns the invariant that the step broke; none if it broke none.
  std::optional<std::string> after_step(const carom::World& world);

 private:
  double energy_bound(const carom::Scene& fixed) const;

  std::vector<carom::Ball> before_;  // in play
  std::vector<bool> present_;        // by id: was in play and has not been seen yet
};

}  // namespace soak
