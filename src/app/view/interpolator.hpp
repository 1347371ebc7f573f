#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "carom/world.hpp"

namespace app {

/// Where the balls were before the last steps, by id, so that they can be drawn between two steps,
/// and a trail behind them.
class Interpolator {
 public:
  static constexpr std::size_t remembered = 8;  ///< steps

  /// Remembers where the balls are: before each step.
  void record(const carom::World& world);
  /// Forgets how the balls came to where they are: after one is moved by hand.
  void restart(const carom::World& world);
  /// Where to draw the ball at `index`: `fraction` of the way from where it was to where it is.
  carom::Vec2 position(const carom::World& world, std::size_t index, double fraction) const;
  /// Where the ball was before each of the last steps, px, latest first.
  std::span<const carom::Vec2> past(std::uint32_t id) const;

 private:
  struct Past {
    std::array<carom::Vec2, remembered> places{};
    std::size_t known = 0;
  };
  std::vector<Past> past_;  ///< by id
};

}  // namespace app
