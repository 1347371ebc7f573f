#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/base/time.hpp"
#include "replay/player.hpp"
#include "search/review.hpp"

namespace app {

/// A game of billiards looked at shot by shot, a slice a frame: what each choice gave away, and
/// what was luck.
class GameReview {
 public:
  struct Shot {
    int player = 0;
    search::TurnReview review;
  };

  /// `replay`: of billiards. `error`: of a person's hand, px; computers have their own. None if it
  /// is no sound replay.
  static std::optional<GameReview> begin(replay::Replay replay, double error);

  /// `steps`: of the game that may be played in one go, to find the next shot.
  void advance(nanoseconds elapsed, std::uint64_t steps, carom::Rollouts& rollouts);
  bool done() const { return shots_.size() == player_.turns().size() || stuck_; }
  /// Those that are done, in their order.
  const std::vector<Shot>& shots() const { return shots_; }
  std::size_t all() const { return player_.turns().size(); }
  const replay::Player& player() const { return player_; }

  /// Numbers of the shots whose choice gave most away, the costliest first; at most so many, and
  /// none that gave nothing away.
  std::vector<std::size_t> costliest(std::size_t most) const;

 private:
  GameReview(replay::Player player, double error) : player_(std::move(player)), error_(error) {}
  void begin_shot();

  replay::Player player_;
  double error_;
  bool stuck_ = false;  ///< the replay diverges
  std::optional<search::Reviewing> reviewing_;
  std::vector<Shot> shots_;
};

}  // namespace app
