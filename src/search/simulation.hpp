#pragma once

#include <cstdint>
#include <optional>

#include "carom/vec2.hpp"
#include "carom/world.hpp"
#include "search/aim.hpp"
#include "search/estimate.hpp"

namespace search {

/// A player's decision for a turn.
struct Shot {
  std::optional<carom::Vec2> place{};  ///< px, where the cue ball in hand goes first
  Aim aim{};
  friend bool operator==(const Shot&, const Shot&) = default;
};

/// The outcome of one shot.
struct Trial {
  std::int64_t points = 0;
  std::uint32_t enemies_out = 0;  ///< in a level
  bool cleared = false;           ///< nothing is left to be shot at
  bool foul = false;              ///< the cue ball went out of play
  bool touched = false;           ///< the lead met another ball
};

/// Plays a shot on `world` by the rules (games::play_out). `drag`: px, not zero; `place` and `drag`
/// must be ones that the game would take. Allocates nothing.
Trial simulate(carom::World& world, const std::optional<carom::Vec2>& place, carom::Vec2 drag);

/// Simulations whose trials are kept side by side, at most.
inline constexpr std::uint64_t most_at_once = 4096;

/// Sums of trials: whole numbers, so their order does not matter.
struct Record {
  std::uint64_t n = 0;
  std::int64_t points = 0;
  std::int64_t points_squared = 0;
  std::int64_t enemies_out = 0;
  std::int64_t enemies_out_squared = 0;
  std::uint64_t scored = 0;  ///< with any points
  std::uint64_t cleared = 0;
  std::uint64_t fouls = 0;
  std::uint64_t touched = 0;

  void add(const Trial& trial);

  Estimate points_estimate() const { return estimate_mean(n, points, points_squared); }
  Estimate enemies_estimate() const { return estimate_mean(n, enemies_out, enemies_out_squared); }
  Estimate scored_estimate() const { return estimate_rate(n, scored); }
  Estimate cleared_estimate() const { return estimate_rate(n, cleared); }
  Estimate foul_estimate() const { return estimate_rate(n, fouls); }
  friend bool operator==(const Record&, const Record&) = default;
};

}  // namespace search
