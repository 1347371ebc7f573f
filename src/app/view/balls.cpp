#include "app/view/balls.hpp"

#include <numbers>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/graphics/stamps.hpp"

namespace app {

BallLook look_of(BallKind kind, const Palette& palette) {
  switch (kind) {
    case BallKind::ivory:
      return {palette::ivory, palette::ivory_shade};
    case BallKind::red:
      return {palette.ball, palette.ball_shade};
    case BallKind::wooden:
      return {palette::wood, palette::wood_shade, 0.15f};
    case BallKind::stone:
      break;
  }
  return {palette::stone, palette::stone_shade, 0.1f};
}

namespace {

struct Direction {
  float x, y, z;
};
constexpr Direction light{-0.42f, -0.58f, 0.70f};  ///< of unit length, towards the lamp

/// The colour of a sphere where its surface faces `normal` (z towards the eye).
Color shaded(const BallLook& look, Direction normal) {
  const float facing = normal.x * light.x + normal.y * light.y + normal.z * light.z;
  const float diffuse = std::clamp(0.25f + 0.85f * facing, 0.0f, 1.0f);
  const float gloss = std::pow(std::max(facing, 0.0f), 9.0f);
  return mix(mix(look.shade, look.base, diffuse), palette::glint, 0.28f * look.gloss * gloss);
}

}  // namespace

void draw_ball(DrawList& list, Point center, float radius, const BallLook& look, float opacity) {
  const int rings = std::clamp(static_cast<int>(radius / 3), 4, 20);
  const int around = std::clamp(static_cast<int>(radius * 2), 20, 128);
  const auto ring_index = [&](std::int32_t first, int ring, int i) {
    return first + 1 + (ring - 1) * around + i % around;
  };
  const auto first = list.add(center, faded(shaded(look, {0, 0, 1}), opacity));
  // Rings crowd towards the rim, where the shading changes fastest; the last is the soft edge.
  for (int ring = 1; ring <= rings + 1; ++ring) {
    const float tilt = std::numbers::pi_v<float> / 2 * static_cast<float>(std::min(ring, rings)) /
                       static_cast<float>(rings);
    const float out = std::sin(tilt);
    const float distance =
        ring <= rings ? std::max(out * radius - crisp / 2, 0.0f) : radius + crisp / 2;
    for (int i = 0; i < around; ++i) {
      const float turn =
          2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
      const Point way{std::cos(turn), std::sin(turn)};
      const Color color = shaded(look, {way.x * out, way.y * out, std::cos(tilt)});
      list.add(center + way * distance, faded(color, ring <= rings ? opacity : 0));
    }
  }
  for (int i = 0; i < around; ++i)
    list.triangle(first, ring_index(first, 1, i), ring_index(first, 1, i + 1));
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < around; ++i)
      list.quad(ring_index(first, ring, i), ring_index(first, ring, i + 1),
                ring_index(first, ring + 1, i + 1), ring_index(first, ring + 1, i));
  }
  const Point lamp = center + Point{light.x, light.y} * (radius * 0.62f);
  glow(list, lamp, radius * 0.34f, radius * 0.27f,
       faded(palette::glint, 0.9f * look.gloss * opacity));
}

void draw_ball(DrawList& list, Point center, float radius, BallKind kind) {
  const BallLook look = look_of(kind, *list.palette);
  stamp(list, {Stamps::Key::Of::ball, radius, static_cast<std::uint32_t>(kind)}, center,
        radius + crisp, [&look](DrawList& on, Point c, float r) { draw_ball(on, c, r, look); });
}

void draw_ball_shadow(DrawList& list, Point center, float radius) {
  glow(list, center + Point{radius * 0.35f, radius * 0.5f}, radius * 1.35f, radius * 1.3f,
       {0, 0, 0, 150});
}

}  // namespace app
