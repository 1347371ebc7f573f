#include "app/view/icon.hpp"

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/balls.hpp"
#include "app/view/faces.hpp"

namespace app {

Image draw_icon(int side) {
  constexpr Color cloth = rgb(0x115054);
  const auto unit = static_cast<float>(side) / 128;
  const Point center = Point{64, 62} * unit;
  const float radius = 48 * unit;
  DrawList list;
  fill_rounded(list, {0, 0, 128 * unit, 128 * unit}, 24 * unit, cloth);
  glow(list, Point{68, 108} * unit, 44 * unit, 10 * unit, rgb(0x062b2e));
  draw_ball(list, center, radius, look_of(BallKind::ivory, Palette::of(Colours::standard)));
  draw_angry_face(list, center, radius);
  Image icon(side, side, faded(cloth, 0));
  rasterize(list, Atlas(64), icon);
  return icon;
}

}  // namespace app
