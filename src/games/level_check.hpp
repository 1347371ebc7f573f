#pragma once

#include <cstdint>
#include <functional>

#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace games::angry_balls {

/// Limit of level_report(), in ball-steps (games::work_of_step): some seconds.
inline constexpr std::uint64_t level_check_budget = 16'000'000;

struct LevelReport {
  /// A player's objections to the level, pointers as in its file.
  carom::Errors warnings;
  /// True if all was tried. If not, the last warning says what was left out.
  bool complete = true;
};

/// A player's objections to a sound level, found by trying:
/// - sizes and gravity as if lengths were metres: everything counts as standing still,
/// - balls that lie on the launch place, and a launch place within a hole or outside the level,
/// - balls that do not stay where they were put while nothing is thrown,
/// - a throw after which the balls never come to rest,
/// - enemies that none of a fan of throws, all directions and strengths, wears down, pockets or
///   drives out,
/// - a solidity given to the projectile, which has no effect.
/// Tells `tell` now and then which part of the budget is used up, from 0 to 1.
LevelReport level_report(const carom::Scene& level, std::uint64_t budget = level_check_budget,
                         const std::function<void(double)>& tell = {});

/// Only the warnings.
carom::Errors level_warnings(const carom::Scene& level);

}  // namespace games::angry_balls
