#pragma once

#include <optional>

#include "carom/vec2.hpp"

namespace app {

/// The least strength that keys and fields can set, px/s: just above carom::rest_speed, so that the
/// nearest point of the grid is a launch as well.
inline constexpr double least_aim_speed = 31;

/// The launch that is being aimed: one direction and strength that every device edits.
///
/// A launch lies on the grid of replays (games::on_grid): drag() is the grid point nearest
/// to what was set, so it can be up to 0.06 px/s off, and 0.02° at 200 px/s. The exact value is
/// stored beneath, so small steps add up: ten of 0.1° are 1°.
class Aim {
 public:
  /// Starts, or goes on, with this drag (world px, from the first click to the second, §1.4.1).
  void set(carom::Vec2 drag) { exact_ = drag; }
  void cancel() { exact_.reset(); }

  // These do nothing when not active.
  /// Turns counterclockwise. A drag of zero points to the right.
  void turn(double degrees);
  /// Keeps the strength and points along `way` (not zero).
  void point(carom::Vec2 way);
  /// The angle above the direction to the right, counterclockwise.
  void set_degrees(double degrees);
  /// px/s, taken as the nearest in [least_aim_speed, games::max_launch_speed].
  void set_speed(double speed);
  /// set_speed() of so much more.
  void strengthen(double by);

  bool active() const { return exact_.has_value(); }
  /// World px, on the grid; zero when not active.
  carom::Vec2 drag() const;
  /// The velocity that it launches with, px/s.
  carom::Vec2 velocity() const;
  double speed() const { return carom::length(velocity()); }
  /// In (−180, 180], of what is launched.
  double degrees() const;
  /// Speed as a part of the greatest, in [0, 1].
  double strength() const;
  /// The drag asks for more than the greatest speed.
  bool capped() const;
  /// The ball would count as standing: no launch at all.
  bool too_weak() const;

 private:
  std::optional<carom::Vec2> exact_;  ///< px
};

}  // namespace app
