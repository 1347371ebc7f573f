#pragma once

#include <cstdint>

#include "carom/public.hpp"
#include "carom/result.hpp"
#include "carom/vec2.hpp"
#include "carom/world.hpp"

namespace CAROM_PUBLIC games {

/// The outcome of a launch.
struct Outcome {
  /// As a game gives them: on a table for balls pocketed, in a level for all that are lost.
  std::int64_t points = 0;
  std::uint32_t balls_out = 0;  ///< pocketed, destroyed or gone by an open side, without the lead
  bool foul = false;            ///< the cue ball went out of play
  bool touched = false;         ///< the lead collided with another ball
  std::uint64_t steps = 0;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Gives the lead `velocity` (px/s) and plays to the end that the rules know: on a table (the lead
/// is a cue ball) until rest, until the cue ball or all others are out of play, or for
/// billiards::max_turn_steps; in a level until the next throw would be offered or the last enemy is
/// lost. As in a game, at least one step is taken. What the world is left as is the end's state,
/// before anything is stopped. Refuses, changing nothing, a world without lead in play and what
/// World::set_velocity refuses.
carom::Result<Outcome> play_out(carom::World& world, carom::Vec2 velocity);

}  // namespace games
