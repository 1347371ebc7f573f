#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "carom/arithmetic.hpp"
#include "carom/balls.hpp"
#include "carom/internal/all_pairs.hpp"
#include "carom/internal/arithmetic_check.hpp"
#include "carom/internal/due_pairs.hpp"
#include "carom/internal/fixed_parts.hpp"
#include "carom/internal/forecast.hpp"
#include "carom/internal/row_pairs.hpp"
#include "carom/internal/thread_pool.hpp"
#include "carom/internal/vectors.hpp"
#include "carom/internal/workspace.hpp"
#include "carom/world.hpp"

namespace carom {

/// One step of a world: the stages of docs/physics.md#one-step in their order, which is part of
/// their meaning.
class Stepper {
 public:
  explicit Stepper(World& world)
      : world_(world),
        fixed_(*world.fixed_),
        scene_(fixed_.scene),
        balls_(world.balls_),
        lead_out_(world.lead_out_),
        workspace_(*world.owner_.workspace),
        events_(workspace_.events),
        gone_(workspace_.gone),
        forecast_(workspace_.forecast),
        broad_phase_(world.broad_phase_),
        forecast_wanted_(world.skipping_ && broad_phase_ == BroadPhase::automatic &&
                         Forecast::suits(scene_, balls_.size())) {
    if (!forecast_wanted_) forecast_.forget();
    workspace_.set_threads(balls_.size() < many_balls ? 1 : world.threads_);
  }

  struct Taken {
    std::uint64_t steps = 0;
    bool rests = false;
  };

  // Takes steps: at most `most`; the last is the first that has events or, if so wanted, the first
  // after which all rests.
  Taken take(std::uint64_t most, bool until_rest) {
    Taken taken;
    while (taken.steps < most && events_.empty() && !taken.rests) {
      std::uint64_t steps = 1;
      bool may_rest = true;
      const bool anywhere = forecast_wanted_ && Forecast::begins_anywhere(fixed_);
      if (!forecast_.begun() && anywhere) forecast_.begin(fixed_, balls_, lead_out_, false);
      if (forecast_.begun()) {
        std::uint64_t limit = most - taken.steps;
        if (until_rest) limit = std::min(limit, forecast_.steps_until_rest());
        steps = forecast_steps(limit);
        if (steps == 0) continue;
        may_rest = forecast_.may_rest();
      } else {
        whole_step();
        if (forecast_wanted_ && !anywhere)
          forecast_.begin(fixed_, balls_, lead_out_, !events_.empty());
      }
      taken.steps += steps;
      if (!may_rest) continue;
      if (forecast_.begun() && forecast_.is_busy(fixed_, balls_)) continue;
      if (until_rest) taken.rests = world_.at_rest();
    }
    return taken;
  }

 private:
  // All seven stages for all balls.
  void whole_step() {
    const int k = sub_steps();
    const double h = time_step / k;
    const bool lead_was_out = lead_out_;
    for (int part = 1; part <= k && lead_out_ == lead_was_out; ++part) {
      begin_part();
      // The friction of a whole step acts once, in its last part.
      move(h, part == k ? scene_.friction : 1.0);
      const bool automatic = broad_phase_ == BroadPhase::automatic;
      if (broad_phase_ == BroadPhase::pairs || (automatic && balls_.size() <= all_pairs_balls))
        after_move(AllPairs(balls_, gone_));
      else if (automatic && balls_.size() <= PackedIndex::max_balls)
        after_move(RowPairs(balls_, gone_, workspace_.packed, workspace_.rows));
      else
        after_move(RowPairs(balls_, gone_, workspace_.tree, workspace_.rows));
    }
  }

  // At most `most` steps: quiet ones, then one that is not. None, if the forecast has ended.
  std::uint64_t forecast_steps(std::uint64_t most) {
    const Forecast::Ahead ahead = forecast_.look_ahead(fixed_, balls_, most);
    if (!forecast_.begun()) return 0;
    const bool at_once = ahead.due && ahead.whole;
    if (const int moves = ahead.quiet + (at_once ? 1 : 0); moves > 0)
      forecast_.advance(fixed_, balls_, moves);
    forecast_.pass(ahead.quiet);
    if (ahead.due) due_step(at_once);
    return static_cast<std::uint64_t>(ahead.quiet + (ahead.due ? 1 : 0));
  }

