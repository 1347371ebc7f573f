#include "app/user_bar.hpp"

#include "app/label.hpp"
#include "app/palette.hpp"
#include "app/shapes.hpp"

namespace app {

UserBar::UserBar(std::string restart, std::string close)
    : buttons_({std::move(restart), std::move(close)}) {}

UserBar::Room UserBar::place(const View& view, const Rect& area) {
  area_ = area;
  const float gap = view.px(8);
  // In a very wide window everything stays together in the middle.
  Rect rest = centered(area.center(), std::min(area.w, view.px(1120)), area.h).inset(gap);
  if (!view.narrow()) {
    Rect column = rest.cut_right(view.px(128));
    buttons_.place(0, column.cut_top((column.h - gap / 2) / 2));
    column.cut_top(gap / 2);
    buttons_.place(1, column);
    rest.cut_right(gap);
    return {rest, {}};
  }
  const Rect row = rest.cut_top(view.px(64));
  rest.cut_top(gap);
  const float button = view.px(136);
  const float trim = view.px(6);
  buttons_.place(1, rest.cut_right(button).inset(0, trim));
  rest.cut_right(gap);
  buttons_.place(0, rest.cut_right(button).inset(0, trim));
  rest.cut_right(gap);
  return {row, rest};
}

std::optional<UserBar::Command> UserBar::event(const Input& input) {
  const auto chosen = buttons_.event(input);
  if (!chosen) return std::nullopt;
  return static_cast<Command>(*chosen);
}

void UserBar::draw_strip(Canvas& canvas) const {
  fill_rounded(canvas.list, area_, 0,
               Paint::vertical(area_, palette::slate_top, palette::slate_bottom));
  line(canvas.list, {area_.x, area_.bottom()}, {area_.right(), area_.bottom()}, canvas.px(1),
       palette::brass_dark);
  buttons_.draw(canvas);
}

void UserBar::draw_count(Canvas& canvas, const Rect& box, std::string_view value,
                         std::string_view title) {
  Rect rest = box.inset(canvas.px(2), canvas.px(4));
  label(canvas, rest.cut_top(rest.h * 0.56f), {Face::bold, 26, palette::cream, Align::center},
        value);
  label(canvas, rest, {Face::regular, 16, palette::muted, Align::center}, title);
}

}  // namespace app
