#pragma once

#include <cstdint>
#include <vector>

#include "carom/rollouts.hpp"
#include "games/angry_balls.hpp"
#include "replay/replay.hpp"
#include "search/aim.hpp"
#include "search/seed.hpp"

/// Finds throws that clear a level, and how far each may be off (docs/search.md).
namespace search {

/// Throws one after the other, each when the one before is over.
using Throws = std::vector<Aim>;

/// The box around an aim, within which a level is still won: ± this many tenths of a degree and
/// ± margin_speed times as many px/s, tried in steps of a tenth and of margin_speed.
using Margin = int;
inline constexpr int margin_speed = 2;  ///< px/s a tenth
inline constexpr Margin widest_margin = 20;
/// The margin of an aim that does not win itself.
inline constexpr Margin no_margin = -1;

struct Solved {
  std::vector<Throws> found{};    ///< ways that win, with equally few throws; empty: none
  std::uint64_t simulations = 0;  ///< played
};

/// Searches for throws that win `level`, a game at its start, as few as it finds: a beam over
/// throws, of which the best states of each are searched on, in rounds with twice the simulations
/// of the one before. It ends with the first that finds any, or, within a round, once `simulations`
/// are used up.
Solved solve(const games::angry_balls::Game& level, std::uint64_t simulations, Seed seed,
             carom::Rollouts& rollouts);

/// The margin of the throw with this index while the others stay.
Margin margin(const games::angry_balls::Game& level, const Throws& throws, std::size_t index,
              carom::Rollouts& rollouts);

/// Of many ways to win with as many throws as `solved` the one whose least margin is the widest
/// that was found: solutions are moved towards where there is more room. Solved::found is not
/// empty.
Throws most_robust(const games::angry_balls::Game& level, const Solved& solved, Seed seed,
                   carom::Rollouts& rollouts);

/// The game that these throws make, up to its end or to the end of the last of them.
replay::Replay replay_of(const games::angry_balls::Game& level, const Throws& throws);

}  // namespace search