  // A step in which only the balls that are due need more than stage 1. `moved`: this one is over.
  void due_step(bool moved) {
    const int k = moved ? 1 : forecast_.parts(fixed_, balls_);
    const double h = time_step / k;
    const bool lead_was_out = lead_out_;
    int part = 0;
    while (part < k && lead_out_ == lead_was_out) {
      ++part;
      if (!moved) forecast_.move(fixed_, balls_, h, part == k ? scene_.friction : 1.0);
      if (const Forecast::Due due = forecast_.due(fixed_, balls_, part, k); due.balls != 0) {
        begin_part();
        after_due_move(due);
      }
    }
    forecast_.end_step(fixed_, balls_, part, k);
  }

  void begin_part() {
    gone_.assign(balls_.size(), 0);
    any_gone_ = false;
    if (lead_out_) gone_[0] = 1;
  }

  template <class Pairs>
  void after_move(Pairs pairs) {
    collide(pairs);
    if (scene_.gravity > 0) support(pairs);
    holes(pairs);
    obstacles(pairs);
    edges();
    remove();
  }

  void after_due_move(const Forecast::Due& due) {
    const bool gravity = scene_.gravity > 0;
    DuePairs pairs(balls_, gone_, forecast_, due, gravity);
    if (due.pairs != 0) collide(pairs);
    pairs.choose_active();
    for_each_ball(pairs.active(), [&](std::size_t i) {
      balls_.set_acceleration(i, {0, -scene_.gravity});
    });
    if (gravity) support(pairs);
    if (const BallMask near = gravity ? pairs.active() : due.holes | pairs.struck(); near != 0)
      for (std::size_t n = 0; n < scene_.holes.size(); ++n)
        for_each_ball(near, [&](std::size_t i) {
          if (!gone_[i]) hole(n, i);
        });
    obstacles(pairs);
    const BallMask struck = pairs.struck();
    for_each_ball(pairs.active(), [&](std::size_t i) {
      const Vec2 before = balls_.position(i);
      edges(i);
      if (!(balls_.position(i) == before)) pairs.moved(i);
    });
    remove();
    const BallMask all = ~BallMask{0};
    forecast_.settle(fixed_, balls_, any_gone_ ? all : struck, any_gone_ ? all : pairs.put());
  }

  // Runs action(begin, end) on all of [0, size), on several threads if there are.
  template <class Action>
  void run_parts(std::size_t size, Action action) {
    if (workspace_.thread_pool == nullptr)
      action(std::size_t{0}, size);
    else
      workspace_.thread_pool->share(
          size, [&](std::size_t, std::size_t begin, std::size_t end) { action(begin, end); });
  }

  // Up to these numbers of balls the simpler ways are quicker (docs/performance.md).
  static constexpr std::size_t all_pairs_balls = 6;
  static constexpr std::size_t few_balls = 128;
  // With fewer, waking another thread takes longer than what it would do.
  static constexpr std::size_t many_balls = 20'000;

  std::size_t first_in_play() const { return lead_out_ ? 1 : 0; }

  // Enough parts that no ball moves further than its radius in one (§1.2.1, docs/physics.md#errata,
  // E2).
  int sub_steps() const {
    if (!any_fast()) return 1;
    double most = 1;
    for (std::size_t i = first_in_play(); i < balls_.size(); ++i)
      most = std::max(most, length(balls_.velocity(i)) * time_step / balls_.radius[i]);
    if (most >= max_sub_steps) return max_sub_steps;
    const int whole = static_cast<int>(most);
    return whole < most ? whole + 1 : whole;
  }

