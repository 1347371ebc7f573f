#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "carom/result.hpp"
#include "carom/rollouts.hpp"
#include "search/search.hpp"

namespace search {

/// A turn as it was played.
struct PlayedTurn {
  std::optional<carom::Vec2> place{};  ///< px, of the cue ball in hand
  carom::Vec2 drag{};                  ///< px
};

/// A turn looked at afterwards. Values are points on a table, enemies out in a level, in the hand
/// of the question.
struct TurnReview {
  Shot best{};            ///< found by the search
  Estimate best_value;    ///< of fresh simulations
  Estimate played_value;  ///< of as many
  std::int64_t made = 0;  ///< what the turn came to

  /// The cost of the choice of the shot: the best value found less that of the shot played; 0 if
  /// that was none worse.
  double decision() const;
  /// The outcome less its expectation.
  double luck() const;
};

/// The review of a turn under way, in slices.
class Reviewing {
 public:
  /// `before`: the game as the player found it. Refuses what Search::create refuses, a turn that
  /// the game would not take, and a budget without fresh simulations.
  static carom::Result<Reviewing> create(Game before, const PlayedTurn& turn,
                                         const Question& question);

  /// Plays at most so many simulations.
  void advance(std::uint64_t simulations, carom::Rollouts& rollouts);
  bool done() const { return search_.done() && played_.n == due_; }
  /// Once done().
  TurnReview review() const;

 private:
  Reviewing(Search search, const PlayedTurn& turn, const Question& question, Trial made);
  Estimate value(const Record& record) const;

  Search search_;
  PlayedTurn turn_;
  Question question_;
  Trial made_;
  std::uint64_t due_ = 1;  ///< simulations of the shot played
  Record played_;
  std::vector<Trial> trials_;
};

}  // namespace search
