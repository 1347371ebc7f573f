#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/storage/best_scores.hpp"
#include "app/storage/level.hpp"

namespace app {

/// The levels on offer, the one that the player chose last, and what was reached.
struct Campaign {
  std::vector<Level> levels;
  BestScores best;
  std::size_t current = 0;
  bool practice = false;  ///< levels are played for practice

  /// The level of this identity (level.hpp), if it is on offer.
  std::optional<std::size_t> find(const std::string& identity) const {
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (levels[i].identity == identity) return i;
    return std::nullopt;
  }
  /// A level as it is on offer; if it is not, of unknown origin.
  Level known(const carom::Scene& scene) const {
    Level level = level_of(scene);
    if (const auto index = find(level.identity)) level.origin = levels[*index].origin;
    return level;
  }
  /// The next level that can be played.
  std::optional<std::size_t> next() const {
    for (std::size_t i = current + 1; i < levels.size(); ++i)
      if (levels[i].scene) return i;
    return std::nullopt;
  }
};

}  // namespace app