  // True if a ball may move further than its radius in one step. The squares of both sides are
  // compared, without root and quotient; the margin is far above what their rounding can change.
  bool any_fast() const {
    constexpr double margin = 1 + 1e-12;
    const auto too_fast = [](auto vx, auto vy, auto radius) {
      return (vx * vx + vy * vy) * (time_step * time_step * margin) > radius * radius;
    };
    const std::size_t n = balls_.size();
    std::size_t i = first_in_play();
    Long2 fast{};
    for (; i + 2 <= n; i += 2)
      fast |= too_fast(load<Double2>(&balls_.vx[i]), load<Double2>(&balls_.vy[i]),
                       load<Double2>(&balls_.radius[i]));
    if ((fast[0] | fast[1]) != 0) return true;
    return i < n && too_fast(balls_.vx[i], balls_.vy[i], balls_.radius[i]);
  }

  // Stage 1 (§1.2.1, docs/physics.md#errata, E1). Two balls at a time: each lane is rounded as a
  // single number is.
  void move(double h, double friction) {
    run_parts(balls_.size(), [&](std::size_t begin, std::size_t end) {
      std::size_t i = std::max(begin, first_in_play());
      for (; i + 2 <= end; i += 2) move<Double2>(i, h, friction);
      for (; i < end; ++i) move<double>(i, h, friction);
    });
  }

  template <class Numbers>
  void move(std::size_t i, double h, double friction) {
    const auto along = [&](double* position, double* velocity, double* acceleration, double next) {
      const auto v = load<Numbers>(velocity + i);
      store(position + i, load<Numbers>(position + i) + v * h);
      store(velocity + i, v * friction + load<Numbers>(acceleration + i) * h);
      store(acceleration + i, all_lanes<Numbers>(next));
    };
    along(balls_.x.data(), balls_.vx.data(), balls_.ax.data(), 0);
    along(balls_.y.data(), balls_.vy.data(), balls_.ay.data(), -scene_.gravity);
  }

