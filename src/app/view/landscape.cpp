#include "app/view/landscape.hpp"

#include <array>
#include <vector>

#include "app/graphics/noise.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

constexpr float least_detailed = 160;  ///< px of the unit: in a smaller picture details are specks

void draw_sky(DrawList& list, Rect area, float horizon, float unit) {
  const float low = std::clamp(horizon - area.y, 0.0f, area.h);
  Rect sky = area.cut_top(low);
  const Rect glowing = sky.cut_bottom(std::min(low, unit * 0.62f));
  // Each reaches under the next: no seams.
  const auto band = [&](const Rect& box, Color top, Color bottom) {
    fill_rounded(list, box.inset(-2), 0, Paint::vertical(box, top, bottom));
  };
  // All the rest, however much that is: in a window higher than wide, most of it.
  if (sky.h > 0) band(sky, palette::sky_top, palette::sky_middle);
  if (glowing.h > 0) band(glowing, palette::sky_middle, palette::sky_low);
  const Point sun{area.x + area.w * 0.32f, horizon - unit * 0.33f};
  glow(list, sun, unit * 0.85f, unit * 0.6f, faded(palette::sun, 0.4f));
  const float r = unit * 0.08f;
  fill_disc(list, sun, r,
            Paint(sun - Point{0, r}, palette::sun, sun + Point{0, r}, palette::sun_low));
}

/// Long thin clouds, lit from below; where there is much sky, all over it.
void draw_clouds(DrawList& list, const Rect& area, float horizon, float unit) {
  const float spread = std::max((horizon - area.y) / unit - 0.6f, 0.75f);
  for (std::uint32_t i = 0; i < 7; ++i) {
    const Point c{area.x + area.w * (static_cast<float>(i) + noise(1, i)) / 7,
                  horizon - unit * (0.5f + spread * noise(2, i))};
    const float across = unit * (0.14f + 0.2f * noise(3, i));
    if (c.y < area.y) continue;
    for (std::uint32_t puff = 0; puff < 3; ++puff) {
      const float off = static_cast<float>(puff) - 1;
      glow(list, c + Point{across * 0.5f * off, unit * 0.012f * off * off},
           across * (1 - 0.3f * off * off), unit * 0.03f, faded(palette::sun, 0.28f));
    }
  }
}

/// Woods of pointed trees along a skyline.
void draw_firs(DrawList& list, const Outline& line, float unit) {
  const Color color = mix(palette::hills[2], palette::hills[1], 0.25f);
  float next = line.front().x;
  std::uint32_t tree = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    while (next < line[i + 1].x) {
      const float x = next;
      next += unit * (0.006f + 0.022f * noise(11, ++tree));
      // Some woods, and clearings between them.
      const float wood = noise(9, tree / 20);
      if (wood < 0.5f) continue;
      const Point foot =
          line[i] + (line[i + 1] - line[i]) * ((x - line[i].x) / (line[i + 1].x - line[i].x));
      const float height = unit * (0.018f + 0.042f * noise(10, tree) * wood);
      fill(list,
           std::array{foot + Point{-height * 0.24f, unit * 0.01f}, foot - Point{0, height},
                      foot + Point{height * 0.24f, unit * 0.01f}},
           color);
    }
  }
}

/// The nearer, the darker; mist lies in the valleys between them, and firs stand on the nearest.
void draw_hills(DrawList& list, const Rect& area, float horizon, float unit) {
  for (int range = 0; range < 3; ++range) {
    const Color color = palette::hills[range];
    const auto depth = static_cast<float>(range);
    const Outline line = ridge(area, horizon, unit, range);
    const Rect body{area.x, horizon - unit * (0.26f - 0.08f * depth), area.w,
                    unit * (0.26f - 0.08f * depth)};
    if (range == 2 && unit > least_detailed) draw_firs(list, line, unit);
    fill_under(list, line, horizon,
               Paint::vertical(body, color, mix(color, palette::sky_low, 0.6f - 0.22f * depth)));
  }
}

