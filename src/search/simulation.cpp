#include "search/simulation.hpp"

#include <algorithm>

#include "games/launch.hpp"
#include "games/play_out.hpp"

namespace search {

Trial simulate(carom::World& world, const std::optional<carom::Vec2>& place, carom::Vec2 drag) {
  const auto enemies = [&world] {
    return static_cast<std::uint32_t>(std::ranges::count(world.balls().role, carom::Role::enemy));
  };
  const std::uint32_t enemies_before = enemies();
  if (place && !world.place_lead(*place)) return {};
  const auto played = games::play_out(world, games::launch_velocity(drag));
  if (!played) return {};
  const games::Outcome& outcome = played.value();
  const bool table = world.balls().role[0] == carom::Role::cue;
  const std::uint32_t enemies_left = enemies();
  return {.points = outcome.points,
          .enemies_out = enemies_before - enemies_left,
          .cleared = table ? world.size() == 1 : enemies_left == 0,
          .foul = outcome.foul,
          .touched = outcome.touched};
}

void Record::add(const Trial& trial) {
  ++n;
  points += trial.points;
  points_squared += trial.points * trial.points;
  enemies_out += trial.enemies_out;
  enemies_out_squared += std::int64_t{trial.enemies_out} * trial.enemies_out;
  scored += trial.points > 0 ? 1 : 0;
  cleared += trial.cleared ? 1 : 0;
  fouls += trial.foul ? 1 : 0;
  touched += trial.touched ? 1 : 0;
}

}  // namespace search
