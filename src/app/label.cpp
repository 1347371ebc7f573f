#include "app/label.hpp"

#include "app/palette.hpp"
#include "app/shapes.hpp"

namespace app {
namespace {

constexpr int smallest_size = 9;  ///< px: below, letters are no longer told apart

int pixels(const Canvas& canvas, const TextStyle& style) {
  return std::max(static_cast<int>(canvas.px(style.size)), 1);
}

}  // namespace

float label_width(const Canvas& canvas, const TextStyle& style, std::string_view utf8) {
  return canvas.font.width(style.face, pixels(canvas, style), utf8);
}

void label(Canvas& canvas, const Rect& box, const TextStyle& style, std::string_view utf8) {
  int size = pixels(canvas, style);
  float width = canvas.font.width(style.face, size, utf8);
  while (width > box.w && size > smallest_size) width = canvas.font.width(style.face, --size, utf8);

  const float spare = box.w - width;
  const float x = box.x + (style.align == Align::left     ? 0
                           : style.align == Align::center ? spare / 2
                                                          : spare);
  const float cap = canvas.font.cap_height(style.face, size);
  const float baseline = std::round(box.center().y + cap / 2);
  const Rect ink =
      canvas.font.draw(canvas.list, style.face, size, {x, baseline}, style.color, utf8);
  if (!utf8.empty()) canvas.list.boxes.push_back({Box::Kind::text, ink, std::string(utf8), size});
}

void pill(Canvas& canvas, Point middle, const Rect& bounds, const TextStyle& style,
          std::string_view utf8, float opacity) {
  const float height = canvas.px(style.size * 1.6f);
  const float width = label_width(canvas, style, utf8) + height;
  const Rect box = kept_inside(centered(middle, width, height), bounds);
  fill_rounded(canvas.list, box, height / 2, faded({12, 17, 21, 215}, opacity));
  TextStyle inside = style;
  inside.align = Align::center;
  inside.color = faded(style.color, opacity);
  label(canvas, box.inset(height / 2 - 1, 0), inside, utf8);
}

}  // namespace app
