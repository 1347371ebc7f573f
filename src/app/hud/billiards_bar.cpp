#include "app/hud/billiards_bar.hpp"

#include "app/graphics/label.hpp"
#include "app/graphics/markers.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {

BilliardsBar::BilliardsBar(const Words& words) : words_(words) {}

void BilliardsBar::resize(const View& view, const Rect& area) {
  relabel(words_(Text::paused), words_(Text::restart), words_(Text::leave));
  explain({words_(Text::tip_pause), words_(Text::tip_restart), words_(Text::tip_close)});
  const float gap = view.px(8);
  auto [row, rest] = place(view, area);
  if (view.narrow()) {
    players_[0] = row.cut_left((row.w - gap) / 2);
    row.cut_left(gap);
    players_[1] = row;
  } else {
    const float player = std::min(view.px(280), (row.w - 2 * gap - view.px(176)) / 2);
    players_[0] = row.cut_left(player);
    players_[1] = row.cut_right(player);
    rest = row.inset(gap, 0);
  }
  counts_[0] = rest.cut_left(rest.w / 2);
  counts_[1] = rest;
}

void BilliardsBar::draw_player(Canvas& canvas, const Content& content, int player) const {
  const auto index = static_cast<std::size_t>(player);
  const bool on = content.on == player;
  const Color accent = canvas.list.palette->accents[index];
  const Rect box = players_[index];
  const float radius = canvas.px(10);
  if (on) {
    fill_rounded(canvas.list, box, radius,
                 Paint::vertical(box, mix(accent, palette::cream, 0.25f), accent));
  } else {
    fill_rounded(canvas.list, box, radius, palette::panel);
    stroke_rounded(canvas.list, box.inset(0.5f), radius, 1, palette::panel_edge);
  }
  Rect rest = box.inset(canvas.px(12), canvas.px(6));
  const Rect sign = rest.cut_left(canvas.px(36));
  draw_marker(canvas.list, player, sign.center(), canvas.px(15), on ? palette::ink : accent);
  rest.cut_left(canvas.px(8));
  const std::string score = words_.number(content.scores[index]);
  const TextStyle score_style{Face::black, 32, on ? palette::ink : palette::cream, Align::right};
  const float score_width =
      std::min(label_width(canvas, score_style, score) + 1, rest.w - canvas.px(72));
  label(canvas, rest.cut_right(score_width), score_style, score);
  rest.cut_right(canvas.px(8));
  const Color text = on ? palette::ink : palette::muted;
  const TextStyle name{Face::bold, 18, text};
  label_or_elide(canvas, content.on ? rest.cut_top(rest.h * 0.52f) : rest, name,
                 words_.player(player));
  if (content.on)
    label(canvas, rest, {on ? Face::bold : Face::regular, 16, text},
          words_(on ? Text::to_play : Text::waiting));
}

/// In the place of the second player.
void BilliardsBar::draw_shots(Canvas& canvas, int shots) const {
  const Rect box = players_[1];
  const float radius = canvas.px(10);
  fill_rounded(canvas.list, box, radius, palette::panel);
  stroke_rounded(canvas.list, box.inset(0.5f), radius, 1, palette::panel_edge);
  draw_count(canvas, box, words_.number(shots), words_(Text::shots));
}

void BilliardsBar::draw(Canvas& canvas, const Content& content) const {
  draw_strip(canvas);
  draw_player(canvas, content, 0);
  if (content.shots)
    draw_shots(canvas, *content.shots);
  else
    draw_player(canvas, content, 1);
  draw_count(canvas, counts_[0], words_.number(content.balls_left), words_(Text::balls_left));
  draw_count(canvas, counts_[1], words_(Text::points, {words_.number(content.turn_points)}),
             words_(Text::this_turn));
}

}  // namespace app
