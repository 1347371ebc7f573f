#include "app/aim.hpp"

#include "app/grid.hpp"
#include "carom/world.hpp"
#include "games/launch.hpp"

namespace app {

void Aim::begin(carom::Vec2 at) { from_ = to_ = at; }

void Aim::move(carom::Vec2 to) { to_ = to; }

void Aim::cancel() { from_.reset(); }

carom::Vec2 Aim::drag() const { return from_ ? on_grid(to_ - *from_) : carom::Vec2{}; }

carom::Vec2 Aim::velocity() const { return games::launch_velocity(drag()); }

double Aim::strength() const { return speed() / games::max_launch_speed; }

bool Aim::capped() const {
  return games::launch_factor * carom::length(drag()) > games::max_launch_speed;
}

bool Aim::too_weak() const { return speed() < carom::rest_speed; }

}  // namespace app
