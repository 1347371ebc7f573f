#pragma once

#include <cstdint>

#include "app/graphics/geometry.hpp"
#include "app/graphics/view.hpp"
#include "app/play/aim.hpp"
#include "app/view/viewport.hpp"

namespace app {

/// The pointer's button held somewhere to change an aim bit by bit, angle and strength apart. The
/// scales are in points of the screen, the same in every window.
class AimDrag {
 public:
  enum class On : std::uint8_t {
    world,  ///< turns by what is across the aim, 0.1° a point; a tap points where it is
    fine,   ///< across turns by 0.01° a point, up strengthens by 1 px/s a point; a tap on a side
            ///< makes one such step
    meter,  ///< sets the strength, from 0 at its left end to the greatest at its right end
  };
  /// The handles, window px.
  struct Place {
    Viewport viewport;
    View view;
    carom::Vec2 lead;  ///< world px
    Rect fine;
    Rect meter;
  };

  /// `before`: the aim to go back to when the drag is taken back.
  AimDrag(On on, Point at, const Aim& before) : on_(on), at_(at), before_(before) {}

  const Aim& before() const { return before_; }
  /// The pointer is at another place; `aim` is active.
  void move(Point at, Aim& aim, const Place& place);
  /// The button came up.
  void release(Point at, Aim& aim, const Place& place);

 private:
  On on_;
  Point at_;  ///< where it was held first, or began to move
  Aim before_;
  Aim from_;             ///< as it was when the pointer began to move
  bool moving_ = false;  ///< it is no tap any more
  bool across_ = false;  ///< it began to move across, not up or down
};

}  // namespace app
