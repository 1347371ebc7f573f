#include "app/viewport.hpp"

namespace app {

Viewport::Viewport(const Rect& area, carom::Vec2 size, double margin)
    : Viewport(area, {-margin, -margin}, {size.x + margin, size.y + margin}) {}

Viewport::Viewport(const Rect& area, carom::Vec2 from, carom::Vec2 to) {
  const carom::Vec2 size = to - from;
  // A window may be squeezed to nothing; the scale stays positive for to_world.
  scale_ = std::max(
      std::min(static_cast<double>(area.w) / size.x, static_cast<double>(area.h) / size.y), 1e-9);
  const Point middle = area.center();
  const carom::Vec2 center = 0.5 * (from + to);
  origin_ = {std::round(static_cast<double>(middle.x) - center.x * scale_),
             std::round(static_cast<double>(middle.y) + center.y * scale_)};
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
