#include "soak/invariants.hpp"

#include <algorithm>
#include <cmath>

#include "json/number_text.hpp"

namespace soak {

namespace {

using carom::Ball;
using carom::Edge;
using carom::Vec2;

constexpr double rounding = 1e-9;  // of energies, relative

bool finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

// A ball that was put just touching may stick out by a rounding error of the sum, and only then.
bool inside(const carom::Scene& fixed, const Ball& ball) {
  const auto& [x, y] = ball.position;
  const double r = ball.radius;
  const carom::Edges& edges = fixed.edges;
  return (edges.left == Edge::open || x >= r) && (edges.bottom == Edge::open || y >= r) &&
         (edges.right == Edge::open || x + r <= fixed.width || x == fixed.width - r) &&
         (edges.top == Edge::open || y + r <= fixed.height || y == fixed.height - r);
}

}  // namespace

void Invariants::before_step(const carom::World& world) {
  before_.clear();
  present_.assign(present_.size(), false);
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!world.in_play(i)) continue;
    const Ball ball = world.ball(i);
    before_.push_back(ball);
    if (ball.id >= present_.size()) present_.resize(ball.id + 1, false);
    present_[ball.id] = true;
  }
}

std::optional<std::string> Invariants::after_step(const carom::World& world) {
  double energy = 0;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!world.in_play(i)) continue;
    const Ball ball = world.ball(i);
    const std::string name = "ball " + std::to_string(ball.id);
    if (!finite(ball.position) || !finite(ball.velocity) || !finite(ball.acceleration) ||
        std::isnan(ball.solidity))
      return name + " has a number that is not finite";
    if (!inside(world.scene(), ball)) return name + " sticks out of a solid edge";
    if (ball.id >= present_.size() || !present_[ball.id])
      return name + " is there twice, or was not there before";
    present_[ball.id] = false;
    energy += carom::length_squared(ball.velocity);
  }
  const double bound = energy_bound(world.scene());
  if (energy > bound + rounding * (1 + bound)) {
    std::string text = "the sum of squared speeds is ";
    carom::append_number(text, energy);
    text += ", more than ";
    carom::append_number(text, bound);
    return text;
  }
  return std::nullopt;
}

double Invariants::energy_bound(const carom::Scene& fixed) const {
  double parts = 1;  // of the step (docs/physics.md#one-step)
  double energy = 0;
  double undivided = 0;
  for (const Ball& ball : before_) {
    const Vec2 v = ball.velocity;
    parts = std::max(parts, carom::length(v) * carom::time_step / ball.radius);
    energy += carom::length_squared(v);
    undivided += carom::length_squared(fixed.friction * v + carom::time_step * ball.acceleration);
  }
  if (parts <= 1) return undivided;

  // Where a ball may get to within the step: no further than the fastest could, and than a few
  // balls may push it aside.
  const double speed = std::sqrt(energy);
  double pulls = 0;
  for (const Ball& ball : before_) {
    const double reach =
        (speed + fixed.hole_pull / 2 * carom::time_step) * carom::time_step + 10 * ball.radius;
    double pull = fixed.gravity;
    for (const carom::Hole& hole : fixed.holes)
      if (carom::length(hole.position - ball.position) < hole.radius + reach)
        pull += fixed.hole_pull / 2;
    pulls += pull * pull;
  }
  const double norm = speed + std::sqrt(pulls) * carom::time_step;
  return norm * norm;
}

}  // namespace soak
