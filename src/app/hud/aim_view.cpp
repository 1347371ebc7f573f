#include "app/hud/aim_view.hpp"

#include <array>
#include <span>
#include <vector>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/hud/aim_controls.hpp"
#include "app/widgets/widgets.hpp"
#include "games/launch.hpp"

namespace app {
namespace {

constexpr double arrow_share = 0.2;  ///< of the drag, when a preview shows the rest

/// From calm to furious.
Color strength_color(const Palette& palette, double strength) {
  const auto& [calm, brisk, furious] = palette.strength;
  const auto t = static_cast<float>(strength);
  return t < 0.5f ? mix(calm, brisk, t * 2) : mix(brisk, furious, t * 2 - 1);
}

void draw_bar(Canvas& canvas, const Rect& bar, const Aim& aim) {
  const float radius = bar.h / 2;
  fill_rounded(canvas.list, bar, radius, palette::slate_bottom);
  Rect filled = bar.inset(canvas.px(2));
  const float full = filled.w;
  filled.w = std::max(full * static_cast<float>(aim.strength()), filled.h);
  if (!aim.too_weak()) {
    const Paint heat(Point{bar.x, 0}, strength_color(*canvas.list.palette, 0), {filled.right(), 0},
                     strength_color(*canvas.list.palette, aim.strength()));
    fill_rounded(canvas.list, filled, filled.h / 2, heat);
  }
  for (int quarter = 1; quarter < 4; ++quarter) {
    const float x = bar.x + bar.w * static_cast<float>(quarter) / 4;
    line(canvas.list, {x, bar.y + canvas.px(2)}, {x, bar.bottom() - canvas.px(2)}, canvas.px(1),
         faded(palette::cream, 0.35f));
  }
  stroke_rounded(canvas.list, bar, radius, canvas.px(aim.capped() ? 2 : 1),
                 aim.capped() ? strength_color(*canvas.list.palette, 1) : palette::panel_edge);
}

/// The bar, and above it the launch in numbers: off the table, where they cover no ball.
void draw_meter(Canvas& canvas, const Rect& meter, Rect numbers, const Footer& footer,
                const Words& words) {
  const Aim& aim = *footer.aim;
  Rect rest = meter;
  const float upper = std::round(rest.h * 0.58f);
  rest.cut_top(upper);
  numbers = numbers.cut_top(upper);
  const Rect bar = centered(rest.center(), rest.w, canvas.px(12));
  draw_bar(canvas, bar, aim);
  if (footer.slides) {
    const Point at{bar.x + bar.w * static_cast<float>(aim.strength()), bar.center().y};
    fill_disc(canvas.list, at, canvas.px(9) + 1, faded(palette::ink, 0.6f));
    fill_disc(canvas.list, at, canvas.px(9), palette::cream);
    fill_disc(canvas.list, at, canvas.px(4), palette::slate_bottom);
  }
  std::string strength =
      footer.practice
          ? words(Text::speed, {words.number(static_cast<int>(std::lround(aim.speed())))})
          : words(Text::per_cent, {words.tenths(100 * aim.speed() / games::max_launch_speed)});
  if (aim.capped()) strength = words(Text::speed_capped, {strength});
  label(canvas, numbers,
        {Face::bold, 18, aim.capped() ? strength_color(*canvas.list.palette, 1) : palette::cream,
         Align::center},
        words(Text::aimed, {words.tenths(aim.degrees()), strength}));
}

/// Arrows on all sides.
void draw_fine_field(Canvas& canvas, const Rect& box, const Words& words) {
  DrawList& list = canvas.list;
  fill_rounded(list, box, canvas.px(6), palette::slate_bottom);
  stroke_rounded(list, box, canvas.px(6), canvas.px(1), palette::brass);
  const float size = canvas.px(5);
  for (const Point way : {Point{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    const Point tip =
        box.center() + Point{way.x * (box.w / 2 - size), way.y * (box.h / 2 - size / 2)};
    const Point back = tip - way * size;
    fill(list, std::array{tip, back + turned(way) * size, back - turned(way) * size},
         palette::brass_lit);
  }
  label(canvas, box.inset(canvas.px(14), 0), {Face::regular, 16, palette::cream, Align::center},
        words(Text::fine_steps));
  list.boxes.push_back({Box::Kind::button, box, words(Text::fine_steps)});
}

/// A path in the window, without the places that lie on a straight line between others: no seams.
/// A ball that runs into something within a step is put back before it goes on; of that only the
/// bend is kept, not the hook of some px.
std::vector<Point> corners(const Viewport& viewport, std::span<const Waypoint> path) {
  const float hook = viewport.px(carom::default_radius);
  constexpr float bend = 0.004f;  // sine of the least change of direction to be drawn
  std::vector<Point> points;
  for (const Waypoint& waypoint : path) {
    const Point next = viewport.to_window(waypoint.at);
    if (!points.empty() && length(next - points.back()) < 0.01f) continue;
    if (waypoint.bend && points.size() > 1 && length(next - points.back()) < hook)
      points.pop_back();
    if (points.size() > 1) {
      const Point before = unit(points.back() - points[points.size() - 2]);
      const Point after = unit(next - points.back());
      if (dot(before, after) > 0 && std::abs(dot(turned(before), after)) < bend) points.pop_back();
    }
    points.push_back(next);
  }
  return points;
}

/// Takes `by` px off a path's start.
void trim_start(std::vector<Point>& points, float by) {
  while (points.size() > 1) {
    const float first = length(points[1] - points[0]);
    if (first > by) {
      points[0] = points[0] + unit(points[1] - points[0]) * by;
      return;
    }
    by -= first;
    points.erase(points.begin());
  }
  points.clear();
}

void trim_end(std::vector<Point>& points, float by) {
  std::ranges::reverse(points);
  trim_start(points, by);
  std::ranges::reverse(points);
}

void draw_lines(DrawList& list, std::span<const Point> points, float width, Color color) {
  for (std::size_t i = 1; i < points.size(); ++i)
    line(list, points[i - 1], points[i], width, color);
}

/// A dark casing keeps a line visible on felt, wood, sky and balls alike.
void draw_cased(DrawList& list, std::span<const Point> points, float width, Color color) {
  draw_lines(list, points, width + 2, faded(palette::ink, 0.55f));
  draw_lines(list, points, width, color);
}

void draw_ring(DrawList& list, Point center, float radius, float width, Color color) {
  stroke_circle(list, center, radius, width + 2, faded(palette::ink, 0.55f));
  stroke_circle(list, center, radius, width, color);
}

/// The launch itself; `reach` (window px): from the ball's centre to the arrow's tip.
void draw_arrow(DrawList& list, const Viewport& viewport, Point from, Point way, float ball,
                float reach, const Aim& aim) {
  const Point start = from + way * (ball * 1.4f);
  const Point tip = from + way * std::max(reach, ball * 1.4f + viewport.px(4));
  const Color color = strength_color(*list.palette, aim.strength());
  const float head = std::min(viewport.px(18), length(tip - start) * 0.6f);
  const float width = viewport.px(4);
  const Point neck = tip - way * head;
  const Point across = turned(way) * (head * 0.5f);
  const std::array triangle{tip, neck + across, neck - across};
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
}

/// `from` (px): how far from the lead's centre the arrow reaches; its way begins there.
void draw_preview(DrawList& list, const Viewport& viewport, const carom::World& world,
                  const Preview& preview, float from) {
  const float radius = viewport.px(world.ball(0).radius);
  const float width = std::max(std::round(viewport.px(1.6)), 1.5f);
  const bool flight = world.scene().gravity > 0;
  if (!flight) {
    std::vector<Point> after = corners(viewport, preview.lead_after);
    trim_start(after, radius);
    draw_cased(list, after, width, faded(palette::cream, 0.6f));
    std::vector<Point> before = corners(viewport, preview.lead);
    trim_start(before, from);
    if (preview.ghost) trim_end(before, radius);
    draw_cased(list, before, width, palette::cream);
  }
  const std::vector<Point> target = corners(viewport, preview.target);
  draw_cased(list, target, width + 1, palette::brass_lit);
  if (target.size() > 1) {
    const float dot = width + 2;
    fill_disc(list, target.back(), dot + 1, faded(palette::ink, 0.55f));
    fill_disc(list, target.back(), dot, palette::brass_lit);
  }
  for (std::size_t i = 0; i < preview.dots.size(); ++i) {
    const auto age = static_cast<float>(i * steps_per_dot) / static_cast<float>(dotted_steps);
    const float size = std::max(viewport.px(4) * (1 - 0.5f * std::min(age, 1.0f)), 1.6f);
    const Point at = viewport.to_window(preview.dots[i]);
    if (length(at - viewport.to_window(world.ball(0).position)) < from + size) continue;
    fill_disc(list, at, size + 1.2f, faded(palette::ink, 0.6f));
    fill_disc(list, at, size, palette::cream);
  }
  if (preview.ghost)
    draw_ring(list, viewport.to_window(*preview.ghost), radius, width, palette::cream);
  if (preview.pocketed) {
    const BallPath& path = preview.lead_after.empty() ? preview.lead : preview.lead_after;
    const Point at = viewport.to_window(path.back().at);
    draw_ring(list, at, radius * 1.3f, width + 1, list.palette->refused);
    const float arm = radius * 0.7f;
    for (const float side : {-1.0f, 1.0f})
      draw_cased(list, std::array{at + Point{-arm, -arm * side}, at + Point{arm, arm * side}},
                 width + 1, list.palette->refused);
  }
}

}  // namespace

void draw_aim(DrawList& list, const Viewport& viewport, const carom::World& world, const Aim& aim,
              const Preview& preview) {
  const carom::Ball ball = world.ball(0);
  const Point from = viewport.to_window(ball.position);
  const float radius = viewport.px(ball.radius);
  if (aim.too_weak()) {
    stroke_circle(list, from, radius * 1.7f, viewport.px(1.5), palette::cream);
    return;
  }
  const carom::Vec2 reach = aim.velocity() / games::launch_factor;
  const bool foretold = !preview.lead.empty();
  const Point way = unit(viewport.to_window(ball.position + reach) - from);
  const float arrow = foretold ? radius * 1.4f + viewport.px(carom::length(reach) * arrow_share)
                               : viewport.px(carom::length(reach));
  // First the arrow: it hides nothing of what will happen.
  draw_arrow(list, viewport, from, way, radius, arrow, aim);
  draw_preview(list, viewport, world, preview, arrow);
}

void draw_sling(DrawList& list, const Viewport& viewport, const carom::Ball& lead, Point to) {
  const Point from = viewport.to_window(lead.position);
  const float radius = viewport.px(lead.radius);
  const Point across = turned(unit(to - from)) * radius;
  for (const float side : {-1.0f, 1.0f})
    draw_cased(list, std::array{from + across * side, to}, viewport.px(2), palette::brass);
  fill_disc(list, to, viewport.px(6) + 1, faded(palette::ink, 0.55f));
  fill_disc(list, to, viewport.px(6), palette::brass);
}

void draw_invitation(DrawList& list, const Viewport& viewport, const carom::Ball& lead,
                     bool hovered, Color color) {
  stroke_circle(list, viewport.to_window(lead.position),
                viewport.px(lead.radius * (hovered ? 2.0 : 1.7)), viewport.px(hovered ? 2.4 : 1.4),
                color);
}

void draw_footer(Canvas& canvas, const Rect& area, const Footer& footer, const Words& words) {
  const View& view = canvas.view;
  Rect rest = area.inset(canvas.px(16), canvas.px(4));
  if (footer.aim && footer.aim->active()) {
    const Rect meter = strength_meter(view, area);
    const Rect numbers = strength_column(view, area);
    if (view.narrow())
      rest.cut_top(numbers.h);
    else
      rest.cut_right(numbers.w + canvas.px(16));
    if (footer.entry)
      footer.entry->draw(canvas, numbers, words);
    else
      draw_meter(canvas, meter, numbers, footer, words);
  }
  if (footer.shoot || footer.hint_button) {
    const Rect box = shoot_button(view, area);
    if (footer.hint_button && view.narrow())
      rest.h = box.y - canvas.px(4) - rest.y;  // above it there is more room
    else
      rest.cut_left(box.w + canvas.px(12));
    Buttons button({{0, words(Text::shoot), words(Text::tip_shoot)}}, 0);
    button.place(view, 0, box);
    if (footer.shoot) button.draw(canvas, 18);
  }
  if (footer.fine) {
    const Rect box = fine_field(view, area);
    draw_fine_field(canvas, box, words);
    rest.w = std::max(box.x - canvas.px(12) - rest.x, 0.0f);
  }
  // In the window's middle, where it stands without a meter, if it fits there.
  const TextStyle style{Face::regular, 18, footer.color, Align::center};
  const float width = label_width(canvas, style, footer.hint);
  if (footer.fine && width > rest.w) return;
  const Point middle{area.center().x, rest.center().y};
  const float half = std::min(middle.x - rest.x, rest.right() - middle.x);
  if (width <= 2 * half) rest = centered(middle, 2 * half, rest.h);
  label(canvas, rest, style, footer.hint);
}

}  // namespace app
