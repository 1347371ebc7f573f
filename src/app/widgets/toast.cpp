#include "app/widgets/toast.hpp"

#include <algorithm>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"

namespace app {
namespace {

constexpr nanoseconds shown_for = milliseconds{1500};
constexpr nanoseconds fading = milliseconds{250};

}  // namespace

void Toast::show(std::string text) {
  text_ = std::move(text);
  left_ = shown_for;
}

void Toast::advance(nanoseconds elapsed) {
  left_ -= elapsed;
  if (left_ <= nanoseconds{0}) text_.clear();
}

void Toast::draw(Canvas& canvas) const {
  if (!active()) return;
  const TextStyle style{Face::bold, 22, palette::cream, Align::center};
  const Rect all = canvas.view.area();
  const Point middle{all.center().x, all.bottom() - canvas.px(92)};
  const auto opacity = static_cast<float>(left_.count()) / static_cast<float>(fading.count());
  pill(canvas, pill_box(canvas, middle, all, style, text_), style, text_, std::min(opacity, 1.0f));
}

}  // namespace app
