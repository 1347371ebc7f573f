#include "app/motion.hpp"

namespace app {

void Motion::record(const carom::World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    if (ball.id >= before_.size()) before_.resize(ball.id + 1);
    before_[ball.id] = ball.position;
  }
}

carom::Vec2 Motion::position(const carom::World& world, std::size_t index, double fraction) const {
  const carom::Ball ball = world.ball(index);
  if (ball.id >= before_.size()) return ball.position;
  return before_[ball.id] + fraction * (ball.position - before_[ball.id]);
}

}  // namespace app
