#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "carom/all_pairs.hpp"
#include "carom/world.hpp"

namespace carom {

/// One step of a world: the stages of spec §2 in their order, which is part of their meaning.
class Stepper {
 public:
  explicit Stepper(World& world)
      : scene_(world.scene_),
        balls_(world.balls_),
        lead_out_(world.lead_out_),
        events_(world.events_),
        gone_(world.gone_) {}

  void step() {
    const int k = sub_steps();
    const double h = time_step / k;
    const bool lead_was_out = lead_out_;
    for (int part = 1; part <= k && lead_out_ == lead_was_out; ++part) {
      gone_.assign(balls_.size(), 0);
      if (lead_out_) gone_[0] = 1;
      AllPairs pairs(balls_, gone_);
      // The friction of a whole step acts once, in its last part.
      move(h, part == k ? scene_.friction : 1.0);
      collide(pairs);
      if (scene_.gravity > 0) support(pairs);
      holes();
      obstacles();
      edges();
      remove();
    }
  }

 private:
  // Enough parts that no ball moves further than its radius in one (§1.2.1, erratum E2).
  int sub_steps() const {
    double most = 1;
    for (std::size_t i = lead_out_ ? 1 : 0; i < balls_.size(); ++i)
      most = std::max(most, length(balls_[i].velocity) * time_step / balls_[i].radius);
    if (most >= max_sub_steps) return max_sub_steps;
    const int whole = static_cast<int>(most);
    return whole < most ? whole + 1 : whole;
  }

  // Stage 1 (§1.2.1, erratum E1).
  void move(double h, double friction) {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (gone_[i]) continue;
      Ball& ball = balls_[i];
      ball.position += ball.velocity * h;
      ball.velocity = ball.velocity * friction + ball.acceleration * h;
      ball.acceleration = {0, -scene_.gravity};
    }
  }

  // Stage 2: what overlaps collides at once, so later pairs see the moved balls.
  template <class BroadPhase>
  void collide(BroadPhase& pairs) {
    Pair pair;
    while (const auto next = pairs.next_overlap(pair)) {
      pair = *next;
      if (const auto third = pairs.touching_both(pair))
        collide_three(pairs, pair.first, pair.second, *third);
      else
        collide_two(pairs, pair.first, pair.second);
    }
  }

  // §1.2.3
  template <class BroadPhase>
  void collide_two(BroadPhase& pairs, std::size_t i, std::size_t j) {
    const Vec2 u = separate(pairs, i, j);
    exchange(i, j, deviation(balls_[i].velocity, balls_[j].velocity, u));
  }

  // §1.2.4: the energy is shared, so each of the three pairs sees halved velocities.
  template <class BroadPhase>
  void collide_three(BroadPhase& pairs, std::size_t i, std::size_t j, std::size_t k) {
    const std::array<std::pair<std::size_t, std::size_t>, 3> sides{{{i, j}, {j, k}, {i, k}}};
    for (const auto& [a, b] : sides)
      if (overlap(balls_[a], balls_[b])) separate(pairs, a, b);
    std::array<Vec2, 3> deviations;
    for (std::size_t n = 0; n < 3; ++n) {
      const auto& [a, b] = sides[n];
      const Vec2 u = unit(balls_[b].position - balls_[a].position);
      deviations[n] = deviation(balls_[a].velocity * 0.5, balls_[b].velocity * 0.5, u);
    }
    for (std::size_t n = 0; n < 3; ++n) {
      const auto& [a, b] = sides[n];
      if (!gone_[a] && !gone_[b]) exchange(a, b, deviations[n]);
    }
  }

  // Puts an overlapping pair almost in contact about its meeting point; returns the unit vector
  // from i to j.
  template <class BroadPhase>
  Vec2 separate(BroadPhase& pairs, std::size_t i, std::size_t j) {
    Ball& a = balls_[i];
    Ball& b = balls_[j];
    const Vec2 u = unit(b.position - a.position);
    const Vec2 g = between(a, b);
    a.position = g - separation_factor * a.radius * u;
    b.position = g + separation_factor * b.radius * u;
    pairs.moved(i);
    pairs.moved(j);
    return u;
  }

