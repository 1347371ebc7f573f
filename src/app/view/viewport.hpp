#pragma once

#include "app/graphics/geometry.hpp"
#include "carom/vec2.hpp"

namespace app {

/// Shows a part of the world (px, y up) in a part of the window (px, y down): as large as fits,
/// never distorted, in the middle; turned by a quarter to the left where that is asked for.
class Viewport {
 public:
  Viewport() = default;
  /// The world between two corners, the lower left and the upper right one, shown within `area`.
  Viewport(const Rect& area, carom::Vec2 from, carom::Vec2 to, bool turned = false);

  Point to_window(carom::Vec2 world) const;
  carom::Vec2 to_world(Point window) const;
  /// The area of the world between two corners, window px.
  Rect to_window(carom::Vec2 from, carom::Vec2 to) const;
  /// The vector of the world that is seen as `way` (y up).
  carom::Vec2 seen_as(carom::Vec2 way) const { return turned_ ? carom::Vec2{way.y, -way.x} : way; }
  bool turned() const { return turned_; }
  /// Window px a world px.
  double scale() const { return scale_; }
  float px(double world_length) const { return static_cast<float>(world_length * scale_); }

 private:
  /// A vector of the world as it is seen (y up).
  carom::Vec2 as_seen(carom::Vec2 world) const {
    return turned_ ? carom::Vec2{-world.y, world.x} : world;
  }

  double scale_ = 1;
  bool turned_ = false;
  carom::Vec2 origin_;  ///< the world's (0, 0), in window px: a whole pixel
};

}  // namespace app
