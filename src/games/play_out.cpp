#include "games/play_out.hpp"

#include <algorithm>
#include <span>

#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "games/launch.hpp"

namespace games {

namespace {

using carom::EventKind;

std::ptrdiff_t enemies(const carom::World& world) {
  return std::ranges::count(world.balls().role, carom::Role::enemy);
}

}  // namespace

carom::Result<Outcome> play_out(carom::World& world, carom::Vec2 velocity) {
  if (!world.has_lead())
    return carom::Error{.problem = carom::MessageCode::has_nothing_to_launch,
                        .expected = carom::MessageCode::lead_as_first_ball};
  if (const carom::Status launched = world.set_velocity(0, velocity); !launched)
    return launched.errors();

  const bool table = world.balls().role[0] == carom::Role::cue;
  const bool to_win = enemies(world) > 0;
  const std::uint64_t limit = table ? billiards::max_turn_steps : angry_balls::offer_steps;
  const auto lost = EventKind::pocketed | EventKind::destroyed | EventKind::left;
  Outcome outcome;
  int scored = 0;
  const auto count = [&](std::uint64_t, std::span<const carom::Event> events) {
    for (const carom::Event& event : events) {
      if (event.kind == EventKind::pair && (event.ball == 0 || event.other == 0))
        outcome.touched = true;
      if (event.ball == 0 || !lost.has(event.kind)) continue;
      ++outcome.balls_out;
      if (!table || event.kind == EventKind::pocketed) outcome.points += points_for(++scored);
    }
  };
  // A world that is slow already takes one step before it is asked whether it rests.
  bool rest_counts = !world.at_rest();
  for (;;) {
    const std::uint64_t left = rest_counts ? limit - outcome.steps : 1;
    const carom::RunEnd end = world.run({.rest = rest_counts, .events = lost}, left, count);
    outcome.steps += end.steps;
    outcome.foul = table && !world.in_play(0);
    const bool nothing_left = table ? world.size() == 1 : to_win && enemies(world) == 0;
    if (outcome.foul || nothing_left) break;
    if (end.why != carom::RunEnd::Why::event && rest_counts) break;
    rest_counts = true;
  }
  return outcome;
}

}  // namespace games
