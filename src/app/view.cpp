#include "app/view.hpp"

namespace app {

View View::of(int width, int height) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  // Below 0.875 the smallest text, 16 units, would come out under 14 px.
  const float scale = std::clamp(std::min(w / 800, h / 600), 0.875f, 8.0f);
  return {w, h, scale};
}

GameLayout GameLayout::of(const View& view) {
  Rect rest = view.area();
  const Rect bar = rest.cut_top(view.px(view.narrow() ? 144 : 80));
  const Rect footer = rest.cut_bottom(view.px(view.narrow() ? 80 : 48));
  return {bar, rest, footer};
}

}  // namespace app
