#include "carom/world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/arithmetic.hpp"
#include "carom/internal/fixed_parts.hpp"
#include "carom/internal/scene_check.hpp"
#include "carom/internal/workspace.hpp"

namespace carom {

namespace {

bool finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace

Error World::no_such_ball() {
  return {.pointer = "index",
          .problem = MessageCode::is_no_ball,
          .expected = MessageCode::ball_in_play};
}

World::World(Scene scene) {
  balls_.reserve(scene.balls.size());
  for (Ball ball : scene.balls) {
    ball.id = static_cast<std::uint32_t>(size());
    ball.acceleration = {};
    if (ball.role == Role::projectile) ball.solidity = infinite_solidity;
    balls_.push_back(ball);
  }
  next_id_ = static_cast<std::uint32_t>(size());
  scene.balls = {};
  const double whole = size() > 0 ? balls_.solidity[0] : infinite_solidity;
  fixed_ = std::make_shared<const FixedParts>(std::move(scene), whole);
}

// The data of many balls may be large, and holds only for them.
World::WorkspaceOwner& World::WorkspaceOwner::operator=(const WorkspaceOwner& other) {
  if (this == &other || !workspace) return *this;
  if (workspace->gone.size() > Forecast::max_balls) {
    workspace.reset();
    return *this;
  }
  workspace->forecast.forget();
  workspace->places.forget();
  workspace->packed = {};  // it knows the radii of the balls it was built for
  return *this;
}

Workspace& World::workspace() {
  if (!owner_.workspace) owner_.workspace = std::make_shared<Workspace>();
  return *owner_.workspace;
}

void World::changed() {
  if (!owner_.workspace) return;
  owner_.workspace->forecast.forget();
  owner_.workspace->places.forget();
}

const Scene& World::scene() const { return fixed_->scene; }

Result<World> World::create(Scene scene) {
  const ExactArithmetic exact;
  Errors errors = check(scene);
  if (!errors.empty()) return errors;
  return World(std::move(scene));
}

bool World::at_rest() const {
  if (owner_.workspace && owner_.workspace->forecast.surely_busy()) return false;
  const ExactArithmetic exact;
  // Squares far from the limit's need no root to be told from it.
  constexpr double surely_fast = rest_speed * rest_speed * 1.001;
  constexpr double surely_slow = rest_speed * rest_speed * 0.999;
  for (std::size_t i = lead_out_ ? 1 : 0; i < size(); ++i) {
    const double squared = length_squared(balls_.velocity(i));
    if (squared >= surely_fast) return false;
    if (!(squared <= surely_slow) && length(balls_.velocity(i)) >= rest_speed) return false;
  }
  const Scene& scene = fixed_->scene;
  if (scene.hole_pull == 0) return true;
  for (std::size_t i = lead_out_ ? 1 : 0; i < size(); ++i)
    for (const Hole& hole : scene.holes) {
      const double distance = length(hole.position - balls_.position(i));
      if (distance > 0 && distance < hole.radius) return false;
    }
  return true;
}

Status World::set_velocity(std::size_t index, Vec2 velocity) {
  const ExactArithmetic exact;
  if (index >= size() || !in_play(index)) return no_such_ball();
  if (!finite(velocity) || length(velocity) > max_speed)
    return Error{.pointer = "velocity",
                 .problem = MessageCode::is_too_fast,
                 .expected = {MessageCode::at_most_speed, {"100000"}}};
  balls_.set_velocity(index, velocity);
  changed();
  return Done{};
}

Status World::place_lead(Vec2 position) {
  const ExactArithmetic exact;
  if (!has_lead())
    return Error{.pointer = "position",
                 .problem = MessageCode::has_no_lead,
                 .expected = MessageCode::world_with_lead};
  if (!finite(position) || std::max(std::abs(position.x), std::abs(position.y)) > max_quantity)
    return Error{.pointer = "position",
                 .problem = MessageCode::is_too_far,
                 .expected = {MessageCode::coordinates_from_to, {"-1000000000", "1000000000"}}};
  if (auto error = obstruction_error(fixed_->scene, position, balls_.radius[0], "position"))
    return *error;
  balls_.set_position(0, position);
  balls_.set_velocity(0, {});
  balls_.set_acceleration(0, {});
  if (balls_.solidity[0] < 0) balls_.solidity[0] = fixed_->lead_solidity;
  lead_out_ = false;
  changed();
  return Done{};
}

void World::stop() {
  for (std::size_t i = 0; i < size(); ++i) balls_.set_velocity(i, {});
  changed();
}

}  // namespace carom
