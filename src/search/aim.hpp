#pragma once

#include "carom/vec2.hpp"

namespace search {

/// A launch as a player can type it: whole tenths of a degree, whole px/s.
struct Aim {
  /// 0.1°, counterclockwise from the direction to the right, in (−1800, 1800].
  int tenths = 0;
  int speed = 500;  ///< px/s, in [least_speed, greatest_speed]
  friend bool operator==(const Aim&, const Aim&) = default;
};

inline constexpr int least_speed = 31;       ///< px/s, just above carom::rest_speed
inline constexpr int greatest_speed = 2000;  ///< px/s, games::max_launch_speed

/// The unit vector at so many degrees, counterclockwise from the right: within 2⁻⁵² of the exact
/// one, with the same bits everywhere; exact at multiples of 90°. |degrees| at most 10⁶.
carom::Vec2 direction(double degrees);

/// Positive if `b` is counterclockwise from `a`, by less than half a turn.
constexpr double cross(carom::Vec2 a, carom::Vec2 b) { return a.x * b.y - a.y * b.x; }

/// `aim` turned by tenths of a degree, at most 3600 either way.
constexpr Aim turned(Aim aim, int tenths) {
  aim.tenths += tenths;
  if (aim.tenths > 1800) aim.tenths -= 3600;
  if (aim.tenths <= -1800) aim.tenths += 3600;
  return aim;
}

/// The drag (px) of an aim, on the grid (games::on_grid): what Shoot and Throw take.
carom::Vec2 drag(const Aim& aim);

/// The aim nearest to a velocity (px/s) in direction and in speed, each for itself; the velocity is
/// not zero.
Aim nearest_aim(carom::Vec2 velocity);

}  // namespace search
