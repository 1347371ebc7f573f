#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "carom/result.hpp"
#include "carom/rollouts.hpp"
#include "carom/vec2.hpp"
#include "search/hand.hpp"
#include "search/search.hpp"
#include "search/seed.hpp"

namespace search {

/// A level of the computer, by facts: its hand and the number of shots it looks at.
struct Level {
  std::string_view name;  ///< "casual"; the interface has words and a face for it
  Hand hand;
  std::uint64_t simulations;
};

/// A new number whenever a search or a level decides otherwise than before: games of other versions
/// cannot be played again from their seeds. Replays can, since they hold the shots themselves.
inline constexpr int version = 1;

/// From the weakest to the strongest (docs/strength.md).
inline constexpr std::array<Level, 10> levels{{
    {"casual", {28}, 3},
    {"regular", {28}, 12},
    {"keen", {18}, 40},
    {"club", {8}, 100},
    {"league", {3}, 250},
    {"expert", {1}, 500},
    {"pro", {0}, 7},
    {"master", {0}, 11},
    {"champion", {0}, 15},
    {"machine", {0}, 22},
}};

/// The seed of one of the players, 0 or 1, of a game with this seed: two computers do not share
/// their luck.
Seed player_seed(Seed game, int player);

/// The computer's decision in a turn.
struct Decision {
  Shot meant{};        ///< the place for the cue ball in hand is taken as it is
  carom::Vec2 drag{};  ///< px, what its hand makes of the aim: for Shoot or Throw
};

/// The computer as it decides on one turn, of billiards or a level. The same game, level and seed
/// give the same decision, on every machine, also when a game is taken up again.
class Opponent {
 public:
  /// `turn`: how many turns were played before, by all; with it one seed serves a whole game.
  /// Refuses what Search::create refuses.
  static carom::Result<Opponent> create(Game game, const Level& level, Seed seed,
                                        std::uint64_t turn);

  /// Plays at most so many simulations.
  void advance(std::uint64_t simulations, carom::Rollouts& rollouts) {
    search_.advance(simulations, rollouts);
  }
  bool done() const { return search_.done(); }
  /// From 0 to 1.
  double progress() const;
  std::uint64_t simulated() const { return search_.simulated(); }
  /// Once done().
  Decision decision() const;

 private:
  Opponent(Search search, const Level& level, Seed seed)
      : search_(std::move(search)), level_(level), seed_(seed) {}

  Search search_;
  Level level_;
  Seed seed_;  ///< of the turn
};

}  // namespace search
