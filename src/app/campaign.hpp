#pragma once

#include <optional>
#include <vector>

#include "app/best_scores.hpp"
#include "app/level.hpp"

namespace app {

/// The levels on offer, the one that the player chose last, and what was reached.
struct Campaign {
  std::vector<Level> levels;
  BestScores best;
  std::size_t current = 0;

  /// The next level that can be played.
  std::optional<std::size_t> next() const {
    for (std::size_t i = current + 1; i < levels.size(); ++i)
      if (levels[i].scene) return i;
    return std::nullopt;
  }
};

}  // namespace app
