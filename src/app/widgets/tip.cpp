#include "app/widgets/tip.hpp"

#include <algorithm>
#include <array>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

constexpr float tip_height = 28;  ///< units, of one line

const TextStyle tip_style{Face::regular, 16, palette::cream, Align::center};

void draw_at(Canvas& canvas, const Rect& box, std::string_view text) {
  fill_rounded(canvas.list, box, canvas.px(6), palette::slate_bottom);
  stroke_rounded(canvas.list, box, canvas.px(6), canvas.px(1), palette::brass);
  const std::size_t first = canvas.list.boxes.size();
  const Rect inside = box.inset(canvas.px(8), 0);
  if (box.h > canvas.px(tip_height))
    paragraph(canvas, inside.inset(0, canvas.px(2)), tip_style, text);
  else
    label(canvas, inside, tip_style, text);
  for (std::size_t i = first; i < canvas.list.boxes.size(); ++i)
    canvas.list.boxes[i].kind = Box::Kind::tip;
}

/// On two lines if one is too long for the window.
Rect box_of(const Canvas& canvas, Point middle, std::string_view text) {
  const float width = label_width(canvas, tip_style, text) + canvas.px(20);
  const float most = canvas.view.width - 2 * canvas.px(4);
  return width <= most ? centered(middle, width, canvas.px(tip_height))
                       : centered(middle, most, canvas.px(2 * tip_height - 6));
}

}  // namespace

void draw_tip(Canvas& canvas) {
  if (!canvas.list.tip) return;
  const Tip tip = *canvas.list.tip;
  const Rect window = canvas.view.area().inset(canvas.px(4));
  const Rect size = box_of(canvas, {}, tip.text);
  const float gap = canvas.px(8);
  const Point middle = tip.button.center();
  const float across = (tip.button.w + size.w) / 2 + gap;
  const float down = (tip.button.h + size.h) / 2 + gap;
  const std::array places{Point{0, down}, Point{across, 0}, Point{0, -down}, Point{-across, 0}};
  const auto box_at = [&](Point by) {
    // Above and below it may be pushed aside.
    const Rect box = centered(middle + by, size.w, size.h);
    return by.x == 0 ? Rect{kept_inside(box, window).x, box.y, box.w, box.h} : box;
  };
  const auto worth = [&](Point by) {
    const Rect box = box_at(by);
    const bool outside = box.x < window.x || box.y < window.y || box.right() > window.right() ||
                         box.bottom() > window.bottom();
    const auto covers = std::ranges::count_if(canvas.list.boxes, [&](const Box& other) {
      return other.kind == Box::Kind::button && other.area.overlaps(box);
    });
    return (outside ? -1000 : 0) - static_cast<int>(covers);
  };
  const Point best = *std::ranges::max_element(places, {}, worth);
  draw_at(canvas, kept_inside(box_at(best), window), tip.text);
}

void draw_note(Canvas& canvas, Point middle, std::string_view text) {
  const Rect window = canvas.view.area().inset(canvas.px(4));
  draw_at(canvas, kept_inside(box_of(canvas, middle, text), window), text);
}

}  // namespace app
