#include "app/play/aim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom/world.hpp"
#include "games/launch.hpp"
#include "search/aim.hpp"

namespace app {
namespace {

constexpr double radians = std::numbers::pi / 180;  ///< a degree

}  // namespace

void Aim::turn(double degrees) {
  if (!exact_) return;
  const carom::Vec2 way = search::direction(degrees);
  exact_ =
      carom::Vec2{exact_->x * way.x - exact_->y * way.y, exact_->x * way.y + exact_->y * way.x};
}

void Aim::point(carom::Vec2 way) {
  if (exact_) exact_ = carom::length(*exact_) * carom::unit(way);
}

void Aim::set_degrees(double degrees) { point(search::direction(degrees)); }

void Aim::set_speed(double speed) {
  if (!exact_) return;
  const double wanted = std::clamp(speed, least_aim_speed, games::max_launch_speed);
  exact_ = (wanted / games::launch_factor) * carom::unit(*exact_);
}

void Aim::strengthen(double by) {
  if (!exact_) return;
  // A drag beyond the greatest speed counts as one of that speed.
  set_speed(std::min(games::launch_factor * carom::length(*exact_), games::max_launch_speed) + by);
}

carom::Vec2 Aim::drag() const { return exact_ ? games::on_grid(*exact_) : carom::Vec2{}; }

carom::Vec2 Aim::velocity() const { return games::launch_velocity(drag()); }

double Aim::degrees() const {
  const carom::Vec2 way = drag();
  return std::atan2(way.y, way.x) / radians;
}

double Aim::strength() const { return speed() / games::max_launch_speed; }

bool Aim::capped() const {
  return games::launch_factor * carom::length(drag()) > games::max_launch_speed;
}

bool Aim::too_weak() const { return speed() < carom::rest_speed; }

}  // namespace app
