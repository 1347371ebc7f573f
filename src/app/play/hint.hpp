#pragma once

#include <cstdint>
#include <optional>

#include "app/base/time.hpp"
#include "app/play/aim.hpp"
#include "search/search.hpp"

namespace app {

/// A good shot for the player's hand, found a slice a frame and told in three steps. The same game
/// and hand have the same hint.
class Hint {
 public:
  enum class Step : std::uint8_t { ball, way, aim };

  /// `error`: of the player's hand, px; 0: exact. None if there is nothing to be shot now.
  static std::optional<Hint> begin(search::Game game, double error);

  void advance(nanoseconds elapsed, carom::Rollouts& rollouts);
  bool searching() const { return !search_.done(); }
  /// One step more, once the shot is known.
  void more();
  /// The shot is known, and told as far as that.
  bool tells(Step step) const { return !searching() && step_ >= step; }

  // Once it is known.
  /// What it is worth, from simulations that did not choose it.
  const search::Ranked& shot() const { return *shot_; }
  Aim aim() const;
  /// The ball that it meets first; none if it meets none.
  const std::optional<std::uint32_t>& ball() const { return ball_; }
  double error() const { return error_; }

 private:
  Hint(search::Search search, double error) : search_(std::move(search)), error_(error) {}

  search::Search search_;
  double error_;
  Step step_ = Step::ball;
  std::optional<search::Ranked> shot_;
  std::optional<std::uint32_t> ball_;
};

}  // namespace app