  // None for a pair that is parting already (erratum E3).
  static Vec2 deviation(Vec2 va, Vec2 vb, Vec2 u) {
    return std::max(dot(va, u) - dot(vb, u), 0.0) * u;
  }

  // Gives dv from one ball to the other; if exactly one of them breaks, the other is deviated the
  // less, the weaker that one was (§2.2.4).
  void exchange(std::size_t i, std::size_t j, Vec2 dv) {
    Ball& a = balls_[i];
    Ball& b = balls_[j];
    events_.push_back({.kind = EventKind::pair,
                       .ball = a.id,
                       .other = b.id,
                       .position = between(a, b),
                       .deviation = dv});
    const double solidity_a = a.solidity;
    const double solidity_b = b.solidity;
    wear(i, dv);
    wear(j, dv);
    if (gone_[i] != gone_[j]) {
      const double ds = scene_.damage_per_speed * length(dv);
      dv = (gone_[i] ? solidity_a : solidity_b) / ds * dv;
    }
    a.velocity -= dv;
    b.velocity += dv;
  }

  // The mean of the centres, each weighted by the other's radius.
  static Vec2 between(const Ball& a, const Ball& b) {
    return (b.radius * a.position + a.radius * b.position) / (a.radius + b.radius);
  }

  // §2.1.1, §2.2.3: a shock costs solidity in proportion to the deviation, a weak one nothing.
  void wear(std::size_t i, Vec2 change) {
    Ball& ball = balls_[i];
    const double ds = scene_.damage_per_speed * length(change);
    if (ball.solidity == infinite_solidity || ds == 0 || ds < scene_.damage_threshold) return;
    ball.solidity -= ds;
    events_.push_back({.kind = EventKind::damage,
                       .ball = ball.id,
                       .position = ball.position,
                       .damage = ds,
                       .solidity = ball.solidity});
    if (ball.solidity < 0) lose(i, EventKind::destroyed);
  }

  // From here on the ball takes no part in the step.
  void lose(std::size_t i, EventKind how, std::size_t hole = 0) {
    gone_[i] = 1;
    events_.push_back({.kind = how,
                       .ball = balls_[i].id,
                       .other = static_cast<std::uint32_t>(hole),
                       .position = balls_[i].position});
  }

  // Stage 3 (§2.2.2): the lower ball of a touching pair acts as if fixed.
  template <class BroadPhase>
  void support(BroadPhase& pairs) {
    Pair pair;
    while (const auto next = pairs.next_touching(pair)) {
      pair = *next;
      Ball& a = balls_[pair.first];
      Ball& b = balls_[pair.second];
      const Vec2 u = unit(b.position - a.position);
      if (a.position.y <= b.position.y)
        hold(b, u);
      else
        hold(a, -1.0 * u);
    }
  }

  // Takes away what of a ball's acceleration presses against its support; u points from there to
  // it.
  static void hold(Ball& ball, Vec2 u) {
    ball.acceleration -= std::min(dot(ball.acceleration, u), 0.0) * u;
  }

  // Stage 4 (§1.2.5).
  void holes() {
    for (std::size_t n = 0; n < scene_.holes.size(); ++n) {
      const Hole& hole = scene_.holes[n];
      for (std::size_t i = 0; i < balls_.size(); ++i) {
        if (gone_[i]) continue;
        Ball& ball = balls_[i];
        const Vec2 inwards = hole.position - ball.position;
        const double distance = length(inwards);
        if (distance >= hole.radius) continue;
        if (distance <= hole.radius - ball.radius) {
          lose(i, EventKind::pocketed, n);
        } else if (distance > 0) {
          const double d = (hole.radius - distance) / ball.radius;
          // Rounding may put d a hair above 1.
          const double pull = scene_.hole_pull * d * std::sqrt(std::max(1 - d * d, 0.0));
          ball.acceleration += pull * (inwards / distance);
        }
      }
    }
  }

  // Stage 5 (§2.2.5).
  void obstacles() {
    for (std::size_t n = 0; n < scene_.obstacles.size(); ++n)
      for (std::size_t i = 0; i < balls_.size(); ++i)
        if (!gone_[i]) obstacle(scene_.obstacles[n], n, i);
  }

