#include "app/view/viewport.hpp"

namespace app {

Viewport::Viewport(const Rect& area, carom::Vec2 from, carom::Vec2 to, bool turned)
    : turned_(turned) {
  const carom::Vec2 size = turned ? carom::Vec2{to.y - from.y, to.x - from.x} : to - from;
  // A window may be squeezed to nothing; the scale stays positive for to_world.
  scale_ = std::max(
      std::min(static_cast<double>(area.w) / size.x, static_cast<double>(area.h) / size.y), 1e-9);
  const Point middle = area.center();
  const carom::Vec2 center = as_seen(0.5 * (from + to));
  origin_ = {std::round(static_cast<double>(middle.x) - center.x * scale_),
             std::round(static_cast<double>(middle.y) + center.y * scale_)};
}

Point Viewport::to_window(carom::Vec2 world) const {
  const carom::Vec2 seen = as_seen(world);
  return {static_cast<float>(origin_.x + seen.x * scale_),
          static_cast<float>(origin_.y - seen.y * scale_)};
}

carom::Vec2 Viewport::to_world(Point window) const {
  return seen_as({(static_cast<double>(window.x) - origin_.x) / scale_,
                  (origin_.y - static_cast<double>(window.y)) / scale_});
}

Rect Viewport::to_window(carom::Vec2 from, carom::Vec2 to) const {
  const Point a = to_window(from);
  const Point b = to_window(to);
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(b.x - a.x), std::abs(b.y - a.y)};
}

}  // namespace app
