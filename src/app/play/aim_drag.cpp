#include "app/play/aim_drag.hpp"

#include <algorithm>
#include <cmath>

#include "games/launch.hpp"

namespace app {
namespace {

constexpr float still = 4;  ///< points; a tap moves less

constexpr double world_degrees = 0.1;  ///< a point
constexpr double fine_degrees = 0.01;  ///< a point, or a tap
constexpr double fine_speed = 1;       ///< px/s a point, or a tap

}  // namespace

void AimDrag::move(Point at, Aim& aim, const Place& place) {
  if (on_ == On::meter) {
    aim.set_speed(games::max_launch_speed *
                  static_cast<double>((at.x - place.meter.x) / std::max(place.meter.w, 1.0f)));
    return;
  }
  const Point way = at - at_;
  if (!moving_) {
    if (length(way) <= still * place.view.density) return;
    moving_ = true;
    across_ = std::abs(way.x) >= std::abs(way.y);
    at_ = at;  // from here on: nothing jumps
    from_ = aim;
    return;
  }
  const auto points = [&](float px) { return static_cast<double>(px / place.view.density); };
  aim = from_;
  if (on_ == On::world) {
    // The line goes along with the pointer.
    const carom::Vec2 moved = place.viewport.seen_as({points(way.x), -points(way.y)});
    const carom::Vec2 along = carom::unit(aim.drag());
    aim.turn(world_degrees * (along.x * moved.y - along.y * moved.x));
  } else if (across_) {
    aim.turn(-fine_degrees * points(way.x));
  } else {
    aim.strengthen(-fine_speed * points(way.y));
  }
}

void AimDrag::release(Point at, Aim& aim, const Place& place) {
  move(at, aim, place);
  if (moving_ || on_ == On::meter) return;
  if (on_ == On::world) {
    const carom::Vec2 way = place.viewport.to_world(at) - place.lead;
    if (way != carom::Vec2{}) aim.point(way);
    return;
  }
  const Point off = at - place.fine.center();
  if (std::abs(off.x) * place.fine.h >= std::abs(off.y) * place.fine.w)
    aim.turn(off.x < 0 ? fine_degrees : -fine_degrees);
  else
    aim.strengthen(off.y < 0 ? fine_speed : -fine_speed);
}

}  // namespace app
