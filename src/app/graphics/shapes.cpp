#include "app/graphics/shapes.hpp"

#include <array>
#include <numbers>

#include "app/graphics/stamps.hpp"

namespace app {
namespace {

constexpr float tau = 2 * std::numbers::pi_v<float>;

/// Segments of a circle, so that none strays from it by more than a tenth of a pixel.
int segments(float radius) {
  const float step = std::acos(1 - 0.1f / std::max(radius, 1.0f));
  return std::clamp(static_cast<int>(std::ceil(tau / 2 / step)), 12, 160);
}

Point on_circle(float turn) { return {std::cos(tau * turn), std::sin(tau * turn)}; }

void arc(Outline& outline, Point center, float radius, float from, float to) {
  const int steps = std::max(
      2, static_cast<int>(std::lround(static_cast<float>(segments(radius)) * (to - from))));
  for (int i = 0; i <= steps; ++i) {
    const float turn = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps);
    outline.push_back(center + on_circle(turn) * radius);
  }
}

/// At each point, the way outwards that moves both edges there by one pixel.
std::vector<Point> mitres(std::span<const Point> outline) {
  const std::size_t n = outline.size();
  float area = 0;
  for (std::size_t i = 0; i < n; ++i) area += dot(turned(outline[i]), outline[(i + 1) % n]);
  const float side = area > 0 ? -1.0f : 1.0f;

  std::vector<Point> ways(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point before = turned(unit(outline[i] - outline[(i + n - 1) % n])) * side;
    const Point after = turned(unit(outline[(i + 1) % n] - outline[i])) * side;
    const Point sum = before + after;
    // A needle's mitre would reach to infinity: at most four times the fringe.
    ways[i] = sum * (2 / std::max(dot(sum, sum), 0.25f));
  }
  return ways;
}

Color clear(Color color) { return {color.r, color.g, color.b, 0}; }

/// Joins two rings of `n` vertices that start at indices `a` and `b`.
void bridge(DrawList& list, std::int32_t a, std::int32_t b, std::int32_t n) {
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t next = (i + 1) % n;
    list.quad(a + i, a + next, b + next, b + i);
  }
}

}  // namespace

Outline ellipse(Point center, float across, float down) {
  const int n = segments(std::max(across, down));
  Outline outline;
  for (int i = 0; i < n; ++i) {
    const Point way = on_circle(static_cast<float>(i) / static_cast<float>(n));
    outline.push_back({center.x + way.x * across, center.y + way.y * down});
  }
  return outline;
}

Outline circle(Point center, float radius) { return ellipse(center, radius, radius); }

Outline rounded(const Rect& box, float radius) {
  radius = std::min({radius, box.w / 2, box.h / 2});
  if (radius <= 0)
    return {
        {box.right(), box.bottom()}, {box.x, box.bottom()}, {box.x, box.y}, {box.right(), box.y}};
  Outline outline;
  arc(outline, {box.right() - radius, box.bottom() - radius}, radius, 0, 0.25f);
  arc(outline, {box.x + radius, box.bottom() - radius}, radius, 0.25f, 0.5f);
  arc(outline, {box.x + radius, box.y + radius}, radius, 0.5f, 0.75f);
  arc(outline, {box.right() - radius, box.y + radius}, radius, 0.75f, 1);
  return outline;
}

Outline capsule(Point from, Point to, float width) {
  const Point way = to - from;
  const float turn = std::atan2(way.y, way.x) / tau;
  Outline outline;
  arc(outline, to, width / 2, turn - 0.25f, turn + 0.25f);
  arc(outline, from, width / 2, turn + 0.25f, turn + 0.75f);
  return outline;
}

void fill(DrawList& list, std::span<const Point> outline, const Paint& paint, float feather) {
  const auto n = static_cast<std::int32_t>(outline.size());
  const std::vector<Point> ways = mitres(outline);
  const auto inner = static_cast<std::int32_t>(list.vertices.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
    list.add(outline[i] - ways[i] * (feather / 2), paint.at(outline[i]));
  for (std::size_t i = 0; i < outline.size(); ++i)
    list.add(outline[i] + ways[i] * (feather / 2), clear(paint.at(outline[i])));
  for (std::int32_t i = 1; i + 1 < n; ++i) list.triangle(inner, inner + i, inner + i + 1);
  bridge(list, inner, inner + n, n);
}

void stroke(DrawList& list, std::span<const Point> outline, float width, const Paint& paint) {
  const auto n = static_cast<std::int32_t>(outline.size());
  const std::vector<Point> ways = mitres(outline);
  // Thinner than a pixel cannot be drawn: a pixel wide, and paler.
  const float opacity = std::min(width, 1.0f);
  const float half = std::max(width, 1.0f) / 2;
  const auto first = static_cast<std::int32_t>(list.vertices.size());
  const std::array<float, 4> offsets{-half - crisp / 2, -half + crisp / 2, half - crisp / 2,
                                     half + crisp / 2};
  for (std::size_t ring = 0; ring < offsets.size(); ++ring) {
    const bool solid = ring == 1 || ring == 2;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Color color = faded(paint.at(outline[i]), opacity);
      list.add(outline[i] + ways[i] * offsets[ring], solid ? color : clear(color));
    }
  }
  for (std::int32_t ring = 0; ring < 3; ++ring)
    bridge(list, first + ring * n, first + (ring + 1) * n, n);
}

void fill_disc(DrawList& list, Point center, float radius, const Paint& paint, float feather) {
  fill(list, circle(center, radius), paint, feather);
}

void fill_rounded(DrawList& list, const Rect& box, float radius, const Paint& paint,
                  float feather) {
  fill(list, rounded(box, radius), paint, feather);
}

