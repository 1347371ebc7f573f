#include "app/first_contact.hpp"

#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// How far a coordinate runs at rate `way` until it meets a solid edge at `low` or `high`.
double edge_distance(double from, double way, double low, carom::Edge low_edge, double high,
                     carom::Edge high_edge) {
  if (way < 0 && low_edge == carom::Edge::solid) return (low - from) / way;
  if (way > 0 && high_edge == carom::Edge::solid) return (high - from) / way;
  return never;
}

}  // namespace

std::optional<FirstContact> first_contact(const carom::World& world, std::size_t index,
                                          carom::Vec2 direction) {
  const carom::Ball ball = world.ball(index);
  const carom::Scene& scene = world.scene();
  const carom::Vec2 way = carom::unit(direction);
  const double r = ball.radius;

  double distance = std::min(edge_distance(ball.position.x, way.x, r, scene.edges.left,
                                           scene.width - r, scene.edges.right),
                             edge_distance(ball.position.y, way.y, r, scene.edges.bottom,
                                           scene.height - r, scene.edges.top));
  distance = std::max(distance, 0.0);
  std::optional<carom::Vec2> target;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (i == index || !world.in_play(i)) continue;
    const carom::Vec2 between = world.ball(i).position - ball.position;
    const double along = carom::dot(between, way);
    const double reach = r + world.ball(i).radius;
    const double half_chord_squared =
        reach * reach - (carom::length_squared(between) - along * along);
    if (along <= 0 || half_chord_squared < 0) continue;
    const double contact = std::max(along - std::sqrt(half_chord_squared), 0.0);
    if (contact < distance) {
      distance = contact;
      target = world.ball(i).position;
    }
  }
  if (distance == never) return std::nullopt;
  return FirstContact{ball.position + distance * way, target};
}

}  // namespace app
