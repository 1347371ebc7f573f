#include "carom/world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/scene_check.hpp"

namespace carom {

namespace {

bool finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

Error no_such_ball() {
  return {.pointer = "index", .problem = "is no ball in play", .expected = "a ball in play"};
}

}  // namespace

World::World(Scene scene) : scene_(std::move(scene)), balls_(std::move(scene_.balls)) {
  scene_.balls.clear();
  std::uint32_t id = 0;
  for (Ball& ball : balls_) {
    ball.id = id++;
    ball.acceleration = {};
    if (ball.role == Role::projectile) ball.solidity = infinite_solidity;
  }
}

Result<World> World::create(Scene scene) {
  Errors errors = check(scene);
  if (!errors.empty()) return errors;
  return World(std::move(scene));
}

bool World::at_rest() const {
  for (std::size_t i = 0; i < size(); ++i) {
    if (!in_play(i)) continue;
    if (length(ball(i).velocity) >= rest_speed) return false;
    if (scene_.hole_pull == 0) continue;
    for (const Hole& hole : scene_.holes) {
      const double distance = length(hole.position - ball(i).position);
      if (distance > 0 && distance < hole.radius) return false;
    }
  }
  return true;
}

Status World::set_velocity(std::size_t index, Vec2 velocity) {
  if (index >= size() || !in_play(index)) return no_such_ball();
  if (!finite(velocity) || length(velocity) > max_speed)
    return Error{.pointer = "velocity",
                 .problem = "is not finite or too fast",
                 .expected = "at most 100000 (px/s)"};
  balls_[index].velocity = velocity;
  return Done{};
}

Status World::place_lead(Vec2 position) {
  if (!has_lead())
    return Error{.pointer = "position",
                 .problem = "has nothing to place",
                 .expected = "a world with a cue ball or projectile"};
  if (!finite(position) || std::max(std::abs(position.x), std::abs(position.y)) > max_quantity)
    return Error{.pointer = "position",
                 .problem = "is not finite or too far away",
                 .expected = "coordinates from -1000000000 to 1000000000 (px)"};
  Ball& lead = balls_[0];
  if (auto error = obstruction_error(scene_, position, lead.radius, "position")) return *error;
  lead.position = position;
  lead.velocity = {};
  lead.acceleration = {};
  lead_out_ = false;
  return Done{};
}

void World::stop() {
  for (Ball& ball : balls_) ball.velocity = {};
}

}  // namespace carom
