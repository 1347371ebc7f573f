#include <algorithm>
#include <cmath>
#include <cstddef>

#include "carom/internal/forecast.hpp"
#include "carom/internal/kernels.hpp"
#include "carom/internal/pair.hpp"
#include "carom/world.hpp"

// When a ball may meet something, for Forecast (docs/physics.md).

namespace carom {

namespace {

bool solid(Edge edge) { return edge == Edge::solid; }

}  // namespace

void Forecast::predict(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  if ((hot_ & bit(i)) != 0) return set_due(i, always, always, always);
  if (fixed.scale.straight) return straight(fixed, balls, i);
  const double due = now_ + bounded(fixed, balls, i);
  set_due(i, due, due, due);
}

void Forecast::straight(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  const Scene& scene = fixed.scene;
  const double x = balls.x[i];
  const double y = balls.y[i];
  const double u = balls.vx[i];
  const double v = balls.vy[i];
  const double radius = balls.radius[i];
  // At the velocity that the ball has now, s.
  double pairs = never;
  double holes = never;
  double edges = never;
  // Until a disc with this relative motion may be nearer than `reach`.
  const auto until_near = [&](double& soonest, double dx, double dy, double du, double dv,
                              double reach) {
    const double far = reach + margin_;
    const double a = du * du + dv * dv;
    const double b = dx * du + dy * dv;
    const double squared = dx * dx + dy * dy;
    const double c = squared - far * far;
    if (c <= 0) {  // what rests there, within the margin, raises no alarm
      if (a != 0 || squared < reach * reach) soonest = always;
      return;
    }
    const double discriminant = b * b - a * c;
    if (b < 0 && discriminant >= 0) soonest = std::min(soonest, c / (std::sqrt(discriminant) - b));
  };
  const Kernels& k = kernels();
  Kernels::Disc one{x_[i], y_[i], vx_[i], vy_[i], radius_[i] + slack_};
  const Kernels::Discs others{x_.data(), y_.data(), vx_.data(), vy_.data(), radius_.data(), size_};
  for_each_ball(k.may_meet(others, one) & in_play_ & ~hot_ & ~bit(i), [&](std::size_t j) {
    until_near(pairs, balls.x[j] - x, balls.y[j] - y, balls.vx[j] - u, balls.vy[j] - v,
               radius + balls.radius[j]);
  });
  if ((moving_ & bit(i)) != 0) {
    const auto until = [&](double room, double speed) {
      edges = std::min(edges, (room - margin_) / speed);
    };
    const Edges& sides = scene.edges;
    if (u < 0) until(solid(sides.left) ? x - radius : x + radius, -u);
    if (u > 0) until(solid(sides.right) ? scene.width - radius - x : scene.width + radius - x, u);
    if (v < 0 && solid(sides.bottom)) until(y - radius, -v);
    if (v > 0 && solid(sides.top)) until(scene.height - radius - y, v);
    edges = std::max(edges, always);
    if (!scene.holes.empty()) {
      one.radius = slack_;
      const Kernels::Discs discs{fixed.holes.x.data(),      fixed.holes.y.data(), nullptr, nullptr,
                                 fixed.holes.radius.data(), scene.holes.size()};
      for_each_ball(k.may_meet(discs, one), [&](std::size_t n) {
        if (n >= scene.holes.size()) return;
        const Hole& hole = scene.holes[n];
        until_near(holes, hole.position.x - x, hole.position.y - y, -u, -v, hole.radius);
      });
    }
  }
  set_due(i, now_ + pairs * unit_, now_ + holes * unit_, now_ + edges * unit_);
}

// Steps until the ball may meet something, or what supports it may change.
//
// A way of m steps from the velocity v is v·T(m) and, for a ball that falls, up to g·t²/2 down,
// with t = h·m and m·h - (1 - f)·h·m²/2 ≤ T(m) ≤ m·h. Two discs do not meet while a line lies
// between them. Taken across the way from one to the other, with n from there to here, it tells
// that they are apart as long as n·(distance + way) > reach.
double Forecast::bounded(const FixedParts& fixed, const Balls& balls, std::size_t i) const {
  const Scene& scene = fixed.scene;
  const BallMask one = bit(i);
  const bool moves = (moving_ & one) != 0;
  const double gravity = scene.gravity;
  const Vec2 place = balls.position(i);
  const Vec2 velocity = balls.velocity(i);
  const double radius = balls.radius[i];
  const double fall = gravity * (time_step * time_step / 2 * (1 + hair));
  const double slowing = (1 - scene.friction) / 2 * (1 + hair) + hair;

  // The steps m with room + m·way·h > sinks·m²·fall, where `way` is slowed down by friction.
  const auto steps = [&](double room, double way, double sinks) {
    room -= margin_;
    if (!(room > 0)) return 0.0;
    double speed = way * time_step;
    double astray = sinks > 0 ? sinks * fall : 0;
    if (speed > 0) astray += speed * slowing;
    if (astray == 0) return speed < 0 ? room / -speed * (1 - hair) : never;
    const double root = std::sqrt(speed * speed + 4 * astray * room);
    return (1 - hair) * (speed > 0 ? (speed + root) / (2 * astray) : 2 * room / (root - speed));
  };
  // The same for two discs, or a disc and a point, `distance` from there to here.
  const auto apart = [&](Vec2 distance, Vec2 way, double reach, double sinks) {
    const double far = length(distance);
    if (!(far > reach)) return 0.0;
    const Vec2 n = distance / far;
    const double across = steps(far - reach, dot(n, way), sinks * n.y);
    const double aside = std::abs(distance.x) - reach;
    if (!(aside > margin_)) return across;
    return std::max(across, steps(aside, distance.x > 0 ? way.x : -way.x, 0));
  };

  const Edges& edges = scene.edges;
  const auto [x, y] = place;
  const auto [u, v] = velocity;
  const bool held = (held_ & one) != 0;
  const double sinks = held || gravity == 0 ? 0 : 1;
  const double lies_below = separation_factor * radius;
  double most = never;
  const double reach = gravity > 0 ? touching_factor * (1 + hair) : 1;
  if (moves) {
    if (u < 0) most = std::min(most, steps(solid(edges.left) ? x - radius : x + radius, u, 0));
    if (u > 0) {
      const double room = scene.width - x;
      most = std::min(most, steps(solid(edges.right) ? room - radius : room + radius, -u, 0));
    }
    if (held) {
      // A ball that rolls on anything but the floor has that near it.
      if (v < 0 && solid(edges.bottom)) most = std::min(most, steps(y - radius, v, 0));
      if (v > 0) most = std::min(most, steps(lies_below - y, -v, 0));
    } else {
      if (solid(edges.bottom))
        most = std::min(most, steps(y - (gravity > 0 ? lies_below : radius), v, sinks));
      if (v > 0 && solid(edges.top)) most = std::min(most, steps(scene.height - radius - y, -v, 0));
    }
    for (std::size_t n = 0; n < scene.holes.size() && most > 0; ++n)
      most = std::min(
          most, apart(place - scene.holes[n].position, velocity, scene.holes[n].radius, sinks));
    for (std::size_t n = 0; n < scene.obstacles.size() && most > 0; ++n) {
      const Obstacle& obstacle = scene.obstacles[n];
      const Vec2 distance = place - Vec2{obstacle.x, obstacle.height};
      const double w = reach * (obstacle.radius + radius);
      if (distance.y >= 0)  // the line lies between the ball and the wall, too
        most = std::min(most, apart(distance, velocity, w, sinks));
      else
        most = std::min(most, steps(std::abs(distance.x) - w, distance.x > 0 ? u : -u, 0));
    }
  }
  // A ball that stands is predicted, too: it may have been hot when those that come near were.
  for_each_ball((moves ? in_play_ : moving_) & ~hot_ & ~one, [&](std::size_t j) {
    if (!(most > 0)) return;
    const bool other_falls = (moving_ & ~held_ & bit(j)) != 0;
    const double apiece = other_falls && gravity > 0 ? 1 : 0;
    most = std::min(most, apart(place - balls.position(j), velocity - balls.velocity(j),
                                reach * (radius + balls.radius[j]), sinks - apiece));
  });
  return most > 0 ? most : always;
}

}  // namespace carom
