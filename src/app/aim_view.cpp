#include "app/aim_view.hpp"

#include <array>

#include "app/first_contact.hpp"
#include "app/label.hpp"
#include "app/palette.hpp"
#include "app/shapes.hpp"
#include "games/launch.hpp"

namespace app {
namespace {

/// From calm to furious.
Color strength_color(double strength) {
  const auto t = static_cast<float>(strength);
  return t < 0.5f ? mix(rgb(0x9be08f), rgb(0xf7d354), t * 2)
                  : mix(rgb(0xf7d354), rgb(0xff7a3d), t * 2 - 1);
}

void draw_strength(Canvas& canvas, const Rect& area, const Aim& aim, const Words& words) {
  Rect rest = area;
  const Rect number = rest.cut_right(canvas.px(144));
  rest.cut_right(canvas.px(12));
  const Rect bar = centered(rest.center(), rest.w, canvas.px(16));
  const float radius = bar.h / 2;
  fill_rounded(canvas.list, bar, radius, palette::slate_bottom);
  Rect filled = bar.inset(canvas.px(2));
  const float full = filled.w;
  filled.w = std::max(full * static_cast<float>(aim.strength()), filled.h);
  if (!aim.too_weak()) {
    const Paint heat(Point{bar.x, 0}, strength_color(0), {filled.right(), 0},
                     strength_color(aim.strength()));
    fill_rounded(canvas.list, filled, filled.h / 2, heat);
  }
  for (int quarter = 1; quarter < 4; ++quarter) {
    const float x = bar.x + bar.w * static_cast<float>(quarter) / 4;
    line(canvas.list, {x, bar.y + canvas.px(2)}, {x, bar.bottom() - canvas.px(2)}, canvas.px(1),
         faded(palette::cream, 0.35f));
  }
  stroke_rounded(canvas.list, bar, radius, canvas.px(aim.capped() ? 2 : 1),
                 aim.capped() ? strength_color(1) : palette::panel_edge);
  const std::string speed = words.number(static_cast<int>(std::lround(aim.speed())));
  label(canvas, number,
        {Face::bold, 18, aim.capped() ? strength_color(1) : palette::cream, Align::right},
        words(aim.capped() ? Text::speed_capped : Text::speed, {speed}));
}

}  // namespace

void draw_aim(DrawList& list, const Viewport& viewport, const carom::World& world, const Aim& aim) {
  const carom::Ball ball = world.ball(0);
  const Point from = viewport.to_window(ball.position);
  const float radius = viewport.px(ball.radius);
  if (aim.too_weak()) {
    stroke_circle(list, from, radius * 1.7f, viewport.px(1.5), palette::cream);
    return;
  }
  const carom::Vec2 velocity = aim.velocity();
  const carom::Vec2 reach = velocity / games::launch_factor;
  const Point tip = viewport.to_window(ball.position + reach);
  const Point way = unit(tip - from);
  const Point start = from + way * (radius * 1.4f);

  const Color color = strength_color(aim.strength());
  const float head = std::min(viewport.px(18), length(tip - start) * 0.6f);
  const float width = viewport.px(4);
  const Point neck = tip - way * head;
  const Point across = turned(way) * (head * 0.5f);
  const std::array triangle{tip, neck + across, neck - across};
  // A dark casing keeps the arrow visible on felt, wood and red balls alike.
  const Color casing = faded(palette::ink, 0.75f);
  stroke(list, triangle, viewport.px(4), casing);
  line(list, start, neck + way, width + viewport.px(3), faded(palette::ink, 0.45f));
  line(list, start, neck + way, width, Paint(start, faded(color, 0.35f), neck, color));
  fill(list, triangle, color);
  if (aim.capped()) {  // a bar across: no further
    const Point at = tip + way * width;
    const Point stop = turned(way) * (head * 0.8f);
    line(list, at - stop, at + stop, width + viewport.px(3), casing);
    line(list, at - stop, at + stop, width, color);
  }

  if (world.scene().gravity > 0 || !world.scene().obstacles.empty()) return;  // no straight line
  const auto contact = first_contact(world, 0, velocity);
  if (!contact) return;
  const Point ghost = viewport.to_window(contact->center);
  const Color faint = faded(palette::cream, 0.7f);
  if (length(ghost - from) > length(tip - from) + 2 * radius)
    dashed_line(list, tip + way * radius, ghost - way * radius, viewport.px(1.3), viewport.px(5),
                faint);
  stroke_circle(list, ghost, radius, viewport.px(1.3), faint);
  if (contact->target) {  // which way the red will go
    const Point target = viewport.to_window(*contact->target);
    line(list, target, target + unit(target - ghost) * viewport.px(34), viewport.px(1.6), faint);
  }
}

void draw_footer(Canvas& canvas, const Rect& area, const Aim* aim, const Words& words,
                 const std::string& hint, Color color) {
  Rect rest = area.inset(canvas.px(16), canvas.px(4));
  if (aim && aim->active()) {
    const Rect meter = canvas.view.narrow()
                           ? rest.cut_top(rest.h / 2)
                           : rest.cut_right(std::min(canvas.px(400), rest.w * 0.4f));
    rest.cut_right(canvas.px(canvas.view.narrow() ? 0 : 16));
    draw_strength(canvas, meter, *aim, words);
  }
  label(canvas, rest, {Face::regular, 18, color, Align::center}, hint);
}

}  // namespace app
