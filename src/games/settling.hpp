#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "carom/world.hpp"

namespace games {

/// Settled means: no ball is lost or moves by settled_distance within settled_steps.
inline constexpr std::uint64_t settled_steps = 3000;
inline constexpr double settled_distance = 1;  ///< px

/// A measure of the work of a step, in ball-steps: one for each ball, more for fast balls, whose
/// steps are divided, and for many holes and obstacles.
std::uint64_t work_of_step(const carom::World& world);

struct Restless {
  std::uint32_t ball = 0;  ///< id
  bool lost = false;
  double distance = 0;  ///< px, the greatest, of one that is not lost
};

struct Settling {
  std::vector<Restless> restless;        ///< by id
  std::optional<std::uint32_t> falling;  ///< id of a ball that gravity pulls and nothing holds
  bool at_rest = true;                   ///< in the end: nothing is quick or pulled by a hole
  bool complete = true;                  ///< false when `work` was used up before settled_steps
  std::uint64_t work = 0;                ///< ball-steps taken
};

/// Looks ahead, in a copy, whether a world has settled. Takes at most about `most_work` ball-steps.
Settling look_ahead(carom::World world, std::uint64_t most_work);

}  // namespace games
