#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "games/angry_balls.hpp"
#include "games/billiards.hpp"

namespace app {

/// The last red has fallen.
inline bool decided(const games::billiards::Game& game) { return game.reds_left() == 0; }
/// The last enemy is broken or gone.
inline bool decided(const games::angry_balls::Game& game) { return game.enemies_left() == 0; }

/// A copy of the game that runs ahead of it: it knows a decisive moment before it comes.
///
/// `Game` is games::billiards::Game or games::angry_balls::Game.
template <class Game>
class Foresight {
 public:
  static constexpr std::uint64_t steps = 25;      ///< how far it runs ahead
  static constexpr std::size_t most_balls = 500;  ///< with more, no time is spent on it

  /// The game goes on from here.
  void begin(const Game& game) {
    ahead_.reset();
    if (game.world().size() > most_balls || decided(game)) return;
    ahead_ = game;
    for (std::uint64_t taken = 0, each = 1; taken < steps && each > 0; taken += each)
      each = ahead_->run(steps - taken);
  }
  void end() { ahead_.reset(); }
  /// One step further. Whether the game will be decided within the steps to come.
  bool step() {
    if (!ahead_) return false;
    ahead_->step();
    return decided(*ahead_);
  }

 private:
  std::optional<Game> ahead_;
};

}  // namespace app
