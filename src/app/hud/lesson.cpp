#include "app/hud/lesson.hpp"

#include <array>
#include <cmath>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/balls.hpp"
#include "app/view/clear_place.hpp"
#include "app/widgets/tip.hpp"

namespace app {
namespace {

constexpr float panel_width = 560;  ///< units
constexpr float least_width = 432;
constexpr float panel_height = 168;

/// The hand that does it: a finger's tip, seen as a ring.
void draw_touch(DrawList& list, Point at, float radius) {
  fill_disc(list, at, radius, faded(palette::brass, 0.7f));
  stroke_circle(list, at, radius, radius * 0.25f, palette::walnut);
}

void draw_arrow(DrawList& list, Point from, Point to, float width) {
  const Point way = unit(to - from);
  const Point neck = to - way * (width * 3);
  const Point across = turned(way) * (width * 2);
  line(list, from, neck, width, palette::cream);
  fill(list, std::array{to, neck + across, neck - across}, palette::cream);
}

/// The ball and the place that is pointed at; the bar of the strength; the shot. `by_hand`: by
/// pointer or finger.
void draw_picture(Canvas& canvas, const Rect& box, int number, bool by_hand) {
  DrawList& list = canvas.list;
  const float r = std::min(box.h * 0.22f, box.w * 0.12f);
  const Point middle = box.center();
  if (number == 1) {
    const Point left = middle - Point{r * 3.2f, 0};
    const Point knob = middle + Point{r * 0.8f, 0};
    line(list, left, middle + Point{r * 3.2f, 0}, r * 0.6f, palette::panel_edge);
    line(list, left, knob, r * 0.6f, palette::brass);
    fill_disc(list, knob, r * 0.6f, palette::cream);
    if (by_hand) draw_touch(list, knob + Point{r * 0.2f, r * 0.3f}, r * 0.7f);
    return;
  }
  const Point ball = middle - Point{r * 1.8f, 0};
  const Point there = ball + Point{r * 4.2f, -r * 0.6f};
  const Point way = unit(there - ball);
  draw_ball_shadow(list, ball, r);
  draw_ball(list, ball, r, BallKind::ivory);
  if (number == 0) {
    line(list, ball + way * (r * 1.4f), there, r * 0.15f, palette::cream);
    if (by_hand) draw_touch(list, there, r * 0.7f);
  } else {
    draw_arrow(list, ball + way * (r * 1.4f), there, r * 0.3f);
  }
}

}  // namespace

void draw_lesson(Canvas& canvas, const AimPrompt& call, const Words& words) {
  const Rect window = canvas.view.area();
  const float width = std::min(canvas.px(panel_width), window.w - canvas.px(16));
  const float height = std::min(canvas.px(panel_height), window.h * 0.4f);
  // Below the bar, or above the footer: where the ball is not.
  const GameLayout layout = GameLayout::of(canvas.view);
  const Rect world = layout.world;
  const bool low = call.at.y < world.center().y - 1;
  Rect panel{window.center().x - width / 2,
             low ? world.bottom() - height - canvas.px(8) : world.y + canvas.px(8), width, height};
  // In a low window beside the ball, where there is more room.
  const float reach = call.radius + canvas.px(20);
  if (panel.overlaps(centered(call.at, 2 * reach, 2 * reach))) {
    const bool right = call.at.x < world.center().x;
    const float edge = right ? call.at.x + reach : canvas.px(8);
    const float room = right ? window.w - canvas.px(8) - edge : call.at.x - reach - edge;
    if (room < canvas.px(least_width)) {  // nor is there any: rather over the bar
      panel.y = std::max(call.at.y - reach - height, canvas.px(4));
    } else {
      panel = {edge, std::max(world.center().y - height / 2, world.y + canvas.px(4)),
               std::min(width, room), height};
    }
  }
  // Nor over the rack and the pockets, as far as there is room.
  std::vector<Rect> things = call.in_sight;
  things.push_back(centered(call.at, 2 * reach, 2 * reach));
  for (const float part : {1.0f, 0.85f, 0.7f})
    for (const float tried : {width, std::min(width, canvas.px(least_width))}) {
      Rect box = panel;
      box.w = std::min(box.w, tried);
      box.h = height * part;
      box = clear_place(box, world.inset(canvas.px(4)), things);
      if (covered(box, things) < covered(panel, things)) panel = box;
    }
  fill_rounded(canvas.list, panel.moved({0, canvas.px(4)}), canvas.px(12), palette::shadow,
               canvas.px(12));
  fill_rounded(canvas.list, panel, canvas.px(12), faded(palette::slate_bottom, 0.94f));
  stroke_rounded(canvas.list, panel, canvas.px(12), canvas.px(2), palette::brass);
  Rect rest = panel.inset(canvas.px(8));
  constexpr std::array texts{Text::lesson_1, Text::lesson_2, Text::lesson_3};
  for (int i = 0; i < 3; ++i) {
    Rect card = rest.cut_left(rest.w / static_cast<float>(3 - i));
    const Rect words_box = card.cut_bottom(canvas.px(30));
    draw_picture(canvas, card, i, words.hand() != InputDevice::pad);
    label(canvas, words_box.inset(canvas.px(3), 0),
          {Face::bold, 17, i == 2 ? palette::brass_lit : palette::cream, Align::center},
          words(texts[static_cast<std::size_t>(i)]));
    canvas.list.boxes.back().kind = Box::Kind::tip;
  }
}

void draw_nudge(Canvas& canvas, const AimPrompt& call, float phase, const Words& words) {
  if (phase < 1 && !canvas.calm) {
    const float wave = phase * 4 - std::floor(phase * 4);  // four times
    stroke_circle(canvas.list, call.at, call.radius * (1.4f + 3 * wave), canvas.px(3),
                  faded(palette::brass_lit, 1 - wave));
  }
  const bool above = call.at.y > canvas.view.height * 0.3f;
  const float away = call.radius * 2 + canvas.px(30);
  draw_note(canvas, call.at + Point{0, above ? -away : away}, words(call.what));
}

}  // namespace app
