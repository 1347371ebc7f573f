#include "app/view/world_view.hpp"

#include "app/view/level_view.hpp"
#include "app/view/table_view.hpp"

namespace app {

void WorldView::fit(const Rect& area, float margin) {
  area_ = area;
  viewport_ = level_ ? level_viewport(area, scene_) : table_viewport(area.inset(margin), scene_);
}

WorldView WorldView::magnified(const Rect& area, carom::Vec2 center, double factor) const {
  WorldView near = *this;
  near.area_ = area;
  const double scale = 2 * factor * viewport_.scale();
  const carom::Vec2 seen{static_cast<double>(area.w) / scale, static_cast<double>(area.h) / scale};
  const carom::Vec2 reach = viewport_.turned() ? carom::Vec2{seen.y, seen.x} : seen;
  near.viewport_ = Viewport(area, center - reach, center + reach, viewport_.turned());
  return near;
}

Rect WorldView::box() const { return level_ ? area_ : table_box(viewport_, scene_); }

void WorldView::draw_still(Canvas& canvas) const {
  if (level_)
    draw_level(canvas.list, area_, viewport_, scene_);
  else
    draw_table(canvas.list, canvas.view.area(), viewport_, scene_);
}

void WorldView::draw_moving(Canvas& canvas, const carom::World& world, const Interpolator& motion,
                            double fraction) const {
  DrawList& list = canvas.list;
  if (level_) {
    if (!canvas.calm) draw_level_trails(list, viewport_, world, scene_, motion, fraction);
    draw_level_balls(list, area_, viewport_, world, scene_, motion, fraction);
  } else {
    if (!canvas.calm) draw_table_trails(list, viewport_, world, motion, fraction);
    draw_balls(list, viewport_, world, motion, fraction);
  }
}

}  // namespace app