void stroke_circle(DrawList& list, Point center, float radius, float width, const Paint& paint) {
  stroke(list, circle(center, radius), width, paint);
}

void stroke_rounded(DrawList& list, const Rect& box, float radius, float width,
                    const Paint& paint) {
  stroke(list, rounded(box, radius), width, paint);
}

void line(DrawList& list, Point from, Point to, float width, const Paint& paint) {
  const Point across = turned(unit(to - from)) * (std::max(width, 1.0f) / 2);
  fill(list, std::array{from - across, to - across, to + across, from + across}, paint);
}

void dashed_line(DrawList& list, Point from, Point to, float width, float dash, Color color) {
  const float total = length(to - from);
  const Point way = unit(to - from);
  const int dashes = static_cast<int>(std::ceil(total / (2 * dash)));
  for (int i = 0; i < dashes; ++i) {
    const float at = 2 * dash * static_cast<float>(i);
    line(list, from + way * at, from + way * std::min(at + dash, total), width, color);
  }
}

void dashed_circle(DrawList& list, Point center, float radius, float width, int dashes,
                   Color color) {
  for (int i = 0; i < dashes; ++i) {
    const float turn = static_cast<float>(i) / static_cast<float>(dashes);
    const float end = turn + 0.5f / static_cast<float>(dashes);
    line(list, center + on_circle(turn) * radius, center + on_circle(end) * radius, width, color);
  }
}

void fill_under(DrawList& list, std::span<const Point> ridge, float bottom, const Paint& paint) {
  std::int32_t previous = 0;
  for (std::size_t i = 0; i < ridge.size(); ++i) {
    const Point p = ridge[i];
    const std::int32_t top = list.add(p - Point{0, crisp / 2}, clear(paint.at(p)));
    list.add(p + Point{0, crisp / 2}, paint.at(p));
    list.add({p.x, bottom}, paint.at({p.x, bottom}));
    if (i > 0) {
      list.quad(previous, top, top + 1, previous + 1);
      list.quad(previous + 1, top + 1, top + 2, previous + 2);
    }
    previous = top;
  }
}

void fill_lamplit(DrawList& list, const Rect& box, const Lamp& lamp) {
  if (box.w <= 0 || box.h <= 0) return;
  const auto cells = [](float length, float reach) {
    return static_cast<std::int32_t>(std::clamp(std::ceil(12 * length / reach), 1.0f, 32.0f));
  };
  const std::int32_t columns = cells(box.w, lamp.across);
  const std::int32_t rows = cells(box.h, lamp.down);
  for (std::int32_t row = 0; row <= rows; ++row) {
    for (std::int32_t column = 0; column <= columns; ++column) {
      const Point p{box.x + box.w * static_cast<float>(column) / static_cast<float>(columns),
                    box.y + box.h * static_cast<float>(row) / static_cast<float>(rows)};
      const std::int32_t at = list.add(p, mix(lamp.dark, lamp.lit, lamp.strength(p)));
      if (row > 0 && column > 0) list.quad(at - columns - 2, at - columns - 1, at, at - 1);
    }
  }
}

void fill_between(DrawList& list, std::span<const Point> a, Color color_a, std::span<const Point> b,
                  Color color_b) {
  const auto n = static_cast<std::int32_t>(std::min(a.size(), b.size()));
  const auto first = static_cast<std::int32_t>(list.vertices.size());
  for (std::int32_t i = 0; i < n; ++i) list.add(a[static_cast<std::size_t>(i)], color_a);
  for (std::int32_t i = 0; i < n; ++i) list.add(b[static_cast<std::size_t>(i)], color_b);
  bridge(list, first, first + n, n);
}

void clip(DrawList& list, std::size_t first, const Rect& area) {
  if (area.w < 0 || area.h < 0) return;  // a window of next to no size
  for (std::size_t i = first; i < list.vertices.size(); ++i) {
    Point& p = list.vertices[i].position;
    p = {std::clamp(p.x, area.x, area.right()), std::clamp(p.y, area.y, area.bottom())};
  }
}

namespace {

void glow_in_triangles(DrawList& list, Point center, float across, float down, Color color) {
  constexpr int rings = 6;
  // Its edge cannot be seen: half the corners of a disc do.
  const std::int32_t n = std::max(segments(std::max(across, down)) / 2, 12);
  const std::int32_t middle = list.add(center, color);
  for (int ring = 1; ring <= rings; ++ring) {
    const float t = static_cast<float>(ring) / rings;
    const float opacity = (1 - t * t) * (1 - t * t);
    for (std::int32_t i = 0; i < n; ++i) {
      const Point way = on_circle(static_cast<float>(i) / static_cast<float>(n));
      list.add({center.x + way.x * across * t, center.y + way.y * down * t}, faded(color, opacity));
    }
  }
  for (std::int32_t i = 0; i < n; ++i)
    list.triangle(middle, middle + 1 + i, middle + 1 + (i + 1) % n);
  for (std::int32_t ring = 1; ring < rings; ++ring)
    bridge(list, middle + 1 + (ring - 1) * n, middle + 1 + ring * n, n);
}

}  // namespace

void glow(DrawList& list, Point center, float across, float down, Color color) {
  // One picture for all: it has no edge that stretching would blur.
  constexpr float radius = 16;
  const auto draw = [](DrawList& on, Point c, float r) {
    glow_in_triangles(on, c, r, r, {255, 255, 255, 255});
  };
  const bool small = std::max(across, down) <= 4 * radius;
  if (!small || !list.stamps ||
      !list.stamps->stretch(list, {Stamps::Key::Of::glow, radius}, center, radius, across, down,
                            color, draw))
    glow_in_triangles(list, center, across, down, color);
}

}  // namespace app
