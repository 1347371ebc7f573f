#pragma once

#include <cmath>

#include "carom/vec2.hpp"
#include "replay/replay_text.hpp"

namespace app {

/// The nearest place or drag (px) that the text of a replay stores compactly: finer than a window
/// pixel, so no player can tell.
inline carom::Vec2 on_grid(carom::Vec2 v) {
  constexpr double grid = replay::text_grid;
  return {std::round(v.x / grid) * grid, std::round(v.y / grid) * grid};
}

}  // namespace app
