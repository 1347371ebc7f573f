#include "app/graphics/label.hpp"

#include "app/base/utf8.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

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

void label_or_elide(Canvas& canvas, const Rect& box, const TextStyle& style,
                    std::string_view utf8) {
  TextStyle least = style;
  least.size = std::min(style.size, 16.0f);
  label(canvas, box, style, elided(canvas, least, utf8, box.w));
}

std::string elided(const Canvas& canvas, const TextStyle& style, std::string_view utf8,
                   float width) {
  if (label_width(canvas, style, utf8) <= width) return std::string(utf8);
  std::string text;
  do {
    if (utf8.empty()) return text;
    utf8 = without_last_code_point(utf8);
    text = std::string(utf8) + "…";
  } while (label_width(canvas, style, text) > width);
  return text;
}

void paragraph(Canvas& canvas, Rect box, const TextStyle& style, std::string_view utf8) {
  const float line_height = canvas.px(style.size * 1.25f);
  while (!utf8.empty() && box.h >= line_height) {
    const bool last = box.h < 2 * line_height;
    std::size_t end = utf8.size();
    while (!last && label_width(canvas, style, utf8.substr(0, end)) > box.w) {
      const std::size_t space = utf8.substr(0, end).rfind(' ');
      if (space == std::string_view::npos) break;
      end = space;
    }
    label(canvas, box.cut_top(line_height), style,
          elided(canvas, style, utf8.substr(0, end), box.w));
    utf8.remove_prefix(std::min(end + 1, utf8.size()));
  }
}

Rect pill_box(const Canvas& canvas, Point middle, const Rect& bounds, const TextStyle& style,
              std::string_view utf8) {
  const float height = canvas.px(style.size * 1.6f);
  return kept_inside(centered(middle, label_width(canvas, style, utf8) + height, height), bounds);
}

void pill(Canvas& canvas, const Rect& box, const TextStyle& style, std::string_view utf8,
          float opacity) {
  fill_rounded(canvas.list, box, box.h / 2, faded({12, 17, 21, 215}, opacity));
  TextStyle inside = style;
  inside.align = Align::center;
  inside.color = faded(style.color, opacity);
  label(canvas, box.inset(box.h / 2 - 1, 0), inside, utf8);
}

}  // namespace app