  // Stage 2: what overlaps collides at once, so later pairs see the moved balls.
  template <class Pairs>
  void collide(Pairs& pairs) {
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
  template <class Pairs>
  void collide_two(Pairs& pairs, std::size_t i, std::size_t j) {
    const Vec2 u = separate(pairs, i, j);
    exchange(i, j, deviation(balls_.velocity(i), balls_.velocity(j), u));
  }

  // §1.2.4: the energy is shared, so each of the three pairs sees halved velocities.
  template <class Pairs>
  void collide_three(Pairs& pairs, std::size_t i, std::size_t j, std::size_t k) {
    const std::array<std::pair<std::size_t, std::size_t>, 3> sides{{{i, j}, {j, k}, {i, k}}};
    for (const auto& [a, b] : sides)
      if (overlap(balls_, a, b)) separate(pairs, a, b);
    std::array<Vec2, 3> deviations;
    for (std::size_t n = 0; n < 3; ++n) {
      const auto& [a, b] = sides[n];
      const Vec2 u = unit(balls_.position(b) - balls_.position(a));
      deviations[n] = deviation(balls_.velocity(a) * 0.5, balls_.velocity(b) * 0.5, u);
    }
    for (std::size_t n = 0; n < 3; ++n) {
      const auto& [a, b] = sides[n];
      if (!gone_[a] && !gone_[b]) exchange(a, b, deviations[n]);
    }
  }

  // Puts an overlapping pair almost in contact about its meeting point; returns the unit vector
  // from i to j.
  template <class Pairs>
  Vec2 separate(Pairs& pairs, std::size_t i, std::size_t j) {
    const Vec2 u = unit(balls_.position(j) - balls_.position(i));
    const Vec2 g = between(i, j);
    balls_.set_position(i, g - separation_factor * balls_.radius[i] * u);
    balls_.set_position(j, g + separation_factor * balls_.radius[j] * u);
    pairs.moved(i);
    pairs.moved(j);
    return u;
  }

  // None for a pair that is parting already (docs/physics.md#errata, E3).
  static Vec2 deviation(Vec2 va, Vec2 vb, Vec2 u) {
    return std::max(dot(va, u) - dot(vb, u), 0.0) * u;
  }

  // Gives dv from one ball to the other; if exactly one of them breaks, the other is deviated the
  // less, the weaker that one was (§2.2.4).
  void exchange(std::size_t i, std::size_t j, Vec2 dv) {
    events_.push_back({.kind = EventKind::pair,
                       .ball = balls_.id[i],
                       .other = balls_.id[j],
                       .position = between(i, j),
                       .deviation = dv});
    const double solidity_i = balls_.solidity[i];
    const double solidity_j = balls_.solidity[j];
    wear(i, dv);
    wear(j, dv);
    if (gone_[i] != gone_[j]) {
      const double ds = scene_.damage_per_speed * length(dv);
      dv = (gone_[i] ? solidity_i : solidity_j) / ds * dv;
    }
    balls_.set_velocity(i, balls_.velocity(i) - dv);
    balls_.set_velocity(j, balls_.velocity(j) + dv);
  }

  // The mean of the centres, each weighted by the other's radius.
  Vec2 between(std::size_t i, std::size_t j) const {
    const double ri = balls_.radius[i];
    const double rj = balls_.radius[j];
    return (rj * balls_.position(i) + ri * balls_.position(j)) / (ri + rj);
  }

  // §2.1.1, §2.2.3: a shock costs solidity in proportion to the deviation, a weak one nothing.
  void wear(std::size_t i, Vec2 change) {
    if (balls_.solidity[i] == infinite_solidity) return;
    const double ds = scene_.damage_per_speed * length(change);
    if (ds == 0 || ds < scene_.damage_threshold) return;
    balls_.solidity[i] -= ds;
    events_.push_back({.kind = EventKind::damage,
                       .ball = balls_.id[i],
                       .position = balls_.position(i),
                       .damage = ds,
                       .solidity = balls_.solidity[i]});
    if (balls_.solidity[i] < 0) lose(i, EventKind::destroyed);
  }

  // From here on the ball takes no part in the step.
  void lose(std::size_t i, EventKind how, std::size_t hole = 0) {
    gone_[i] = 1;
    any_gone_ = true;
    events_.push_back({.kind = how,
                       .ball = balls_.id[i],
                       .other = static_cast<std::uint32_t>(hole),
                       .position = balls_.position(i)});
  }

  // Stage 3 (§2.2.2): the lower ball of a touching pair acts as if fixed.
  template <class Pairs>
  void support(Pairs& pairs) {
    pairs.for_each_touching([&](Pair pair) {
      const auto [i, j] = pair;
      const Vec2 u = unit(balls_.position(j) - balls_.position(i));
      if (balls_.y[i] <= balls_.y[j])
        hold(j, u);
      else
        hold(i, -1.0 * u);
    });
  }

  // Takes away what of a ball's acceleration presses against its support; u points from there to
  // it.
  void hold(std::size_t i, Vec2 u) {
    const Vec2 a = balls_.acceleration(i);
    balls_.set_acceleration(i, a - std::min(dot(a, u), 0.0) * u);
  }

  // Stage 4 (§1.2.5). A few balls are first compared with a part of the table that has no hole.
  template <class Pairs>
  void holes(Pairs& pairs) {
    if (scene_.holes.empty()) return;
    if (balls_.size() <= few_balls) {
      few_near_holes();
      return;
    }
    for (std::size_t n = 0; n < scene_.holes.size(); ++n) {
      const Vec2 centre = scene_.holes[n].position;
      const Vec2 reach{scene_.holes[n].radius, scene_.holes[n].radius};
      pairs.for_each_in_box(centre - reach, centre + reach, [&](std::size_t i) {
        if (!gone_[i]) hole(n, i);
      });
    }
  }

  void few_near_holes() {
    const Box& free = fixed_.hole_free;
    const auto outside = [&](auto x, auto y) {
      return (x <= free.low.x) | (x >= free.high.x) | (y <= free.low.y) | (y >= free.high.y);
    };
    std::array<std::size_t, few_balls> near;
    std::size_t count = 0;
    std::size_t i = 0;
    for (; i + 2 <= balls_.size(); i += 2)
      for_each_bit(bits(std::bit_cast<Long2>(
                       outside(load<Double2>(&balls_.x[i]), load<Double2>(&balls_.y[i])))),
                   [&](std::uint32_t lane) { near[count++] = i + lane; });
    if (i < balls_.size() && outside(balls_.x[i], balls_.y[i])) near[count++] = i;
    for (std::size_t n = 0; n < scene_.holes.size(); ++n)
      for (std::size_t k = 0; k < count; ++k)
        if (!gone_[near[k]]) hole(n, near[k]);
  }

  void hole(std::size_t n, std::size_t i) {
    const Hole& hole = scene_.holes[n];
    const Vec2 inwards = hole.position - balls_.position(i);
    // Most are further away by more than what rounding may hide.
    if (length_squared(inwards) > hole.radius * hole.radius * (1 + 1e-12)) return;
    const double distance = length(inwards);
    if (distance >= hole.radius) return;
    const double radius = balls_.radius[i];
    if (distance <= hole.radius - radius) {
      lose(i, EventKind::pocketed, n);
    } else if (distance > 0) {
      const double d = (hole.radius - distance) / radius;
      // Rounding may put d a hair above 1.
      const double pull = scene_.hole_pull * d * std::sqrt(std::max(1 - d * d, 0.0));
      balls_.set_acceleration(i, balls_.acceleration(i) + pull * (inwards / distance));
    }
  }

  // Stage 5 (§2.2.5).
  template <class Pairs>
  void obstacles(Pairs& pairs) {
    if (scene_.obstacles.empty()) return;
    double lowest = 0;  // a wall goes down as far as there are balls
    for (const double y : balls_.y) lowest = std::min(lowest, y);
    for (std::size_t n = 0; n < scene_.obstacles.size(); ++n) {
      const Obstacle& obstacle = scene_.obstacles[n];
      const double side = obstacle.radius * box_factor;
      pairs.for_each_in_box({obstacle.x - side, lowest},
                            {obstacle.x + side, obstacle.height + side}, [&](std::size_t i) {
                              if (!gone_[i] && this->obstacle(n, i)) pairs.moved(i);
                            });
    }
  }

  // True if it put the ball elsewhere.
  bool obstacle(std::size_t n, std::size_t i) {
    const Obstacle& obstacle = scene_.obstacles[n];
    const double reach = obstacle.radius + balls_.radius[i];
    const Vec2 position = balls_.position(i);
    if (position.y < obstacle.height) {
      if (std::abs(position.x - obstacle.x) >= reach) return false;
      const double side = position.x >= obstacle.x ? 1 : -1;
      balls_.x[i] = obstacle.x + side * reach;
      bounce(i, {side, 0}, EventKind::wall, n);
      return true;
    }
    const Vec2 cap{obstacle.x, obstacle.height};
    const bool hit = length(position - cap) < reach;
    if (hit) {
      const Vec2 u = unit(position - cap);
      balls_.set_position(i, cap + separation_factor * reach * u);
      bounce(i, u, EventKind::cap, n);
      if (gone_[i]) return true;
    }
    const Vec2 out = balls_.position(i) - cap;
    if (scene_.gravity > 0 && length(out) <= touching_factor * reach) hold(i, unit(out));
    return hit;
  }

  // Mirrors away what of a ball's velocity goes against u, the unit vector out of what it hit; all
  // it does for a ball that is parting already is to tell (docs/physics.md#errata, E3).
  void bounce(std::size_t i, Vec2 u, EventKind kind, std::size_t what) {
    const Vec2 velocity = balls_.velocity(i);
    const Vec2 change = -2.0 * std::min(dot(velocity, u), 0.0) * u;
    balls_.set_velocity(i, velocity + change);
    events_.push_back({.kind = kind,
                       .ball = balls_.id[i],
                       .other = static_cast<std::uint32_t>(what),
                       .position = balls_.position(i),
                       .deviation = change});
    wear(i, change);
  }

  // Stage 6 (§1.2.2, §2.1.3, §2.2.2, §2.2.3). Most balls are far from every edge: these are passed
  // over some at a time, by the same comparisons that side() makes.
  void edges() {
    constexpr std::size_t block = 8;
    const std::size_t n = balls_.size();
    std::size_t i = 0;
    for (; i + block <= n; i += block)
      if (any_at_edge<block>(i))
        for (std::size_t k = i; k < i + block; ++k) edges(k);
    for (; i < n; ++i) edges(i);
  }

  template <std::size_t block>
  bool any_at_edge(std::size_t begin) const {
    const double low = scene_.gravity > 0 ? separation_factor : 1;
    Long2 out{};
    for (std::size_t i = begin; i < begin + block; i += 2) {
      const auto x = load<Double2>(&balls_.x[i]);
      const auto y = load<Double2>(&balls_.y[i]);
      const auto radius = load<Double2>(&balls_.radius[i]);
      out |= (x - radius < 0) | (x + radius > scene_.width) | (y - radius < 0) |
             (y + radius > scene_.height) | (y <= low * radius);
    }
    return (out[0] | out[1]) != 0;
  }

  void edges(std::size_t i) {
    if (!gone_[i]) side(i, Side::left, scene_.edges.left);
    if (!gone_[i]) side(i, Side::right, scene_.edges.right);
    if (!gone_[i]) side(i, Side::bottom, scene_.edges.bottom);
    if (!gone_[i]) side(i, Side::top, scene_.edges.top);
    if (!gone_[i] && scene_.gravity > 0 && scene_.edges.bottom == Edge::solid &&
        balls_.y[i] <= separation_factor * balls_.radius[i])
      balls_.ay[i] = std::max(balls_.ay[i], 0.0);
  }

  void side(std::size_t i, Side side, Edge edge) {
    const bool upright = side == Side::left || side == Side::right;
    const bool low = side == Side::left || side == Side::bottom;
    double& coordinate = upright ? balls_.x[i] : balls_.y[i];
    const double end = upright ? scene_.width : scene_.height;
    const double r = balls_.radius[i];
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
    if (!any_gone_) return;
    for (std::size_t i = balls_.size(); i-- > 0;) {
      if (!gone_[i]) continue;
      if (i == 0 && is_lead(balls_.role[0])) {
        lead_out_ = true;
        if (forecast_.begun()) forecast_.lead_went_out();
      } else {
        balls_.swap_out(i);
        if (forecast_.begun()) forecast_.swap_out(i);
      }
    }
  }

  const World& world_;
  const FixedParts& fixed_;
  const Scene& scene_;
  Balls& balls_;
  bool& lead_out_;
  Workspace& workspace_;
  std::vector<Event>& events_;
  std::vector<std::uint8_t>& gone_;
  Forecast& forecast_;
  const BroadPhase broad_phase_;
  const bool forecast_wanted_;
  bool any_gone_ = false;  ///< more than a lead that was out before
};

bool step_arithmetic_is_exact() { return arithmetic_is_exact(); }

std::span<const Event> World::step() {
  const ExactArithmetic exact;
  Workspace& kept = workspace();
  kept.events.clear();
  ++steps_;
  const bool passes = skipping_ && broad_phase_ == BroadPhase::automatic &&
                      kept.forecast.pass_quiet_step(*fixed_, balls_);
  if (!passes) Stepper(*this).take(1, false);
  return kept.events;
}

RunEnd World::run(Until until, std::uint64_t max_steps, Tell tell, void* sink) {
  const ExactArithmetic exact;
  using Why = RunEnd::Why;
  if (until.rest && at_rest()) return {0, Why::rest};
  std::vector<Event>& events = workspace().events;
  std::uint64_t taken = 0;
  while (taken < max_steps) {
    events.clear();
    const Stepper::Taken part = Stepper(*this).take(max_steps - taken, until.rest);
    taken += part.steps;
    steps_ += part.steps;
    if (tell != nullptr && !events.empty()) tell(sink, steps_, events);
    const auto wanted = [&](const Event& event) { return until.events.has(event.kind); };
    if (std::ranges::any_of(events, wanted)) return {taken, Why::event};
    if (part.rests) return {taken, Why::rest};
  }
  return {taken, Why::steps};
}

}  // namespace carom
