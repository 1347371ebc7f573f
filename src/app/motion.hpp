#pragma once

#include <vector>

#include "carom/world.hpp"

namespace app {

/// Where the balls were before the last step, by id, so that they can be drawn between two steps.
class Motion {
 public:
  /// Remembers where the balls are: before each step, and after a ball is moved by hand.
  void record(const carom::World& world);
  /// Where to draw the ball at `index`: `fraction` of the way from where it was to where it is.
  carom::Vec2 position(const carom::World& world, std::size_t index, double fraction) const;

 private:
  std::vector<carom::Vec2> before_;  ///< px, by id
};

}  // namespace app
