#include "app/hud/aim_controls.hpp"

namespace app {
namespace {

constexpr float slider = 300;       ///< points of the screen, for the greatest speed
constexpr float least_meter = 240;  ///< units, for the numbers over it
constexpr float shoot_width = 112;  ///< units

Rect inside(const View& view, const Rect& footer) { return footer.inset(view.px(16), view.px(4)); }

/// A narrow footer's lower half.
Rect lower_row(const View& view, const Rect& footer) {
  Rect rest = inside(view, footer);
  rest.cut_top(rest.h / 2);
  return rest;
}

}  // namespace

Rect strength_column(const View& view, const Rect& footer) {
  Rect rest = inside(view, footer);
  if (view.narrow()) return rest.cut_top(rest.h / 2);
  return rest.cut_right(std::min(std::max(slider * view.density, view.px(least_meter)), rest.w));
}

Rect strength_meter(const View& view, const Rect& footer) {
  const Rect column = strength_column(view, footer);
  return centered(column.center(), std::min(slider * view.density, column.w), column.h);
}

Rect shoot_button(const View& view, const Rect& footer) {
  Rect rest = view.narrow() ? lower_row(view, footer) : inside(view, footer);
  return rest.cut_left(view.px(shoot_width));
}

Rect fine_field(const View& view, const Rect& footer) {
  if (view.narrow()) {
    Rect rest = lower_row(view, footer);
    rest.cut_left(view.px(shoot_width + 12));
    return rest;
  }
  Rect rest = inside(view, footer);
  rest.cut_right(strength_column(view, footer).w + view.px(16));
  return rest.cut_right(view.px(128));
}

}  // namespace app
