#include "app/hud/loupe.hpp"

#include <array>

#include "app/graphics/crop.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/hud/aim_view.hpp"

namespace app {
namespace {

constexpr float side = 132;       ///< points of the screen
constexpr double magnified = 3;   ///< times
constexpr float least_share = 3;  ///< of the world's lower side, at most one part of so many

Rect corner_away_from(const Rect& world, float size, float gap, Point hand, Point lead) {
  const Rect places = world.inset(gap + size / 2);
  Rect best;
  float most = -1;
  for (const Point at : {Point{places.x, places.y},
                         {places.right(), places.y},
                         {places.x, places.bottom()},
                         {places.right(), places.bottom()}}) {
    const float away = std::min(length(at - hand), length(at - lead));
    if (away <= most) continue;
    most = away;
    best = centered(at, size, size);
  }
  return best;
}

}  // namespace

void draw_loupe(Canvas& canvas, const WorldView& view, const carom::World& world,
                const Interpolator& motion, const Aim& aim, const Preview& preview, Point hand) {
  DrawList& list = canvas.list;
  const float size =
      std::min(side * canvas.view.density, std::min(view.area().w, view.area().h) / least_share);
  const Point lead = view.viewport().to_window(world.ball(0).position);
  const Rect box = corner_away_from(view.area(), size, canvas.px(8), hand, lead);
  const WorldView near =
      view.magnified(box, preview.ghost.value_or(world.ball(0).position), magnified);
  const float corner = canvas.px(10);
  fill_rounded(list, box.inset(-canvas.px(3)), corner, faded(palette::ink, 0.7f));
  const std::size_t first = list.indices.size();
  const std::size_t boxes = list.boxes.size();
  near.draw_still(canvas);
  near.draw_moving(canvas, world, motion, 1);
  draw_aim(list, near.viewport(), world, aim, preview);
  list.boxes.resize(boxes);
  crop(list, first, box);
  stroke_rounded(list, box.inset(-canvas.px(1)), canvas.px(4), canvas.px(3), palette::brass);
}

}  // namespace app