void draw_ground(DrawList& list, const Rect& area, float horizon, float unit) {
  const float depth = std::max(area.bottom() - horizon, 0.0f);
  const Rect soil{area.x, horizon, area.w, depth};
  fill_rounded(list, soil, 0, Paint::vertical(soil, palette::soil, palette::soil_dark));
  const auto pebbles =
      unit < least_detailed
          ? 0
          : static_cast<std::uint32_t>(std::clamp(area.w / unit * 40, 0.0f, 400.0f));
  for (std::uint32_t i = 0; i < pebbles; ++i) {
    const float down = unit * 0.03f + (depth - unit * 0.04f) * noise(5, i);
    if (down > depth - unit * 0.008f) continue;
    const Point c{area.x + area.w * noise(4, i), horizon + down};
    const float r = unit * (0.003f + 0.006f * noise(6, i));
    fill(list, ellipse(c, r * 1.6f, r),
         faded(i % 2 == 0 ? palette::sky_low : palette::soil_dark, 0.22f));
  }
  const Rect turf{area.x, horizon, area.w, std::min(unit * 0.022f, depth)};
  fill_rounded(list, turf, 0, Paint::vertical(turf, palette::grass, palette::grass_dark));
  const float pitch = unit * 0.02f;
  const int blades = static_cast<int>(std::min(area.w / pitch, 800.0f));
  for (int i = 0; i < blades; ++i) {  // the turf's ragged lower edge
    const float x = area.x + pitch * static_cast<float>(i);
    const float drop = unit * (0.006f + 0.014f * noise(7, static_cast<std::uint32_t>(i)));
    const Point tip{x + pitch / 2, turf.bottom() + drop};
    if (tip.y > area.bottom()) break;
    const Point left{x, turf.bottom() - 1};
    const Point right{x + pitch, turf.bottom() - 1};
    fill(list, std::vector{left, right, tip}, palette::grass_dark);
  }
  line(list, {area.x, horizon}, {area.right(), horizon}, std::max(unit * 0.004f, 1.0f),
       mix(palette::grass, palette::sun, 0.35f));
}

}  // namespace

Outline ridge(const Rect& area, float horizon, float unit, int range) {
  constexpr int points = 96;
  const auto depth = static_cast<float>(range);
  Outline line;
  for (int i = 0; i <= points; ++i) {
    const float x = area.x + area.w * static_cast<float>(i) / points;
    // Waves of lengths that never meet again.
    const float at = (x - area.center().x) / unit * (1.5f + 0.8f * depth) + 11 * depth;
    const float wave = 0.5f + 0.26f * std::sin(at * 1.7f) + 0.16f * std::sin(at * 4.1f + 1) +
                       0.05f * std::sin(at * 11.3f + 2);
    line.push_back({x, horizon - unit * (0.30f - 0.09f * depth) * wave - unit * 0.02f});
  }
  return line;
}

void draw_landscape(DrawList& list, const Rect& area, float horizon, float unit) {
  if (area.w < 1 || area.h < 1 || unit < 1) {  // nothing to be seen of it
    fill_rounded(list, area, 0, palette::sky_middle);
    return;
  }
  const std::size_t first = list.vertices.size();
  draw_sky(list, area, horizon, unit);
  draw_clouds(list, area, horizon, unit);
  draw_hills(list, area, horizon, unit);
  draw_ground(list, area, horizon, unit);
  clip(list, first, area);
}

void draw_night(DrawList& list, const Rect& area, float horizon) {
  const float unit = std::max(std::min(area.w, area.h), 1.0f);
  fill_lamplit(list, area,
               {{area.x + area.w * 0.68f, horizon},
                std::max(area.w * 0.8f, 1.0f),
                unit * 1.1f,
                mix(palette::sky_middle, palette::slate_bottom, 0.52f),
                palette::slate_bottom});
  const std::size_t first = list.vertices.size();
  for (int range = 0; range < 3; ++range) {
    const Color color = mix(palette::hills[range], palette::slate_bottom, 0.74f);
    const Rect body{area.x, horizon - unit * 0.25f, area.w, unit * 0.25f};
    fill_under(list, ridge(area, horizon, unit, range), std::max(horizon, area.bottom()),
               Paint::vertical(body, color, mix(color, palette::slate_bottom, 0.6f)));
  }
  clip(list, first, area);
}

}  // namespace app
