#pragma once

#include "app/geometry.hpp"
#include "carom/vec2.hpp"

namespace app {

/// Shows a part of the world (px, y up) in a part of the window (px, y down): as large as fits,
/// never distorted, in the middle.
class Viewport {
 public:
  Viewport() = default;
  /// The world from (0, 0) to `size`, with a `margin` (world px) around it, shown within `area`.
  Viewport(const Rect& area, carom::Vec2 size, double margin);
  /// The world between two corners, the lower left and the upper right one.
  Viewport(const Rect& area, carom::Vec2 from, carom::Vec2 to);

  Point to_window(carom::Vec2 world) const;
  carom::Vec2 to_world(Point window) const;
  /// Window px a world px.
  double scale() const { return scale_; }
  float px(double world_length) const { return static_cast<float>(world_length * scale_); }

 private:
  double scale_ = 1;
  carom::Vec2 origin_;  ///< the world's (0, 0), in window px: a whole pixel
};

}  // namespace app