  void obstacle(const Obstacle& obstacle, std::size_t n, std::size_t i) {
    Ball& ball = balls_[i];
    const double reach = obstacle.radius + ball.radius;
    if (ball.position.y < obstacle.height) {
      if (std::abs(ball.position.x - obstacle.x) >= reach) return;
      const double side = ball.position.x >= obstacle.x ? 1 : -1;
      ball.position.x = obstacle.x + side * reach;
      bounce(i, {side, 0}, EventKind::wall, n);
      return;
    }
    const Vec2 cap{obstacle.x, obstacle.height};
    if (length(ball.position - cap) < reach) {
      const Vec2 u = unit(ball.position - cap);
      ball.position = cap + separation_factor * reach * u;
      bounce(i, u, EventKind::cap, n);
      if (gone_[i]) return;
    }
    if (scene_.gravity > 0 && length(ball.position - cap) <= touching_factor * reach)
      hold(ball, unit(ball.position - cap));
  }

  // Mirrors away what of a ball's velocity goes against u, the unit vector out of what it hit; all
  // it does for a ball that is parting already is to tell (erratum E3).
  void bounce(std::size_t i, Vec2 u, EventKind kind, std::size_t what) {
    Ball& ball = balls_[i];
    const Vec2 change = -2.0 * std::min(dot(ball.velocity, u), 0.0) * u;
    ball.velocity += change;
    events_.push_back({.kind = kind,
                       .ball = ball.id,
                       .other = static_cast<std::uint32_t>(what),
                       .position = ball.position,
                       .deviation = change});
    wear(i, change);
  }

  // Stage 6 (§1.2.2, §2.1.3, §2.2.2, §2.2.3).
  void edges() {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (!gone_[i]) side(i, Side::left, scene_.edges.left);
      if (!gone_[i]) side(i, Side::right, scene_.edges.right);
      if (!gone_[i]) side(i, Side::bottom, scene_.edges.bottom);
      if (!gone_[i]) side(i, Side::top, scene_.edges.top);
      Ball& ball = balls_[i];
      if (!gone_[i] && scene_.gravity > 0 && scene_.edges.bottom == Edge::solid &&
          ball.position.y <= separation_factor * ball.radius)
        ball.acceleration.y = std::max(ball.acceleration.y, 0.0);
    }
  }

  void side(std::size_t i, Side side, Edge edge) {
    Ball& ball = balls_[i];
    const bool upright = side == Side::left || side == Side::right;
    const bool low = side == Side::left || side == Side::bottom;
    double& coordinate = upright ? ball.position.x : ball.position.y;
    const double end = upright ? scene_.width : scene_.height;
    const double r = ball.radius;
    if (edge == Edge::open) {
      if (upright && (low ? coordinate + r < 0 : coordinate - r > end)) lose(i, EventKind::left);
      return;
    }
    if (low ? coordinate - r >= 0 : coordinate + r <= end) return;
    coordinate = low ? r : end - r;
    const double inwards = low ? 1 : -1;
    const bool floor = side == Side::bottom && scene_.gravity > 0;
    bounce(i, upright ? Vec2{inwards, 0} : Vec2{0, inwards},
           floor ? EventKind::floor : EventKind::cushion, static_cast<std::size_t>(side));
  }

  // Stage 7 (§1.4.1): from the highest index down, so the last ball is always one that stays.
  void remove() {
    for (std::size_t i = balls_.size(); i-- > 0;) {
      if (!gone_[i]) continue;
      if (i == 0 && is_lead(balls_[0].role)) {
        lead_out_ = true;
        continue;
      }
      balls_[i] = balls_.back();
      balls_.pop_back();
    }
  }

  const Scene& scene_;
  std::vector<Ball>& balls_;
  bool& lead_out_;
  std::vector<Event>& events_;
  std::vector<std::uint8_t>& gone_;
};

std::span<const Event> World::step() {
  events_.clear();
  Stepper(*this).step();
  ++steps_;
  return events_;
}

}  // namespace carom
