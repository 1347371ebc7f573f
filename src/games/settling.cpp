#include "games/settling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "carom/arithmetic.hpp"

namespace games {

namespace {

// Places are compared this often, so that a ball that comes back does not pass for one at rest.
constexpr std::uint64_t steps_between_looks = 10;
constexpr std::uint64_t fixtures_per_ball = 32;  // that take about as long as a ball

}  // namespace

std::uint64_t work_of_step(const carom::World& world) {
  const carom::BallsView balls = world.balls();
  double divisions = 1;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = balls[i];
    divisions = std::max(divisions, carom::length(ball.velocity) * carom::time_step / ball.radius);
  }
  const auto k = static_cast<std::uint64_t>(
      std::ceil(std::min(divisions, static_cast<double>(carom::max_sub_steps))));
  const std::uint64_t fixtures = world.scene().holes.size() + world.scene().obstacles.size();
  return std::max<std::uint64_t>(world.size(), 1) * k * (1 + fixtures / fixtures_per_ball);
}

Settling look_ahead(carom::World world, std::uint64_t most_work) {
  const carom::ExactArithmetic exact;
  Settling found;
  struct Seen {
    carom::Vec2 from{};
    double distance = 0;
    bool known = false;
    bool there = false;
  };
  std::vector<Seen> seen;  // by id
  const auto look = [&] {
    for (Seen& one : seen) one.there = false;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.in_play(i)) continue;
      const carom::Ball ball = world.ball(i);
      if (ball.id >= seen.size()) seen.resize(ball.id + 1);
      Seen& one = seen[ball.id];
      if (!one.known) one = {.from = ball.position, .known = true};
      one.there = true;
      one.distance = std::max(one.distance, carom::length(ball.position - one.from));
    }
  };
  look();
  for (std::uint64_t steps = 0; steps < settled_steps;) {
    const std::uint64_t work = work_of_step(world);
    const std::uint64_t count =
        steps == 0 ? 1 : std::min(steps_between_looks, settled_steps - steps);
    if (found.work + work * count > most_work) {
      found.complete = false;
      break;
    }
    world.run({}, count);
    found.work += work * count;
    if (steps == 0) {
      const carom::Vec2 free{0, -world.scene().gravity};
      for (std::size_t i = 0; i < world.size() && free.y != 0; ++i) {
        const carom::Ball ball = world.ball(i);
        if (world.in_play(i) && ball.acceleration == free &&
            (!found.falling || ball.id < *found.falling))
          found.falling = ball.id;
      }
    }
    steps += count;
    look();
  }
  found.at_rest = world.at_rest();
  for (std::size_t id = 0; id < seen.size(); ++id) {
    const Seen& one = seen[id];
    if (one.known && (!one.there || one.distance > settled_distance))
      found.restless.push_back(
          {.ball = static_cast<std::uint32_t>(id), .lost = !one.there, .distance = one.distance});
  }
  return found;
}

}  // namespace games
