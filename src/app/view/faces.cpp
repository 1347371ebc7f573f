#include "app/view/faces.hpp"

#include <array>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

constexpr Color dark = rgb(0x1b1512);
constexpr Color white = rgb(0xffffff);

/// A curve through the mouth's corners; `sag` lifts (> 0) or drops its middle. Radii of the ball.
void draw_mouth(DrawList& list, Point middle, float half, float sag, float width) {
  constexpr int bends = 12;
  const auto at = [&](int i) {
    const float t = static_cast<float>(i) / bends * 2 - 1;
    return middle + Point{half * t, sag * t * t};
  };
  for (int i = 0; i < bends; ++i) fill(list, capsule(at(i), at(i + 1), width), dark);
}

}  // namespace

void draw_angry_face(DrawList& list, Point c, float r) {
  for (const float side : {-1.0f, 1.0f}) {
    const Point eye = c + Point{r * (0.12f + side * 0.34f), -r * 0.02f};
    fill_disc(list, eye, r * 0.2f, white);
    stroke_circle(list, eye, r * 0.2f, r * 0.025f, faded(dark, 0.5f));
    fill_disc(list, eye + Point{r * 0.06f, r * 0.03f}, r * 0.105f, dark);
    fill_disc(list, eye + Point{r * 0.09f, -r * 0.01f}, r * 0.032f, white);
    const Point inner = eye + Point{-side * r * 0.24f, -r * 0.1f};
    const Point outer = eye + Point{side * r * 0.24f, -r * 0.34f};
    fill(list, capsule(inner, outer, r * 0.15f), dark);
  }
  draw_mouth(list, c + Point{r * 0.13f, r * 0.5f}, r * 0.27f, r * 0.14f, r * 0.09f);
}

void draw_horns(DrawList& list, Point c, float r) {
  for (const float side : {-1.0f, 1.0f}) {
    const Point root = c + Point{side * r * 0.52f, -r * 0.72f};
    const Point tip = c + Point{side * r * 0.86f, -r * 1.32f};
    const std::array horn{root + Point{-side * r * 0.26f, r * 0.04f}, tip,
                          root + Point{side * r * 0.3f, r * 0.3f}};
    fill(list, horn, Paint(root, palette::iron, tip, rgb(0xefe2c4)));
  }
}

void draw_villain_face(DrawList& list, Point c, float r) {
  for (const float side : {-1.0f, 1.0f}) {
    const Point eye = c + Point{r * (-0.1f + side * 0.36f), -r * 0.06f};
    fill_disc(list, eye, r * 0.21f, rgb(0xffe9a8));
    fill_disc(list, eye + Point{-r * 0.07f, r * 0.04f}, r * 0.1f, dark);
  }
  // One heavy brow, deep over the nose.
  const Point nose = c + Point{-r * 0.1f, -r * 0.16f};
  for (const float side : {-1.0f, 1.0f})
    fill(list, capsule(nose, nose + Point{side * r * 0.6f, -r * 0.26f}, r * 0.17f), dark);
  // A grin with two fangs.
  const Point mouth = c + Point{-r * 0.1f, r * 0.52f};
  draw_mouth(list, mouth, r * 0.4f, -r * 0.18f, r * 0.12f);
  for (const float side : {-1.0f, 1.0f}) {
    const Point root = mouth + Point{side * r * 0.2f, -r * 0.06f};
    const std::array fang{root + Point{-r * 0.1f, 0}, root + Point{r * 0.1f, 0},
                          root + Point{0, r * 0.24f}};
    fill(list, fang, white);
  }
}

}  // namespace app
