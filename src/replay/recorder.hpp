#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

#include "carom/result.hpp"
#include "replay/any_game.hpp"
#include "replay/replay.hpp"

namespace replay {

/// A game that remembers how it was played: commands and steps go through it. A plain value: a copy
/// keeps both the state and the way to it, which is all that taking back a turn needs.
///
/// `Game` is games::billiards::Game or games::angry_balls::Game.
template <class Game>
class Recorder {
 public:
  using GameCommand = std::conditional_t<std::is_same_v<Game, games::billiards::Game>,
                                         games::billiards::Command, games::angry_balls::Command>;

  /// `game`: at its start, nothing done yet.
  explicit Recorder(Game game) : game_(std::move(game)) {
    if constexpr (std::is_same_v<Game, games::angry_balls::Game>)
      replay_.level = game_.level();
    else
      replay_.options = game_.options();
  }

  /// The same, of a game that is played for something.
  Recorder(Game game, Occasion occasion) : Recorder(std::move(game)) {
    replay_.occasion = occasion;
  }

  /// Goes on with a game that was kept: `so_far`, with full hashes, is how it was played.
  Recorder(Game game, Replay so_far) : game_(std::move(game)), replay_(std::move(so_far)) {}

  /// Game::apply(). Restart begins a new replay.
  carom::Status apply(const GameCommand& given) {
    const std::uint64_t hash = game_.world().state_hash();
    carom::Status applied = game_.apply(given);
    if (!applied) return applied;
    if (!replay_.moves.empty()) replay_.moves.back().hash = hash;
    std::visit(
        [this](const auto& command) {
          if constexpr (std::is_constructible_v<Command, decltype(command)>)
            replay_.moves.push_back({.command = command});
          else
            replay_.moves.clear();  // Restart
        },
        given);
    return applied;
  }

  /// Game::step().
  void step() {
    if (moves(game_)) ++replay_.moves.back().steps;
    game_.step();
  }

  const Game& game() const { return game_; }
  const Occasion& occasion() const { return replay_.occasion; }

  /// Is true if one step more leaves the replay within max_move_steps and max_steps.
  bool has_room() const {
    if (replay_.moves.empty()) return true;
    std::uint64_t steps = 0;
    for (const Move& move : replay_.moves) steps += move.steps;
    return replay_.moves.back().steps < max_move_steps && steps < max_steps;
  }

  /// The game as it was played up to now. It can be written and read back unless check() finds that
  /// it has grown beyond the limits.
  Replay replay() const {
    Replay taken = replay_;
    if (!taken.moves.empty()) taken.moves.back().hash = game_.world().state_hash();
    taken.score = score(game_);
    return taken;
  }

 private:
  Game game_;
  Replay replay_;  // the last move's hash, and the score, are as of the last command
};

}  // namespace replay
