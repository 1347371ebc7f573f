#pragma once

#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "carom/rollouts.hpp"
#include "carom/vec2.hpp"
#include "games/angry_balls.hpp"
#include "games/random.hpp"
#include "search/estimate.hpp"
#include "search/hand.hpp"
#include "search/seed.hpp"

namespace search {

/// A computer player whose pass rate says how hard a level is: before each throw it searches, and
/// its hand makes what it makes of the throw found.
struct LevelPlayer {
  Hand hand{};
  std::uint64_t simulations = 200;  ///< a throw
};

/// Difficulty of a level: 1 − the pass rate of this player.
inline constexpr LevelPlayer reference_player{.hand = {4}};

/// Games of one level that were played to their ends.
struct LevelGames {
  std::uint64_t games = 0;
  std::vector<std::uint64_t> won_in{};  ///< games won by the throw of this number, from 0
  std::vector<std::int64_t> scores{};   ///< of the games won, the lowest first

  std::uint64_t won() const {
    return std::accumulate(won_in.begin(), won_in.end(), std::uint64_t{0});
  }
  Estimate rate() const { return estimate_rate(games, won()); }
  friend bool operator==(const LevelGames&, const LevelGames&) = default;
};

/// A drag on the grid, uniform within the greatest one; not zero.
carom::Vec2 random_drag(games::Random& random);

/// Plays so many games of `level`, a game at its start. No player: drags are random_drag()s.
LevelGames play_level(const games::angry_balls::Game& level,
                      const std::optional<LevelPlayer>& player, std::uint64_t count, Seed seed,
                      carom::Rollouts& rollouts);

}  // namespace search
