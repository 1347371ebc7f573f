#pragma once

#include <optional>

#include "carom/vec2.hpp"

namespace app {

/// A launch in two clicks (§1.4.1): the first takes the ball, the second sends it; the drag leads
/// from the one to the other.
class Aim {
 public:
  /// The first click. `at`: world px.
  void begin(carom::Vec2 at);
  /// The pointer's place; it counts only after the first click.
  void move(carom::Vec2 to);
  /// Takes the first click back.
  void cancel();

  bool active() const { return from_.has_value(); }
  /// World px, on the grid of replays (grid.hpp); zero when not active.
  carom::Vec2 drag() const;
  /// The launch that a click would give now, px/s.
  carom::Vec2 velocity() const;
  double speed() const { return carom::length(velocity()); }
  /// Speed as a part of the greatest, in [0, 1].
  double strength() const;
  /// The drag asks for more than the greatest speed.
  bool capped() const;
  /// The ball would count as standing: no launch at all.
  bool too_weak() const;

 private:
  std::optional<carom::Vec2> from_;
  carom::Vec2 to_;
};

}  // namespace app
