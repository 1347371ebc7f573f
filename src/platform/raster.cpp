#include "platform/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace platform {
namespace {

using app::Vertex;

constexpr std::int64_t sub = 256;  ///< sub-pixel steps in a pixel
constexpr float far_out = 1e6f;    ///< px; keeps the products of coordinates within 64 bits

struct Corner {
  std::int64_t x, y;  ///< 1/256 px
};

Corner corner(app::Point p) {
  const auto fixed = [](float value) {
    return static_cast<std::int64_t>(
        std::lround(std::clamp(value, -far_out, far_out) * static_cast<float>(sub)));
  };
  return {fixed(p.x), fixed(p.y)};
}

/// One side of a triangle whose inside lies where the value is positive.
struct Side {
  std::int64_t per_x, per_y, constant;

  Side(Corner a, Corner b)
      : per_x(a.y - b.y), per_y(b.x - a.x), constant(-(per_x * a.x + per_y * a.y)) {}

  std::int64_t at(std::int64_t x, std::int64_t y) const { return per_x * x + per_y * y + constant; }
  /// A centre exactly on the side counts as inside on top and left sides only.
  bool owns_its_line() const { return per_x > 0 || (per_x == 0 && per_y > 0); }
};

/// Multiplies two fractions of 255, rounded.
std::uint32_t times(std::uint32_t a, std::uint32_t b) { return (a * b + 127) / 255; }

std::uint8_t to_byte(float value) {
  const float half_up = std::clamp(value, 0.0f, 255.0f) + 0.5f;
  return static_cast<std::uint8_t>(half_up);
}

class Rasterizer {
 public:
  Rasterizer(const app::Atlas& atlas, Image& image) : atlas_(atlas), image_(image) {}

  void draw(std::array<const Vertex*, 3> v) {
    std::array<Corner, 3> c{corner(v[0]->position), corner(v[1]->position), corner(v[2]->position)};
    std::int64_t area = Side(c[0], c[1]).at(c[2].x, c[2].y);
    if (area == 0) return;
    if (area < 0) {
      std::swap(c[1], c[2]);
      std::swap(v[1], v[2]);
      area = -area;
    }
    const std::array sides{Side(c[1], c[2]), Side(c[2], c[0]), Side(c[0], c[1])};
    const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
    const auto first = [](std::int64_t edge) { return std::max<std::int64_t>(edge / sub - 1, 0); };
    const auto last = [](std::int64_t edge, int size) {
      return std::min<std::int64_t>(edge / sub + 1, size - 1);
    };
    const bool plain = v[0]->texture == app::Point{} && v[1]->texture == app::Point{} &&
                       v[2]->texture == app::Point{};
    const float scale = 1 / static_cast<float>(area);

    for (std::int64_t y = first(top); y <= last(bottom, image_.height); ++y) {
      for (std::int64_t x = first(left); x <= last(right, image_.width); ++x) {
        std::array<float, 3> weight;
        if (!covers(sides, x, y, scale, weight)) continue;
        const auto blend_of = [&](auto channel) {
          return weight[0] * channel(*v[0]) + weight[1] * channel(*v[1]) +
                 weight[2] * channel(*v[2]);
        };
        const app::Color color{
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.r); })),
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.g); })),
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.b); })),
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.a); }))};
        std::uint32_t opacity = color.a;
        if (!plain)
          opacity = times(opacity, sample(blend_of([](const Vertex& p) { return p.texture.x; }),
                                          blend_of([](const Vertex& p) { return p.texture.y; })));
        put(x, y, color, opacity);
      }
    }
  }

 private:
  static bool covers(const std::array<Side, 3>& sides, std::int64_t x, std::int64_t y, float scale,
                     std::array<float, 3>& weight) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t value = sides[i].at(x * sub + sub / 2, y * sub + sub / 2);
      if (value < 0 || (value == 0 && !sides[i].owns_its_line())) return false;
      weight[i] = static_cast<float>(value) * scale;
    }
    return true;
  }

  /// Glyphs are drawn texel on pixel, so the nearest texel is the right one.
  std::uint32_t sample(float u, float v) const {
    const auto texel = [side = atlas_.side](float at) {
      return static_cast<std::size_t>(
          std::clamp(static_cast<int>(at * static_cast<float>(side)), 0, side - 1));
    };
    return atlas_.coverage[texel(v) * static_cast<std::size_t>(atlas_.side) + texel(u)];
  }

  void put(std::int64_t x, std::int64_t y, app::Color color, std::uint32_t opacity) {
    std::uint8_t* pixel = &image_.rgba[static_cast<std::size_t>((y * image_.width + x) * 4)];
    const std::array channels{color.r, color.g, color.b};
    for (std::size_t i = 0; i < 3; ++i)
      pixel[i] = static_cast<std::uint8_t>(
          (channels[i] * opacity + pixel[i] * (255 - opacity) + 127) / 255);
  }

  const app::Atlas& atlas_;
  Image& image_;
};

}  // namespace

Image rasterize(const app::DrawList& list, const app::Atlas& atlas, int width, int height) {
  Image image{width, height, {}};
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.rgba.resize(pixels * 4);
  for (std::size_t i = 0; i < pixels; ++i) image.rgba[i * 4 + 3] = 255;

  Rasterizer rasterizer(atlas, image);
  const auto vertex = [&](std::size_t i) {
    return &list.vertices[static_cast<std::size_t>(list.indices[i])];
  };
  for (std::size_t i = 0; i + 2 < list.indices.size(); i += 3)
    rasterizer.draw({vertex(i), vertex(i + 1), vertex(i + 2)});
  return image;
}

}  // namespace platform
