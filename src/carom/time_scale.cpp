#include "carom/internal/time_scale.hpp"

#include "carom/world.hpp"

namespace carom {

TimeScale::TimeScale(const Scene& scene) : straight(scene.gravity == 0 && scene.obstacles.empty()) {
  // From here on the clock's steps would be too small beside its time.
  constexpr double least_power = 1.0 / 1024;
  double f = 1;
  double way = 0;
  steps = most_steps;
  for (int m = 0; m <= most_steps + 1; ++m) {
    power[static_cast<std::size_t>(m)] = f;
    time[static_cast<std::size_t>(m)] = straight ? way : m;
    if (m <= steps) horizon = way;
    if (f < least_power && m > 0 && m < steps) steps = m;
    way += time_step * f;
    f *= scene.friction;
  }
}

}  // namespace carom
