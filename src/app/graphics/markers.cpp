#include "app/graphics/markers.hpp"

#include <array>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {

void draw_marker(DrawList& list, int player, Point center, float radius, float opacity) {
  const Color accent = list.palette->accents[static_cast<std::size_t>(player)];
  draw_marker(list, player, center, radius, faded(accent, opacity));
}

void draw_marker(DrawList& list, int player, Point center, float radius, Color color) {
  if (player == 0) {
    const std::array diamond{Point{center.x, center.y - radius}, Point{center.x + radius, center.y},
                             Point{center.x, center.y + radius},
                             Point{center.x - radius, center.y}};
    fill(list, diamond, color);
  } else {
    const float width = radius * 0.42f;
    stroke_circle(list, center, radius * 0.92f - width / 2, width, color);
  }
}

}  // namespace app
