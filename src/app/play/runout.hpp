#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "carom/event.hpp"
#include "carom/vec2.hpp"

namespace app {

/// Finds out, a slice of steps at a time, when the rest of a launch has no event: nothing is faster
/// than `slow`, and until the launch is over nothing meets; under gravity, where balls lie on each
/// other, nothing is worn down or lost. A copy of the game runs ahead.
///
/// `Game` is games::billiards::Game or games::angry_balls::Game.
template <class Game>
class Runout {
 public:
  static constexpr double slow = 80;  ///< px/s
  static constexpr int slice = 60;    ///< steps a call

  /// Forgets all: another launch follows.
  void reset() { *this = {}; }
  /// Call it once a frame while the launch lasts.
  void look(const Game& now) {
    if (quiet_ || now.world().steps() < again_at_ || is_quick(now)) return;
    if (!ahead_) {
      ahead_ = now;
      phase_ = now.phase();
    }
    for (int i = 0; i < slice; ++i) {
      ahead_->step();
      if (std::ranges::any_of(ahead_->physics_events(),
                              [&](const carom::Event& event) { return counts(event); })) {
        again_at_ = ahead_->world().steps();
        ahead_.reset();
        return;
      }
      if (ahead_->phase() != phase_) {
        quiet_ = true;
        ahead_.reset();
        return;
      }
    }
  }
  /// The rest has no event.
  bool quiet() const { return quiet_; }

 private:
  static bool is_quick(const Game& game) {
    for (std::size_t i = 0; i < game.world().size(); ++i)
      if (game.world().in_play(i) && carom::length(game.world().ball(i).velocity) > slow)
        return true;
    return false;
  }
  bool counts(const carom::Event& event) const {
    using enum carom::EventKind;
    const bool lost = event.kind == pocketed || event.kind == destroyed || event.kind == left;
    return lost || event.kind == damage || ahead_->world().scene().gravity == 0;
  }

  std::optional<Game> ahead_;
  decltype(std::declval<Game>().phase()) phase_{};
  std::uint64_t again_at_ = 0;  ///< World::steps() of the event that the last look found
  bool quiet_ = false;
};

}  // namespace app
