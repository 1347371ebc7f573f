#include "app/viewport.hpp"

namespace app {

Viewport::Viewport(const Rect& area, carom::Vec2 size, double margin) {
  const double across = size.x + 2 * margin;
  const double down = size.y + 2 * margin;
  // A window may be squeezed to nothing; the scale stays positive for to_world.
  scale_ = std::max(
      std::min(static_cast<double>(area.w) / across, static_cast<double>(area.h) / down), 0.01);
  const Point middle = area.center();
  origin_ = {static_cast<double>(middle.x) - size.x / 2 * scale_,
             static_cast<double>(middle.y) + size.y / 2 * scale_};
}

Point Viewport::to_window(carom::Vec2 world) const {
  return {static_cast<float>(origin_.x + world.x * scale_),
          static_cast<float>(origin_.y - world.y * scale_)};
}

carom::Vec2 Viewport::to_world(Point window) const {
  return {(static_cast<double>(window.x) - origin_.x) / scale_,
          (origin_.y - static_cast<double>(window.y)) / scale_};
}

}  // namespace app
