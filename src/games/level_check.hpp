#pragma once

#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace games::angry_balls {

/// The faults of a sound level that a player would notice, found by trying (pointers as in its
/// file; empty when nothing was found):
/// - balls that do not stay where they were put while nothing is thrown,
/// - balls that lie on the launch place,
/// - enemies that none of a fan of throws, all directions and strengths, wears down, pockets or
///   drives out,
/// - a solidity given to the projectile, which has no effect.
/// Takes up to some seconds for a level of many balls.
carom::Errors level_warnings(const carom::Scene& level);

}  // namespace games::angry_balls
