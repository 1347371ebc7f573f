#pragma once

#include <algorithm>
#include <cmath>

namespace app {

/// A point or vector of the window: px, x to the right, y down.
struct Point {
  float x = 0;
  float y = 0;

  friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Point operator*(Point a, float s) { return {a.x * s, a.y * s}; }
  friend constexpr bool operator==(Point a, Point b) = default;
};

constexpr float dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline float length(Point a) { return std::sqrt(dot(a, a)); }
/// Along `a`, of length 1; (1, 0) when `a` is zero.
inline Point unit(Point a) {
  const float norm = length(a);
  return norm > 0 ? a * (1 / norm) : Point{1, 0};
}
/// `a` turned by a right angle.
constexpr Point turned(Point a) { return {-a.y, a.x}; }

/// A rectangle of the window, px.
struct Rect {
  float x = 0;
  float y = 0;
  float w = 0;
  float h = 0;

  constexpr float right() const { return x + w; }
  constexpr float bottom() const { return y + h; }
  constexpr Point center() const { return {x + w / 2, y + h / 2}; }
  constexpr bool contains(Point p) const {
    return p.x >= x && p.x < right() && p.y >= y && p.y < bottom();
  }
  constexpr bool overlaps(const Rect& b) const {
    return x < b.right() && b.x < right() && y < b.bottom() && b.y < bottom();
  }
  /// Smaller by `by` on each side; larger when negative.
  constexpr Rect inset(float by) const { return inset(by, by); }
  constexpr Rect inset(float across, float down) const {
    return {x + across, y + down, w - 2 * across, h - 2 * down};
  }
  constexpr Rect moved(Point by) const { return {x + by.x, y + by.y, w, h}; }

  // Cutting a strip off one side; what remains stays in *this.
  Rect cut_left(float by) {
    const Rect strip{x, y, by, h};
    x += by;
    w -= by;
    return strip;
  }
  Rect cut_right(float by) {
    w -= by;
    return {x + w, y, by, h};
  }
  Rect cut_top(float by) {
    const Rect strip{x, y, w, by};
    y += by;
    h -= by;
    return strip;
  }
  Rect cut_bottom(float by) {
    h -= by;
    return {x, y + h, w, by};
  }
};

/// The rectangle of size `w` × `h` around a centre.
constexpr Rect centered(Point center, float w, float h) {
  return {center.x - w / 2, center.y - h / 2, w, h};
}

/// The least rectangle around both.
constexpr Rect united(const Rect& a, const Rect& b) {
  const float x = std::min(a.x, b.x);
  const float y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

/// `inner` pushed back into `outer`, where it has room.
constexpr Rect kept_inside(Rect inner, const Rect& outer) {
  inner.x = std::max(outer.x, std::min(inner.x, outer.right() - inner.w));
  inner.y = std::max(outer.y, std::min(inner.y, outer.bottom() - inner.h));
  return inner;
}

}  // namespace app
