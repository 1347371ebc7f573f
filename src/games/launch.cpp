#include "games/launch.hpp"

namespace games {

carom::Vec2 launch_velocity(carom::Vec2 drag) {
  const carom::Vec2 velocity = launch_factor * drag;
  const double speed = carom::length(velocity);
  return speed > max_launch_speed ? velocity * (max_launch_speed / speed) : velocity;
}

carom::Status launch(carom::World& world, carom::Vec2 drag) {
  const carom::Vec2 velocity = launch_velocity(drag);
  if (velocity == carom::Vec2{})
    return carom::Error{.pointer = "drag",
                        .problem = "gives no velocity",
                        .expected = "a finite vector that is not zero"};
  return world.set_velocity(0, velocity);
}

}  // namespace games
