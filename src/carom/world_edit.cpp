#include <limits>
#include <utility>

#include "carom/arithmetic.hpp"
#include "carom/internal/fixed_parts.hpp"
#include "carom/internal/workspace.hpp"
#include "carom/world.hpp"

namespace carom {

namespace {

// All that is wrong with a ball in a world, as with the only one of its scene.
Errors ball_errors(const Scene& fixed, const Ball& ball) {
  Scene scene = fixed;
  scene.balls = {ball};
  Errors errors = check(scene);
  constexpr std::string_view pointer = "/balls/0";
  for (Error& error : errors)
    if (error.pointer.starts_with(pointer)) error.pointer.replace(0, pointer.size(), "ball");
  return errors;
}

Error lead_error(const char* problem) {
  return {.pointer = "ball/role",
          .problem = {MessageCode::text, {problem}},
          .expected = MessageCode::one_lead_first};
}

}  // namespace

void World::balls_changed() {
  changed();
  if (owner_.workspace) owner_.workspace->forget_balls();
}

Result<std::uint32_t> World::add(Ball ball) {
  const ExactArithmetic exact;
  if (Errors errors = ball_errors(fixed_->scene, ball); !errors.empty()) return errors;
  if (is_lead(ball.role) && size() > 0) return lead_error("is a lead's");
  if (size() >= max_balls || next_id_ == std::numeric_limits<std::uint32_t>::max())
    return Error{.pointer = "ball",
                 .problem = {MessageCode::text, {"is one too many"}},
                 .expected = {MessageCode::at_most, {std::to_string(max_balls)}}};
  if (ball.role == Role::projectile) ball.solidity = infinite_solidity;
  ball.id = next_id_++;
  ball.acceleration = {};
  balls_.push_back(ball);
  balls_changed();
  return ball.id;
}

Status World::remove(std::size_t index) {
  if (index >= size() || !in_play(index)) return no_such_ball();
  if (index == 0 && has_lead())
    lead_out_ = true;
  else
    balls_.swap_out(index);
  balls_changed();
  return Done{};
}

Status World::set_ball(std::size_t index, Ball ball) {
  const ExactArithmetic exact;
  if (index >= size() || !in_play(index)) return no_such_ball();
  if (Errors errors = ball_errors(fixed_->scene, ball); !errors.empty()) return errors;
  if (is_lead(ball.role) && index != 0) return lead_error("is a lead's");
  if (ball.role == Role::projectile) ball.solidity = infinite_solidity;
  balls_.set_position(index, ball.position);
  balls_.set_velocity(index, ball.velocity);
  balls_.radius[index] = ball.radius;
  balls_.solidity[index] = ball.solidity;
  balls_.role[index] = ball.role;
  balls_changed();
  return Done{};
}

}  // namespace carom
