#include "app/user_bar.hpp"

#include "app/label.hpp"
#include "app/markers.hpp"
#include "app/palette.hpp"
#include "app/shapes.hpp"

namespace app {

UserBar::UserBar(const Words& words)
    : words_(words), buttons_({words(Text::restart), words(Text::close)}) {}

void UserBar::resize(const View& view, const Rect& area) {
  area_ = area;
  const float gap = view.px(8);
  // In a very wide window everything stays together in the middle.
  Rect rest = centered(area.center(), std::min(area.w, view.px(1120)), area.h).inset(gap);
  if (view.narrow()) {
    Rect row = rest.cut_top(view.px(64));
    rest.cut_top(gap);
    players_[0] = row.cut_left((row.w - gap) / 2);
    row.cut_left(gap);
    players_[1] = row;
    const float button = view.px(136);
    const float trim = view.px(6);
    buttons_.place(1, rest.cut_right(button).inset(0, trim));
    rest.cut_right(gap);
    buttons_.place(0, rest.cut_right(button).inset(0, trim));
    rest.cut_right(gap);
  } else {
    Rect column = rest.cut_right(view.px(128));
    buttons_.place(0, column.cut_top((column.h - gap / 2) / 2));
    column.cut_top(gap / 2);
    buttons_.place(1, column);
    rest.cut_right(gap);
    const float player = std::min(view.px(280), (rest.w - 2 * gap - view.px(176)) / 2);
    players_[0] = rest.cut_left(player);
    players_[1] = rest.cut_right(player);
    rest = rest.inset(gap, 0);
  }
  counts_[0] = rest.cut_left(rest.w / 2);
  counts_[1] = rest;
}

std::optional<UserBar::Command> UserBar::event(const Input& input) {
  const auto chosen = buttons_.event(input);
  if (!chosen) return std::nullopt;
  return static_cast<Command>(*chosen);
}

void UserBar::draw_player(Canvas& canvas, const Content& content, int player) const {
  const auto index = static_cast<std::size_t>(player);
  const bool on = content.on == player;
  const Color accent = palette::accents[index];
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
  label(canvas, content.on ? rest.cut_top(rest.h * 0.52f) : rest, {Face::bold, 18, text},
        words_.player(player));
  if (content.on)
    label(canvas, rest, {on ? Face::bold : Face::regular, 16, text},
          words_(on ? Text::to_play : Text::waiting));
}

void UserBar::draw(Canvas& canvas, const Content& content) const {
  fill_rounded(canvas.list, area_, 0,
               Paint::vertical(area_, palette::slate_top, palette::slate_bottom));
  line(canvas.list, {area_.x, area_.bottom()}, {area_.right(), area_.bottom()}, canvas.px(1),
       palette::brass_dark);
  for (int player = 0; player < 2; ++player) draw_player(canvas, content, player);

  const std::array values{words_.number(content.balls_left),
                          words_(Text::points, {words_.number(content.turn_points)})};
  const std::array titles{Text::balls_left, Text::this_turn};
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    Rect box = counts_[i].inset(canvas.px(2), canvas.px(4));
    label(canvas, box.cut_top(box.h * 0.56f), {Face::bold, 26, palette::cream, Align::center},
          values[i]);
    label(canvas, box, {Face::regular, 16, palette::muted, Align::center}, words_(titles[i]));
  }
  buttons_.draw(canvas);
}

}  // namespace app
