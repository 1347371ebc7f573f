#include "search/aim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom/arithmetic.hpp"
#include "games/launch.hpp"

namespace search {

namespace {

constexpr double radians = std::numbers::pi / 180;  ///< a degree

// Taylor series at most 45° from zero, where the first term left out is below 2⁻⁵⁸.
double sine(double x) {
  double sum = 0;
  for (int n = 17; n >= 3; n -= 2) sum = (1 - sum) * (x * x) / (n * (n - 1));
  return x * (1 - sum);
}
double cosine(double x) {
  double sum = 0;
  for (int n = 18; n >= 2; n -= 2) sum = (1 - sum) * (x * x) / (n * (n - 1));
  return 1 - sum;
}

// Not inlined: what is computed from a parameter could be moved in front of the guard.
[[gnu::noinline]] carom::Vec2 direction_of(double degrees) {
  const double quarters = std::round(degrees / 90);
  const double rest = (degrees - 90 * quarters) * radians;
  const carom::Vec2 way{cosine(rest), sine(rest)};
  switch (static_cast<long>(quarters) & 3) {
    case 0:
      return way;
    case 1:
      return {-way.y, way.x};
    case 2:
      return {-way.x, -way.y};
    default:
      return {way.y, -way.x};
  }
}

}  // namespace

carom::Vec2 direction(double degrees) {
  const carom::ExactArithmetic exact;
  const carom::Vec2 way = direction_of(degrees);
  return way;
}

carom::Vec2 drag(const Aim& aim) {
  const carom::ExactArithmetic exact;
  return games::on_grid(aim.speed / games::launch_factor * direction(aim.tenths / 10.0));
}

Aim nearest_aim(carom::Vec2 velocity) {
  const carom::ExactArithmetic exact;
  // Within the upper half, the last direction that is not beyond the velocity.
  const bool below = velocity.y < 0;
  const carom::Vec2 upper{velocity.x, std::abs(velocity.y)};
  int tenths = 0;
  for (int beyond = 1801; beyond - tenths > 1;) {
    const int middle = (tenths + beyond) / 2;
    (cross(direction(middle / 10.0), upper) >= 0 ? tenths : beyond) = middle;
  }
  if (tenths < 1800 &&
      dot(direction((tenths + 1) / 10.0), upper) > dot(direction(tenths / 10.0), upper))
    ++tenths;
  const double speed = std::min<double>(carom::length(velocity), greatest_speed);
  return {.tenths = below && tenths < 1800 ? -tenths : tenths,
          .speed = std::max(least_speed, static_cast<int>(std::lround(speed)))};
}

}  // namespace search
