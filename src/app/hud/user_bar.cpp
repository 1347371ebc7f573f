#include "app/hud/user_bar.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {

namespace {

// In the order of UserBar::Command.
enum Button : ButtonId { pause, restart, close };

constexpr float gear_width = 44;        ///< units
constexpr float touch_gear_width = 52;  ///< units

void draw_gear(DrawList& list, Point center, float radius, Color color, Color ground) {
  constexpr int teeth = 8;
  for (int i = 0; i < teeth; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / teeth;
    const Point way{std::cos(angle), std::sin(angle)};
    line(list, center + way * (radius * 0.6f), center + way * radius, radius * 0.36f, color);
  }
  fill_disc(list, center, radius * 0.74f, color);
  fill_disc(list, center, radius * 0.34f, ground);
}

}  // namespace

UserBar::UserBar() : buttons_({{pause}, {restart}, {close}}) {}

void UserBar::relabel(std::string pause_label, std::string restart_label, std::string close_label) {
  buttons_.relabel(restart, std::move(restart_label));
  buttons_.relabel(close, std::move(close_label));
  buttons_.relabel(pause, std::move(pause_label));
}

void UserBar::explain(std::array<std::string, 3> tips) {
  for (std::size_t i = 0; i < tips.size(); ++i) buttons_.explain(i, std::move(tips[i]));
}

UserBar::Room UserBar::place(const View& view, const Rect& area) {
  area_ = area;
  const float gap = view.px(8);
  // In a very wide window everything stays together in the middle.
  Rect rest = centered(area.center(), std::min(area.w, view.px(1120)), area.h).inset(gap);
  if (view.wide()) {
    for (const auto& [index, width] :
         {std::pair{close, 104.0f}, {restart, 136.0f}, {pause, touch_gear_width}}) {
      buttons_.place(view, index, rest.cut_right(view.px(width)));
      rest.cut_right(gap);
    }
    return {rest, {}};
  }
  if (!view.narrow()) {
    Rect column = rest.cut_right(view.px(view.touch ? 140 : 128));
    buttons_.place(view, restart, column.cut_top((column.h - gap / 2) / 2));
    column.cut_top(gap / 2);
    buttons_.place(view, pause,
                   column.cut_right(view.px(view.touch ? touch_gear_width : gear_width)));
    column.cut_right(gap / 2);
    buttons_.place(view, close, column);
    rest.cut_right(gap);
    return {rest, {}};
  }
  const Rect row = rest.cut_top(view.px(64));
  rest.cut_top(gap);
  const float button = std::min(view.px(136), rest.w * 0.235f);
  const bool phone = rest.w < view.px(480);  // the longer word needs more of it
  const float trim = view.px(view.touch ? 2 : 5);
  const float gear = view.px(view.touch ? touch_gear_width : gear_width);
  for (const auto& [index, width] : {std::pair{close, phone ? rest.w * 0.2f : button},
                                     {restart, phone ? rest.w * 0.285f : button},
                                     {pause, gear}}) {
    buttons_.place(view, index, rest.cut_right(width).inset(0, trim));
    rest.cut_right(gap);
  }
  return {row, rest};
}

std::optional<UserBar::Command> UserBar::event(const Input& input, Sounds& sounds) {
  const auto chosen = buttons_.event(input, sounds);
  if (!chosen) return std::nullopt;
  return static_cast<Command>(*chosen);
}

void UserBar::draw_strip(Canvas& canvas) const {
  fill_rounded(canvas.list, area_, 0,
               Paint::vertical(area_, palette::slate_top, palette::slate_bottom));
  line(canvas.list, {area_.x, area_.bottom()}, {area_.right(), area_.bottom()}, canvas.px(1),
       palette::brass_dark);
  const bool large = buttons_.box(restart).h > canvas.px(56);
  for (const Button button : {restart, close}) buttons_.draw_one(canvas, button, large ? 20 : 16);
  const Buttons::Look look = buttons_.draw_face(canvas, pause);
  draw_gear(canvas.list, look.box.center(), canvas.px(large ? 15 : 11), look.ink,
            palette::panel_lit);
  buttons_.list_box(canvas.list, pause, buttons_.label_of(pause));
}

void UserBar::draw_count(Canvas& canvas, const Rect& box, std::string_view value,
                         std::string_view title) {
  Rect rest = box.inset(canvas.px(2), canvas.px(4));
  label(canvas, rest.cut_top(rest.h * 0.56f), {Face::bold, 26, palette::cream, Align::center},
        value);
  label(canvas, rest, {Face::regular, 16, palette::muted, Align::center}, title);
}

}  // namespace app
