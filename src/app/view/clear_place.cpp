#include "app/view/clear_place.hpp"

#include <algorithm>

namespace app {

std::vector<Rect> things_in(const carom::World& world, const Viewport& viewport) {
  constexpr std::size_t most = 100;  // there is no clear place among more
  std::vector<Rect> things;
  const auto add = [&](carom::Vec2 at, double radius) {
    if (things.size() == most) return;
    const float size = 2 * viewport.px(radius);
    things.push_back(centered(viewport.to_window(at), size, size));
  };
  for (const carom::Hole& hole : world.scene().holes) add(hole.position, hole.radius);
  for (std::size_t i = 0; i < std::min(world.size(), most); ++i)
    if (world.in_play(i)) add(world.ball(i).position, world.ball(i).radius);
  return things;
}

std::size_t covered(const Rect& box, std::span<const Rect> things) {
  return static_cast<std::size_t>(
      std::ranges::count_if(things, [&](const Rect& thing) { return box.overlaps(thing); }));
}

Rect clear_place(const Rect& box, const Rect& area, std::span<const Rect> things) {
  constexpr int parts = 24;
  Rect best = kept_inside(box, area);
  std::size_t least = covered(best, things);
  const bool anything = least > 0;
  float way = 0;
  for (int across = 0; across <= parts && anything; ++across) {
    for (int down = 0; down <= parts; ++down) {
      const Rect tried{area.x + (area.w - box.w) * static_cast<float>(across) / parts,
                       area.y + (area.h - box.h) * static_cast<float>(down) / parts, box.w, box.h};
      if (tried.x < area.x || tried.y < area.y) continue;  // there is no room at all
      const std::size_t count = covered(tried, things);
      const float to = length(tried.center() - box.center());
      if (count > least || (count == least && to >= way)) continue;
      best = tried;
      least = count;
      way = to;
    }
  }
  return best;
}

}  // namespace app
