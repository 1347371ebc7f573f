#include "app/hud/level_bar.hpp"

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/balls.hpp"
#include "app/view/faces.hpp"

namespace app {
namespace {

constexpr int most_icons = 5;  ///< more throws than that are only a number

}  // namespace

LevelBar::LevelBar(const Words& words) : words_(words) {}

void LevelBar::resize(const View& view, const Rect& area) {
  relabel(words_(Text::paused), words_(Text::retry), words_(Text::menu));
  explain({words_(Text::tip_pause), words_(Text::tip_restart), words_(Text::tip_close)});
  auto [row, rest] = place(view, area);
  if (view.narrow()) {
    name_ = row.cut_left(row.w * 0.54f);
    for (std::size_t i = 0; i < 4; ++i) {
      Rect& strip = i < 2 ? row : rest;
      counts_[i] = strip.cut_left(strip.w / static_cast<float>(2 - i % 2));
    }
  } else {
    name_ = row.cut_left(std::min(row.w * 0.36f, view.px(320)));
    for (std::size_t i = 0; i < 4; ++i)
      counts_[i] = row.cut_left(row.w / static_cast<float>(4 - i));
  }
}

void LevelBar::draw(Canvas& canvas, const Content& content) const {
  draw_strip(canvas);
  Rect box = name_;
  const float radius = canvas.px(10);
  fill_rounded(canvas.list, box, radius, palette::panel);
  stroke_rounded(canvas.list, box.inset(0.5f), radius, 1, palette::panel_edge);
  box = box.inset(canvas.px(10), canvas.px(6));
  const TextStyle number{Face::black, 32, palette::brass_lit, Align::center};
  const std::string digits = words_.number(content.number);
  label(canvas, box.cut_left(std::max(label_width(canvas, number, digits) + 1, canvas.px(36))),
        number, digits);
  box.cut_left(canvas.px(10));
  const TextStyle name{Face::bold, 20, palette::cream};
  label_or_elide(canvas, box, name, content.name);

  draw_count(canvas, counts_[0], words_.number(content.score), words_(Text::score));
  draw_count(canvas, counts_[1], words_(Text::points, {words_.number(content.turn_points)}),
             words_(Text::this_turn));
  draw_throws(canvas, counts_[2], content.throws_left);
  draw_count(canvas, counts_[3], words_.number(content.enemies_left), words_(Text::enemies));
}

/// The number of throws, and beside it a projectile for each.
void LevelBar::draw_throws(Canvas& canvas, const Rect& box, int left) const {
  const std::string number = words_.number(left);
  const float radius = canvas.px(8);
  const float pitch = radius * 2.3f;
  const TextStyle style{Face::bold, 26, palette::cream};
  const float digits = label_width(canvas, style, number);
  const float icons = canvas.px(6) + pitch * static_cast<float>(left);
  const bool fit = left <= most_icons && digits + icons <= box.w;
  draw_count(canvas, box, fit ? std::string() : number, words_(Text::throws));
  if (!fit) return;
  Rect group = box.inset(canvas.px(2), canvas.px(4));
  group = group.cut_top(group.h * 0.56f);
  group = centered(group.center(), digits + icons, group.h);
  label(canvas, group, style, number);
  for (int i = 0; i < left; ++i) {
    const Point at{group.right() - radius - pitch * static_cast<float>(i), group.center().y};
    draw_ball(canvas.list, at, radius, BallKind::ivory);
    draw_angry_face(canvas.list, at, radius);
  }
}

}  // namespace app
