#pragma once

#include <cstdint>

namespace app {

/// sRGB with straight (not premultiplied) alpha.
struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;

  friend constexpr bool operator==(Color, Color) = default;
};

/// From 0xRRGGBB.
constexpr Color rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16 & 255), static_cast<std::uint8_t>(hex >> 8 & 255),
          static_cast<std::uint8_t>(hex & 255), 255};
}

/// `a` at t = 0, `b` at t = 1.
constexpr Color mix(Color a, Color b, float t) {
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  const auto channel = [t](std::uint8_t from, std::uint8_t to) {
    const auto start = static_cast<float>(from);
    const float half_up = start + (static_cast<float>(to) - start) * t + 0.5f;
    return static_cast<std::uint8_t>(half_up);
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

/// `color`, its opacity multiplied by `opacity` in [0, 1].
constexpr Color faded(Color color, float opacity) {
  return mix({color.r, color.g, color.b, 0}, color, opacity);
}

}  // namespace app
