#include "app/graphics/crop.hpp"

namespace app {
namespace {

Vertex between(const Vertex& a, const Vertex& b, float t) {
  return {a.position + (b.position - a.position) * t, a.texture + (b.texture - a.texture) * t,
          mix(a.color, b.color, t)};
}

/// The part of a polygon on the inner side of a line (Sutherland and Hodgman, 1974). `depth`: how
/// far inside a point is.
template <class Depth>
std::vector<Vertex> cut(const std::vector<Vertex>& polygon, Depth depth) {
  std::vector<Vertex> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex& a = polygon[i];
    const Vertex& b = polygon[(i + 1) % polygon.size()];
    const float at_a = depth(a.position);
    const float at_b = depth(b.position);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(between(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

}  // namespace

void crop(DrawList& list, std::size_t first, const Rect& box) {
  const std::vector<std::int32_t> indices(list.indices.begin() + static_cast<std::ptrdiff_t>(first),
                                          list.indices.end());
  list.indices.resize(first);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::vector<Vertex> polygon;
    bool whole = true;
    for (std::size_t k = i; k < i + 3; ++k) {
      polygon.push_back(list.vertices[static_cast<std::size_t>(indices[k])]);
      whole &= box.contains(polygon.back().position);
    }
    if (whole) {
      list.triangle(indices[i], indices[i + 1], indices[i + 2]);
      continue;
    }
    polygon = cut(polygon, [&](Point p) { return p.x - box.x; });
    polygon = cut(polygon, [&](Point p) { return box.right() - p.x; });
    polygon = cut(polygon, [&](Point p) { return p.y - box.y; });
    polygon = cut(polygon, [&](Point p) { return box.bottom() - p.y; });
    if (polygon.size() < 3) continue;
    const auto base = static_cast<std::int32_t>(list.vertices.size());
    list.vertices.insert(list.vertices.end(), polygon.begin(), polygon.end());
    for (std::int32_t k = 2; k < static_cast<std::int32_t>(polygon.size()); ++k)
      list.triangle(base, base + k - 1, base + k);
  }
}

}  // namespace app
