#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "carom/rollouts.hpp"
#include "search/opponent.hpp"

namespace search {

/// A game that still goes on then is decided by its points.
inline constexpr int most_turns = 1000;

/// The course of a game; arrays by side, as in play_game().
struct GameResult {
  std::optional<int> winner{};  ///< none: a draw
  std::array<std::int64_t, 2> points{};
  std::array<int, 2> fouls{};
  std::array<int, 2> turns{};
  std::array<std::uint64_t, 2> simulations{};
  std::uint64_t hash = 0;  ///< of all drags, places and points, in order
  friend bool operator==(const GameResult&, const GameResult&) = default;
};

/// Plays a game by the report's rules, from the rack. `breaker`: the side that breaks, 0 or 1. With
/// the same seed and the other breaker it is the mirrored game: each side has the random numbers
/// that the other had.
GameResult play_game(const std::array<Level, 2>& sides, int breaker, Seed seed,
                     carom::Rollouts& rollouts);

}  // namespace search
