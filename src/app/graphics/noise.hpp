#pragma once

#include <cstdint>

namespace app {

/// The `index`-th of a row of numbers in [0, 1) that look random and are always the same.
constexpr float noise(std::uint32_t row, std::uint32_t index) {
  std::uint32_t x = row * 0x9e3779b9u + index * 0x85ebca6bu + 0x27d4eb2fu;
  x = (x ^ (x >> 15)) * 0x2c1b3c6du;
  x = (x ^ (x >> 12)) * 0x297a2d39u;
  return static_cast<float>((x ^ (x >> 15)) >> 8) / static_cast<float>(1u << 24);
}

}  // namespace app
