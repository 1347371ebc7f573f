#include "app/graphics/view.hpp"

namespace app {

View View::of(int width, int height, float density) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  // Below 0.875 the smallest text, 16 units, would come out under 14 points.
  const float scale = std::clamp(std::min(w / 800, h / 600), 0.875f * density, 8.0f);
  return {w, h, scale, false, density};
}

GameLayout GameLayout::of(const View& view) {
  Rect rest = view.area();
  // For fingers buttons are 44 px high even at the least scale.
  float bar_height = view.narrow() ? 144 : 80;
  float footer_height = view.narrow() ? 80 : 48;
  if (view.touch) {
    bar_height = view.narrow() ? 156 : view.wide() ? 80 : 124;
    footer_height = view.narrow() ? 112 : 60;
  }
  const Rect bar = rest.cut_top(view.px(bar_height));
  const Rect footer = rest.cut_bottom(view.px(footer_height));
  return {bar, rest, footer};
}

}  // namespace app
