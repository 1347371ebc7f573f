#pragma once

#include <cstdint>
#include <optional>

#include "app/base/time.hpp"
#include "games/billiards.hpp"
#include "replay/replay.hpp"
#include "search/opponent.hpp"

namespace app {

/// Simulations that a frame of so long can play in some milliseconds. It decides how soon a search
/// has an answer, and not which: slices do not change it.
std::uint64_t simulations_of_frame(const carom::World& world, nanoseconds elapsed);

/// A turn of a computer player: it thinks, a slice a frame, then aims for all to see, and then its
/// decision is to be played. The same game and occasion lead to the same decision, also when the
/// game is taken up again.
class ComputerTurn {
 public:
  static constexpr nanoseconds least_thought = milliseconds{400};  ///< so that it is seen
  static constexpr nanoseconds aim_time = milliseconds{600};

  /// Of the player who is on. None if a person plays for that one, or if the cue ball in hand has
  /// no place to go.
  static std::optional<ComputerTurn> begin(const games::billiards::Game& game,
                                           const replay::Occasion& occasion);

  void advance(nanoseconds elapsed, carom::Rollouts& rollouts);
  bool thinking() const { return !decision_; }
  /// Once it does not think any more.
  const search::Decision& decision() const { return *decision_; }
  /// It has aimed: the decision is to be played.
  bool ready() const { return decision_ && aimed_ >= aim_time; }
  /// The table, the cue ball in hand put down where it goes as soon as that is decided.
  const carom::World& world() const { return game_.world(); }

  struct Cue {
    carom::Vec2 way;  ///< where it points, a unit vector
    double back = 0;  ///< px, from the ball to its tip
  };
  /// The cue to be seen; none while the cue ball is in hand.
  std::optional<Cue> cue() const;

 private:
  ComputerTurn(games::billiards::Game game, search::Opponent opponent)
      : game_(std::move(game)), opponent_(std::move(opponent)) {}

  games::billiards::Game game_;
  search::Opponent opponent_;
  std::optional<search::Decision> decision_;
  nanoseconds thought_{};
  nanoseconds aimed_{};
};

}  // namespace app
