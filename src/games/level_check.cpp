#include "games/level_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "carom/arithmetic.hpp"
#include "carom/world.hpp"
#include "games/launch.hpp"

namespace games::angry_balls {

namespace {

constexpr int settle_steps = 10 * carom::steps_per_second;
constexpr double moved_distance = 1;  // px

// The fan of throws: every 5° around, ten strengths, each watched for up to six seconds.
constexpr int directions = 72;
constexpr int strengths = 10;
constexpr int watched_steps = 6 * carom::steps_per_second;

std::string ball_pointer(std::size_t id) { return "/balls/" + std::to_string(id); }

void warn_of_restless_balls(const carom::Scene& level, carom::Errors& warnings) {
  // Without the projectile, which hangs at the launch place until it is thrown.
  carom::Scene settled = level;
  settled.balls.erase(settled.balls.begin());
  auto created = carom::World::create(settled);
  if (!created) return;
  carom::World& world = created.value();
  for (int step = 0; step < settle_steps; ++step) world.step();
  std::vector<bool> present(settled.balls.size());
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    present[ball.id] = true;
    const double distance = carom::length(ball.position - settled.balls[ball.id].position);
    if (distance > moved_distance)
      warnings.push_back({.pointer = ball_pointer(ball.id + 1),
                          .problem = "moves " + std::to_string(std::lround(distance)) +
                                     " px by itself before anything is thrown",
                          .expected = "a ball at rest: on the floor, on a cap or right above "
                                      "another ball"});
  }
  for (std::size_t id = 0; id < present.size(); ++id)
    if (!present[id])
      warnings.push_back({.pointer = ball_pointer(id + 1),
                          .problem = "is lost by itself before anything is thrown",
                          .expected = "a ball that stays until it is hit"});
}

void warn_of_launch_place(const carom::Scene& level, carom::Errors& warnings) {
  const carom::Ball& projectile = level.balls[0];
  for (std::size_t id = 1; id < level.balls.size(); ++id) {
    const carom::Ball& ball = level.balls[id];
    if (carom::length(ball.position - projectile.position) < ball.radius + projectile.radius)
      warnings.push_back({.pointer = ball_pointer(id),
                          .problem = "lies on the launch place",
                          .expected = "a place clear of the projectile"});
  }
  if (projectile.solidity != carom::infinite_solidity)
    warnings.push_back({.pointer = "/balls/0/solidity",
                        .problem = "has no effect",
                        .expected = "no solidity: a projectile's is infinite"});
}

// The directions of the fan. cos and sin are no part of the rules' arithmetic (their bits may
// differ between machines), so a rotation is repeated instead.
std::array<carom::Vec2, directions> fan() {
  constexpr double cos_5_degrees = 0.99619469809174555;
  constexpr double sin_5_degrees = 0.08715574274765817;
  std::array<carom::Vec2, directions> made;
  carom::Vec2 u{1, 0};
  for (carom::Vec2& direction : made) {
    direction = u;
    u = {u.x * cos_5_degrees - u.y * sin_5_degrees, u.x * sin_5_degrees + u.y * cos_5_degrees};
  }
  return made;
}

void warn_of_unreachable_enemies(const carom::Scene& level, carom::Errors& warnings) {
  std::vector<bool> reached(level.balls.size());
  std::size_t waiting = 0;
  for (const carom::Ball& ball : level.balls) waiting += ball.role == carom::Role::enemy;

  const auto created = carom::World::create(level);
  if (!created) return;
  const auto reach = [&](std::uint32_t id) {
    if (reached[id] || level.balls[id].role != carom::Role::enemy) return;
    reached[id] = true;
    --waiting;
  };
  for (const carom::Vec2 direction : fan()) {
    for (int strength = strengths; strength >= 1; --strength) {
      carom::World world = created.value();
      const double drag = max_launch_speed / launch_factor * strength / strengths;
      if (!launch(world, direction * drag)) continue;
      for (int step = 0; step < watched_steps && waiting > 0; ++step) {
        for (const carom::Event& event : world.step()) {
          // An indestructible enemy must be driven out; of any other a wound is enough, because
          // there are more throws.
          const bool lost = event.kind == carom::EventKind::left ||
                            event.kind == carom::EventKind::pocketed ||
                            event.kind == carom::EventKind::destroyed;
          if (lost || event.kind == carom::EventKind::damage) reach(event.ball);
        }
      }
      if (waiting == 0) return;
    }
  }
  for (std::size_t id = 0; id < level.balls.size(); ++id)
    if (level.balls[id].role == carom::Role::enemy && !reached[id])
      warnings.push_back({.pointer = ball_pointer(id),
                          .problem = "could not be hurt, pocketed or driven out by any of " +
                                     std::to_string(directions * strengths) + " throws tried",
                          .expected = "an enemy within reach"});
}

}  // namespace

carom::Errors level_warnings(const carom::Scene& level) {
  const carom::ExactArithmetic exact;
  carom::Errors warnings;
  warn_of_launch_place(level, warnings);
  warn_of_restless_balls(level, warnings);
  warn_of_unreachable_enemies(level, warnings);
  return warnings;
}

}  // namespace games::angry_balls
