#include "app/graphics/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr std::int64_t sub = 256;  ///< sub-pixel steps in a pixel
constexpr float far_out = 1e6f;    ///< px; keeps the products of coordinates within 64 bits

struct Corner {
  std::int64_t x, y;  ///< 1/256 px
};

Corner corner(Point p) {
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
  Rasterizer(const Atlas& atlas, Image& image) : atlas_(atlas), image_(image) {}

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
    const bool plain =
        v[0]->texture == Point{} && v[1]->texture == Point{} && v[2]->texture == Point{};
    const float scale = 1 / static_cast<float>(area);

    for (std::int64_t y = first(top); y <= last(bottom, image_.height); ++y) {
      for (std::int64_t x = first(left); x <= last(right, image_.width); ++x) {
        std::array<float, 3> weight;
        if (!covers(sides, x, y, scale, weight)) continue;
        const auto blend_of = [&](auto channel) {
          return weight[0] * channel(*v[0]) + weight[1] * channel(*v[1]) +
                 weight[2] * channel(*v[2]);
        };
        Color color{
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.r); })),
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.g); })),
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.b); })),
            to_byte(blend_of([](const Vertex& p) { return static_cast<float>(p.color.a); }))};
        if (!plain)
          color = modulated(color, sample(blend_of([](const Vertex& p) { return p.texture.x; }),
                                          blend_of([](const Vertex& p) { return p.texture.y; })));
        blend(color, image_.at(static_cast<int>(x), static_cast<int>(y)));
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

  static Color modulated(Color a, Color b) {
    const auto product = [](std::uint8_t p, std::uint8_t q) {
      return static_cast<std::uint8_t>(times(p, q));
    };
    return {product(a.r, b.r), product(a.g, b.g), product(a.b, b.b), product(a.a, b.a)};
  }

  Color sample(float u, float v) const {
    const auto side = static_cast<float>(atlas_.side());
    // Texels are what they are at their centres; the weights are those of graphics hardware, in
    // 256ths, so that what is drawn texel on pixel stays as it is.
    const auto place = [side](float at) {
      return static_cast<int>(std::lround(std::clamp(at * side - 0.5f, 0.0f, side - 1) * 256));
    };
    const int x = place(u);
    const int y = place(v);
    const auto texel = [&](int column, int row) {
      const auto last = static_cast<std::size_t>(atlas_.side()) - 1;
      return atlas_.texels()[std::min(static_cast<std::size_t>(row), last) * (last + 1) +
                             std::min(static_cast<std::size_t>(column), last)];
    };
    const auto part_of = [](Color from, Color to, int part) {
      const auto channel = [part](std::uint8_t p, std::uint8_t q) {
        return static_cast<std::uint8_t>((p * (256 - part) + q * part + 128) / 256);
      };
      return Color{channel(from.r, to.r), channel(from.g, to.g), channel(from.b, to.b),
                   channel(from.a, to.a)};
    };
    const int column = x / 256;
    const int row = y / 256;
    return part_of(part_of(texel(column, row), texel(column + 1, row), x % 256),
                   part_of(texel(column, row + 1), texel(column + 1, row + 1), x % 256), y % 256);
  }

  static void blend(Color color, Color& pixel) {
    const std::uint32_t opacity = color.a;
    if (pixel.a == 255) {
      const auto channel = [opacity](std::uint8_t over, std::uint8_t under) {
        return static_cast<std::uint8_t>((over * opacity + under * (255 - opacity) + 127) / 255);
      };
      pixel = {channel(color.r, pixel.r), channel(color.g, pixel.g), channel(color.b, pixel.b)};
      return;
    }
    const std::uint32_t ground = times(pixel.a, 255 - opacity);
    const std::uint32_t sum = opacity + ground;
    if (sum == 0) return;
    const auto channel = [=](std::uint8_t over, std::uint8_t under) {
      return static_cast<std::uint8_t>((over * opacity + under * ground + sum / 2) / sum);
    };
    pixel = {channel(color.r, pixel.r), channel(color.g, pixel.g), channel(color.b, pixel.b),
             static_cast<std::uint8_t>(sum)};
  }

  const Atlas& atlas_;
  Image& image_;
};

}  // namespace

void rasterize(const DrawList& list, const Atlas& atlas, Image& image) {
  Rasterizer rasterizer(atlas, image);
  const auto vertex = [&](std::size_t i) {
    return &list.vertices[static_cast<std::size_t>(list.indices[i])];
  };
  for (std::size_t i = 0; i + 2 < list.indices.size(); i += 3)
    rasterizer.draw({vertex(i), vertex(i + 1), vertex(i + 2)});
}

}  // namespace app
