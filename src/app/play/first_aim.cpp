#include "app/play/first_aim.hpp"

#include <algorithm>
#include <limits>

namespace app {
namespace {

using carom::Vec2;

constexpr double first_drag = 100;  ///< px: 500 px/s

/// The distance of `point` from the straight way between two others, px.
double distance(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const double t = std::clamp(carom::dot(point - from, way) / carom::length_squared(way), 0.0, 1.0);
  return carom::length(point - (from + t * way));
}

/// Returns true if the lead would meet something on its way to the centre of ball `target`.
bool obstructed(const carom::World& world, std::size_t target) {
  const carom::Ball lead = world.ball(0);
  const Vec2 from = lead.position;
  const Vec2 to = world.ball(target).position;
  for (std::size_t i = 1; i < world.size(); ++i)
    if (const carom::Ball ball = world.ball(i);
        i != target && world.in_play(i) &&
        distance(ball.position, from, to) < lead.radius + ball.radius &&
        carom::length(ball.position - from) < carom::length(to - from))
      return true;
  for (const carom::Hole& hole : world.scene().holes)
    if (distance(hole.position, from, to) < hole.radius) return true;
  for (const carom::Obstacle& wall : world.scene().obstacles) {
    if (distance({wall.x, wall.height}, from, to) < lead.radius + wall.radius) return true;
    const double t = (wall.x - from.x) / (to.x - from.x);
    if (t > 0 && t < 1 && from.y + t * (to.y - from.y) < wall.height) return true;
  }
  return false;
}

}  // namespace

Vec2 nearest(const carom::World& world, carom::Role role, Vec2 from, Vec2 other) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    const double distance = carom::length_squared(ball.position - from);
    if (ball.role != role || !world.in_play(i) || distance >= least) continue;
    least = distance;
    other = ball.position;
  }
  return other;
}

Vec2 first_aim(const carom::World& world, carom::Role role) {
  const Vec2 from = world.ball(0).position;
  Vec2 target = nearest(world, role, from, from + Vec2{1, 0});
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    const double distance = carom::length_squared(ball.position - from);
    if (ball.role != role || !world.in_play(i) || distance >= least || distance == 0 ||
        obstructed(world, i))
      continue;
    least = distance;
    target = ball.position;
  }
  return first_drag * carom::unit(target - from);
}

}  // namespace app
