#include "app/view/interpolator.hpp"

#include <algorithm>

namespace app {

void Interpolator::record(const carom::World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    if (ball.id >= past_.size()) past_.resize(ball.id + 1);
    auto& [places, known] = past_[ball.id];
    std::shift_right(places.begin(), places.end(), 1);
    places[0] = ball.position;
    known = std::min(known + 1, remembered);
  }
}

void Interpolator::restart(const carom::World& world) {
  past_.clear();
  record(world);
}

std::span<const carom::Vec2> Interpolator::past(std::uint32_t id) const {
  if (id >= past_.size()) return {};
  return std::span(past_[id].places).first(past_[id].known);
}

carom::Vec2 Interpolator::position(const carom::World& world, std::size_t index,
                                   double fraction) const {
  const carom::Ball ball = world.ball(index);
  const auto before = past(ball.id);
  if (before.empty()) return ball.position;
  return before[0] + fraction * (ball.position - before[0]);
}

}  // namespace app
