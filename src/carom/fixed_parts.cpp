#include "carom/internal/fixed_parts.hpp"

#include <algorithm>
#include <array>

namespace carom {

// Each hole is cut off by the edge of the box that it costs least to move.
Box hole_free_box(const Scene& scene) {
  Box box{{0, 0}, {scene.width, scene.height}};
  for (const Hole& hole : scene.holes) {
    const double left = hole.position.x - hole.radius;
    const double right = hole.position.x + hole.radius;
    const double bottom = hole.position.y - hole.radius;
    const double top = hole.position.y + hole.radius;
    if (right <= box.low.x || left >= box.high.x || top <= box.low.y || bottom >= box.high.y)
      continue;
    const std::array<double, 4> costs{right - box.low.x, box.high.x - left, top - box.low.y,
                                      box.high.y - bottom};
    const auto least = std::min_element(costs.begin(), costs.end()) - costs.begin();
    if (least == 0) box.low.x = right;
    if (least == 1) box.high.x = left;
    if (least == 2) box.low.y = top;
    if (least == 3) box.high.y = bottom;
  }
  return box;
}

RoundedHoles::RoundedHoles(const Scene& scene) {
  x.fill(1e8F);
  y.fill(1e8F);
  radius.fill(0);
  for (std::size_t n = 0; n < std::min(scene.holes.size(), most); ++n) {
    x[n] = static_cast<float>(scene.holes[n].position.x);
    y[n] = static_cast<float>(scene.holes[n].position.y);
    radius[n] = static_cast<float>(scene.holes[n].radius);
  }
}

}  // namespace carom
