#include "games/launch.hpp"

#include <cmath>

#include "carom/arithmetic.hpp"

namespace games {

namespace {

// Not inlined: what is computed from a parameter could be moved in front of the guard.
[[gnu::noinline]] carom::Vec2 capped(carom::Vec2 drag) {
  const carom::Vec2 velocity = launch_factor * drag;
  const double speed = carom::length(velocity);
  return speed > max_launch_speed ? velocity * (max_launch_speed / speed) : velocity;
}

}  // namespace

carom::Vec2 on_grid(carom::Vec2 v) {
  return {std::round(v.x / grid) * grid, std::round(v.y / grid) * grid};
}

carom::Vec2 launch_velocity(carom::Vec2 drag) {
  const carom::ExactArithmetic exact;
  const carom::Vec2 velocity = capped(drag);
  return velocity;
}

carom::Vec2 launch_drag(carom::Vec2 velocity) {
  const carom::ExactArithmetic exact;
  return velocity / launch_factor;
}

carom::Status launch(carom::World& world, carom::Vec2 drag) {
  const carom::Vec2 velocity = launch_velocity(drag);
  if (velocity == carom::Vec2{})
    return carom::Error{.pointer = "drag",
                        .problem = carom::MessageCode::gives_no_velocity,
                        .expected = carom::MessageCode::finite_drag};
  return world.set_velocity(0, velocity);
}

}  // namespace games
