#pragma once

#include <span>
#include <vector>

#include "app/graphics/draw_list.hpp"

/// Shapes as triangles. Their edges are smoothed by a fringe of triangles, one pixel wide, that
/// fade to transparent: crisp at every size, without textures or multisampling.
namespace app {

/// A colour that varies linearly along one direction, or not at all.
class Paint {
 public:
  Paint(Color color) : from_(color), to_(color) {}
  /// `a` at point `start` and before, `b` at point `end` and beyond.
  Paint(Point start, Color a, Point end, Color b) : start_(start), from_(a), to_(b) {
    const Point way = end - start;
    const float square = dot(way, way);
    if (square > 0) axis_ = way * (1 / square);  // a box of no size has one colour
  }
  static Paint vertical(const Rect& box, Color top, Color bottom) {
    return {{box.x, box.y}, top, {box.x, box.bottom()}, bottom};
  }
  static Paint horizontal(const Rect& box, Color left, Color right) {
    return {{box.x, box.y}, left, {box.right(), box.y}, right};
  }

  Color at(Point p) const { return mix(from_, to_, dot(p - start_, axis_)); }

 private:
  Point start_;
  Point axis_;
  Color from_;
  Color to_;
};

/// Points along the edge of a convex shape, in order.
using Outline = std::vector<Point>;
Outline ellipse(Point center, float across, float down);
Outline circle(Point center, float radius);
Outline rounded(const Rect& box, float radius);
/// The edge of a line with round ends.
Outline capsule(Point from, Point to, float width);

inline constexpr float crisp = 1;  ///< px of fringe: the default

/// Fills a convex outline. A `feather` (px) beyond crisp makes a soft edge, as of a shadow.
void fill(DrawList& list, std::span<const Point> outline, const Paint& paint,
          float feather = crisp);
/// Draws along a closed convex outline, half of `width` on each side.
void stroke(DrawList& list, std::span<const Point> outline, float width, const Paint& paint);

void fill_disc(DrawList& list, Point center, float radius, const Paint& paint,
               float feather = crisp);
void fill_rounded(DrawList& list, const Rect& box, float radius, const Paint& paint,
                  float feather = crisp);
void stroke_circle(DrawList& list, Point center, float radius, float width, const Paint& paint);
void stroke_rounded(DrawList& list, const Rect& box, float radius, float width, const Paint& paint);
/// A line with square ends.
void line(DrawList& list, Point from, Point to, float width, const Paint& paint);
/// Dashes of length `dash`, gaps as long.
void dashed_line(DrawList& list, Point from, Point to, float width, float dash, Color color);
void dashed_circle(DrawList& list, Point center, float radius, float width, int dashes,
                   Color color);
/// Fills from a ridge, points from left to right, down to `bottom`.
void fill_under(DrawList& list, std::span<const Point> ridge, float bottom, const Paint& paint);
/// A light or shadow that fades smoothly from its centre to its edge.
void glow(DrawList& list, Point center, float across, float down, Color color);

/// Light that falls off from `center` to an ellipse.
struct Lamp {
  Point center;
  float across = 1;  ///< px, to the ellipse; above 0
  float down = 1;
  Color lit;   ///< what the centre looks like
  Color dark;  ///< and all beyond the ellipse

  /// 1 at the centre, 0 beyond the ellipse.
  float strength(Point p) const {
    const Point off{(p.x - center.x) / across, (p.y - center.y) / down};
    const float t = std::max(1 - dot(off, off), 0.0f);
    return t * t;
  }
};
/// Fills a box with a lamp's light, in one layer.
void fill_lamplit(DrawList& list, const Rect& box, const Lamp& lamp);
/// Fills between two closed outlines of as many points.
void fill_between(DrawList& list, std::span<const Point> a, Color color_a, std::span<const Point> b,
                  Color color_b);

/// Squeezes what was drawn from vertex `first` on into `area`: for what fades or is one colour
/// there.
void clip(DrawList& list, std::size_t first, const Rect& area);

}  // namespace app
