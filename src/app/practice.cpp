#include "app/practice.hpp"

#include "carom/world.hpp"
#include "games/launch.hpp"

namespace app {
namespace {

// Written out, so that the same change gives the same bits everywhere.
constexpr double cos_tenth_degree = 0.99999847691328769;
constexpr double sin_tenth_degree = 0.0017453283658983088;

}  // namespace

carom::Vec2 changed(carom::Vec2 drag, Change change) {
  if (change == Change::left || change == Change::right) {
    const double s = change == Change::left ? sin_tenth_degree : -sin_tenth_degree;
    return {drag.x * cos_tenth_degree - drag.y * s, drag.x * s + drag.y * cos_tenth_degree};
  }
  // A drag beyond the greatest speed counts as one of that speed.
  const double speed = carom::length(games::launch_velocity(drag));
  const double wanted = speed + (change == Change::faster ? 1 : -1);
  if (!(wanted >= carom::rest_speed && wanted <= games::max_launch_speed)) return drag;
  return drag * (wanted / (games::launch_factor * carom::length(drag)));
}

}  // namespace app
