#pragma once

#include <cstdint>

#include "carom/public.hpp"
#include "carom/result.hpp"
#include "carom/vec2.hpp"
#include "carom/world.hpp"

namespace CAROM_PUBLIC games {

inline constexpr double launch_factor = 5;        ///< 1/s, K (§1.4.1)
inline constexpr double max_launch_speed = 2000;  ///< px/s (§1.2.1)

/// px. Drags and places that players and searches make are multiples of it, finer than a window
/// pixel: the text of a replay stores such numbers compactly.
inline constexpr double grid = 1.0 / 64;

/// The nearest point of the grid.
carom::Vec2 on_grid(carom::Vec2 v);

/// Points of the i-th ball of a turn, i from 1 (§1.4.2, §2.3.1).
constexpr std::int64_t points_for(std::int64_t i) { return 100 * i; }

/// The velocity (px/s) a launch gives: launch_factor · drag, where drag (px) leads from the first
/// click to the second, its length capped at max_launch_speed (§1.4.1).
carom::Vec2 launch_velocity(carom::Vec2 drag);

/// The drag that gives a velocity (px/s), each coordinate to within the last bit: the other way
/// round. The greatest speed is capped as in launch_velocity.
carom::Vec2 launch_drag(carom::Vec2 velocity);

/// Gives the world's lead that velocity. Refuses a drag that is zero or not finite.
carom::Status launch(carom::World& world, carom::Vec2 drag);

}  // namespace games
