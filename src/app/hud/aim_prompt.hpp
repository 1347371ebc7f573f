#pragma once

#include <vector>

#include "app/graphics/geometry.hpp"
#include "app/text/text.hpp"

namespace app {

/// Where the player has to do something with a ball, and what.
struct AimPrompt {
  Point at;          ///< window px, the ball's centre
  float radius = 0;  ///< window px
  Text what{};
  std::vector<Rect> in_sight{};  ///< what a lesson should not cover, window px
};

}  // namespace app
