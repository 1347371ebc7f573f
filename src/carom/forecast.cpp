#include "carom/internal/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/internal/kernels.hpp"
#include "carom/internal/pair.hpp"
#include "carom/world.hpp"

namespace carom {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double always = -1;  // the clock starts at 0
constexpr float far_away = 1e8F;
constexpr int for_ever = std::numeric_limits<int>::max() / 2;
// The bounds of this file are computed with some roundings; this is far more than these.
constexpr double hair = 1e-9;

bool solid(Edge edge) { return edge == Edge::solid; }

}  // namespace

void Forecast::begin(const FixedParts& fixed, const Balls& balls, bool lead_out, bool events) {
  if (pause_left_ > 0) {
    --pause_left_;
    return;
  }
  size_ = balls.size();
  in_play_ = size_ == 0 ? 0 : ~BallMask{0} >> (64 - size_);
  if (lead_out) in_play_ &= ~bit(0);
  active_ = 0;
  parts_until_ = 0;
  for (std::size_t i = size_; i < padded && i < size_ + lanes; ++i) blank(i);
  const auto& holes = fixed.scene.holes;
  if (!holes.empty()) {
    hole_x_.fill(far_away);
    hole_y_.fill(far_away);
    hole_radius_.fill(0);
    for (std::size_t n = 0; n < holes.size(); ++n) {
      hole_x_[n] = static_cast<float>(holes[n].position.x);
      hole_y_[n] = static_cast<float>(holes[n].position.y);
      hole_radius_[n] = static_cast<float>(holes[n].radius);
    }
  }
  least_radius_ = never;
  for (std::size_t i = 0; i < size_; ++i) {
    least_radius_ = std::min(least_radius_, balls.radius[i]);
    radius_[i] = static_cast<float>(balls.radius[i]);
    due_[i] = never;
  }
  begun_ = true;
  moving_ = hot_ = held_ = 0;
  if (events)  // any ball may have been put where others are
    moving_ = hot_ = in_play_;
  else
    for_each_ball(in_play_, [&](std::size_t i) { classify(fixed, balls, i); });
  begin_clock(fixed, balls);
}

void Forecast::begin_clock(const FixedParts& fixed, const Balls& balls) {
  step_ = 0;
  quiet_until_ = -1;
  parts_until_ = 0;
  busy_until_ = 0;
  now_ = 0;
  unit_ = 1;
  extent_ = 0;
  fails_ = false;
  double extent = 0;
  for (const Hole& hole : fixed.scene.holes)
    extent = std::max(extent, std::abs(hole.position.x) + std::abs(hole.position.y) + hole.radius);
  widen(std::max(extent, fixed.scene.width + fixed.scene.height));
  for_each_ball(in_play_, [&](std::size_t i) { note(fixed, balls, i); });
  if (fails_) return give_up();
  pack(balls);
  for_each_ball(in_play_, [&](std::size_t i) { predict(fixed, balls, i); });
  if (fixed.scene.gravity > 0) wake(moving_);
}

// Beyond this the margins would be no longer small beside the balls.
void Forecast::widen(double extent) {
  extent_ = extent;
  margin_ = extent * 0x1p-32 + extent * extent * 0x1p-48 / least_radius_;
  slack_ = static_cast<float>(extent * 0x1p-18 + margin_);
  if (!(margin_ < least_radius_ * 0x1p-10) || extent > max_quantity) {
    fails_ = true;
  }
}

void Forecast::give_up() {
  begun_ = false;
  pause_left_ = 64;
}

void Forecast::classify(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  const bool stands = balls.vx[i] == 0 && balls.vy[i] == 0;
  const bool no_force = balls.ax[i] == 0 && balls.ay[i] == 0;
  const double gravity = fixed.scene.gravity;
  const BallMask one = bit(i);
  moving_ &= ~one, hot_ &= ~one, held_ &= ~one;
  if (!(stands && no_force)) moving_ |= one;
  if (no_force) {
    if (gravity > 0) held_ |= one;
  } else if (!(gravity > 0 && balls.ax[i] == 0 && balls.ay[i] == -gravity)) {
    hot_ |= one;
  }
}

// Takes in a ball's new motion, before any ball is predicted.
void Forecast::note(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  vx_[i] = static_cast<float>(balls.vx[i]);
  vy_[i] = static_cast<float>(balls.vy[i]);
  const double gravity = fixed.scene.gravity;
  const double horizon = fixed.scale.horizon;
  const double reached = std::abs(balls.x[i]) + std::abs(balls.y[i]) + balls.radius[i] +
                         (std::abs(balls.vx[i]) + std::abs(balls.vy[i])) * horizon +
                         gravity * horizon * horizon;
  if (!(reached <= extent_)) widen(2 * reached);
  if (witness_ == i) busy_until_ = 0;
  if (parts_until_ > 0) {
    if (parts_ == 1)
      parts_until_ = std::min(parts_until_, one_part_until(fixed, balls, i));
    else
      parts_until_ = 0;
  }
}

// The last step before which the ball surely needs no second part.
int Forecast::one_part_until(const FixedParts& fixed, const Balls& balls, std::size_t i) const {
  const double radius = balls.radius[i] * (1 - hair);
  const double speed = length(balls.velocity(i));
  const double room = radius / time_step - speed;
  if (!(room > 0)) return 0;
  if (fixed.scene.gravity == 0) return for_ever;
  const double steps = room / (fixed.scene.gravity * time_step);
  return steps < for_ever / 2 ? step_ + static_cast<int>(steps) : for_ever;
}

void Forecast::predict(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  if ((hot_ & bit(i)) != 0)
    due_[i] = always;
  else
    due_[i] = now_ +
              (fixed.scale.straight ? straight(fixed, balls, i) : bounded(fixed, balls, i)) * unit_;
}

// s, at the velocity that the ball has now, until it may meet something.
double Forecast::straight(const FixedParts& fixed, const Balls& balls, std::size_t i) const {
  const Scene& scene = fixed.scene;
  const double x = balls.x[i];
  const double y = balls.y[i];
  const double u = balls.vx[i];
  const double v = balls.vy[i];
  const double radius = balls.radius[i];
  const bool moves = (moving_ & bit(i)) != 0;
  double soonest = never;
  // Until a disc with this relative motion may be nearer than `reach`.
  const auto until_near = [&](double dx, double dy, double du, double dv, double reach) {
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
  const Kernels::Disc one{x_[i], y_[i], vx_[i], vy_[i], radius_[i] + slack_};
  const Kernels::Discs others{x_.data(), y_.data(), vx_.data(), vy_.data(), radius_.data(), size_};
  for_each_ball(k.may_meet(others, one) & in_play_ & ~hot_ & ~bit(i), [&](std::size_t j) {
    until_near(balls.x[j] - x, balls.y[j] - y, balls.vx[j] - u, balls.vy[j] - v,
               radius + balls.radius[j]);
  });
  if (!moves) return soonest;

  const auto until = [&](double room, double speed) {
    soonest = std::min(soonest, (room - margin_) / speed);
  };
  const Edges& edges = scene.edges;
  if (u < 0) until(solid(edges.left) ? x - radius : x + radius, -u);
  if (u > 0) until(solid(edges.right) ? scene.width - radius - x : scene.width + radius - x, u);
  if (v < 0 && solid(edges.bottom)) until(y - radius, -v);
  if (v > 0 && solid(edges.top)) until(scene.height - radius - y, v);
  if (!scene.holes.empty()) {
    Kernels::Disc centre = one;
    centre.radius = slack_;
    const Kernels::Discs discs{hole_x_.data(), hole_y_.data(),      nullptr,
                               nullptr,        hole_radius_.data(), scene.holes.size()};
    for_each_ball(k.may_meet(discs, centre), [&](std::size_t n) {
      if (n >= scene.holes.size()) return;
      const Hole& hole = scene.holes[n];
      until_near(hole.position.x - x, hole.position.y - y, -u, -v, hole.radius);
    });
  }
  return std::max(soonest, always);
}

// Steps until the ball may meet something, or what supports it may change. Its way differs from
// the straight line of its velocity by at most g·t²/2.
double Forecast::bounded(const FixedParts& fixed, const Balls& balls, std::size_t i) const {
  const Scene& scene = fixed.scene;
  const BallMask one = bit(i);
  if ((moving_ & one) == 0) return never;  // whatever comes near is predicted, too
  const double gravity = scene.gravity;
  const double x = balls.x[i];
  const double y = balls.y[i];
  const double u = balls.vx[i];
  const double v = balls.vy[i];
  const double radius = balls.radius[i];
  const bool held = (held_ & one) != 0;
  const double fall = gravity * (time_step * time_step / 2 * (1 + hair));
  double most = never;
  // The steps m with m·way + m²·astray ≤ room.
  const auto within = [&](double room, double way, double astray) {
    room -= margin_;
    if (!(room > 0))
      most = 0;
    else if (way != 0 || astray != 0)
      most = std::min(most, 2 * room / (way + std::sqrt(way * way + 4 * astray * room)));
  };
  const auto along = [&](double speed) { return std::abs(speed) * (time_step * (1 + hair)); };

  const Edges& edges = scene.edges;
  if (u < 0) within(solid(edges.left) ? x - radius : x + radius, along(u), 0);
  if (u > 0)
    within(solid(edges.right) ? scene.width - radius - x : scene.width + radius - x, along(u), 0);
  const double lies_below = separation_factor * radius;
  if (held) {
    // A ball that rolls on anything but the floor has that near it.
    if (v < 0 && solid(edges.bottom)) within(y - radius, along(v), 0);
    if (v > 0) within(lies_below - y, along(v), 0);
  } else {
    if (solid(edges.bottom))
      within(y - (gravity > 0 ? lies_below : radius), v < 0 ? along(v) : 0, fall);
    if (v > 0 && solid(edges.top)) within(scene.height - radius - y, along(v), 0);
  }
  const double own = held ? 0 : fall;
  const double speed = std::sqrt(u * u + v * v);
  const double reach = gravity > 0 ? touching_factor * (1 + hair) : 1;
  for (std::size_t n = 0; n < scene.holes.size() && most > 0; ++n) {
    const Vec2 d = balls.position(i) - scene.holes[n].position;
    within(length(d) - scene.holes[n].radius, dot(d, balls.velocity(i)) >= 0 ? 0 : along(speed),
           own);
  }
  for (std::size_t n = 0; n < scene.obstacles.size() && most > 0; ++n) {
    const Obstacle& obstacle = scene.obstacles[n];
    const double w = reach * (obstacle.radius + radius);
    const double dx = x - obstacle.x;
    if (y < obstacle.height) {
      within(std::abs(dx) - w, dx * u >= 0 ? 0 : along(u), 0);
    } else {
      // What is above the wall's top is no nearer to the wall than to the cap.
      const double dy = y - obstacle.height;
      within(std::sqrt(dx * dx + dy * dy) - w, u * dx + v * dy >= 0 ? 0 : along(speed), own);
    }
  }
  for_each_ball(in_play_ & ~hot_ & ~one, [&](std::size_t j) {
    if (!(most > 0)) return;
    const double dx = x - balls.x[j];
    const double dy = y - balls.y[j];
    const double du = u - balls.vx[j];
    const double dv = v - balls.vy[j];
    const bool other_held = (held_ & bit(j)) != 0 || gravity == 0;
    const double astray = other_held == (held || gravity == 0) ? 0 : fall;
    const double distance = std::sqrt(dx * dx + dy * dy);
    within(distance - reach * (radius + balls.radius[j]),
           du * dx + dv * dy >= 0 ? 0 : along(std::sqrt(du * du + dv * dv)), astray);
  });
  return most > 0 ? most : always;
}

std::uint64_t Forecast::pass_quiet_steps(const FixedParts& fixed, Balls& balls,
                                         std::uint64_t most) {
  const auto limit = static_cast<int>(std::min<std::uint64_t>(most, TimeScale::most_steps));
  const int steps = quiet_steps(fixed, balls, limit);
  if (steps > 0) advance(fixed, balls, steps);
  return static_cast<std::uint64_t>(steps);
}

int Forecast::quiet_steps(const FixedParts& fixed, const Balls& balls, int most) {
  const TimeScale& scale = fixed.scale;
  if (step_ >= scale.steps) {
    begin_clock(fixed, balls);
    if (!begun_) return 0;
  }
  if (quiet_until_ < step_) {
    double first = never;
    for (std::size_t i = 0; i < size_; ++i) first = std::min(first, due_[i]);
    // at(quiet_until_) < first ≤ at(end)
    int end = step_ + 1;
    quiet_until_ = step_;
    while (end <= scale.steps && scale.at(end) < first) {
      quiet_until_ = end;
      end += 1 + end - step_;
    }
    end = std::min(end, scale.steps + 1);
    while (end - quiet_until_ > 1) {
      const int middle = (quiet_until_ + end) / 2;
      (scale.at(middle) < first ? quiet_until_ : end) = middle;
    }
  }
  if (quiet_until_ == step_) return 0;
  if (step_ >= parts_until_) choose_parts(fixed, balls);
  return std::min({most, quiet_until_ - step_, parts_until_ - step_});
}

// The same number of parts as Stepper::sub_steps gives.
void Forecast::choose_parts(const FixedParts& fixed, const Balls& balls) {
  int until = for_ever;
  for_each_ball(moving_,
                [&](std::size_t i) { until = std::min(until, one_part_until(fixed, balls, i)); });
  parts_ = 1;
  parts_until_ = until;
  if (until > step_) return;
  double most = 1;
  for_each_ball(moving_, [&](std::size_t i) {
    most = std::max(most, length(balls.velocity(i)) * time_step / balls.radius[i]);
  });
  parts_until_ = step_ + 1;
  if (most >= max_sub_steps) {
    parts_ = max_sub_steps;
    return;
  }
  const int whole = static_cast<int>(most);
  parts_ = whole < most ? whole + 1 : whole;
  if (fixed.scene.gravity > 0 || parts_ == 1) return;
  // All get slower in proportion.
  const auto power = [&](int m) { return fixed.scale.power[static_cast<std::size_t>(m)]; };
  const double fewer = (parts_ - 1) * power(step_) * (1 + hair);
  int end = fixed.scale.steps;
  while (end - parts_until_ > 0) {
    const int middle = (parts_until_ + end) / 2;
    if (most * power(middle) > fewer)
      parts_until_ = middle + 1;
    else
      end = middle;
  }
}

void Forecast::advance(const FixedParts& fixed, Balls& balls, int steps) {
  const bool lead_is_out = size_ > 0 && (in_play_ & bit(0)) == 0;
  const Ball lead = lead_is_out ? balls[0] : Ball();
  kernels().advance({.x = balls.x.data(),
                     .y = balls.y.data(),
                     .vx = balls.vx.data(),
                     .vy = balls.vy.data(),
                     .ay = fixed.scene.gravity > 0 ? balls.ay.data() : nullptr,
                     .moving = moving_,
                     .count = size_,
                     .friction = fixed.scene.friction,
                     .part = time_step / parts_,
                     .parts = parts_,
                     .steps = steps});
  if (lead_is_out) {  // it may share a vector with balls that move
    balls.set_position(0, lead.position);
    balls.set_velocity(0, lead.velocity);
  }
  earn(steps);
}

// What touches one of these balls may lose its support with its next move.
void Forecast::wake(BallMask moving) {
  for_each_ball(moving, [&](std::size_t i) {
    for_each_ball(near(i), [&](std::size_t j) { due_[j] = always; });
  });
}

bool Forecast::pass_quiet_step(const FixedParts& fixed, Balls& balls) {
  if (!begun_ || step_ >= quiet_until_ || step_ >= parts_until_) return false;
  constexpr int few = 4;
  if (parts_ > 1 || std::popcount(moving_) > few) {
    advance(fixed, balls, 1);
    return true;
  }
  const double f = fixed.scene.friction;
  for_each_ball(moving_, [&](std::size_t i) {
    balls.x[i] += balls.vx[i] * time_step;
    balls.y[i] += balls.vy[i] * time_step;
    balls.vx[i] = balls.vx[i] * f;
    balls.vy[i] = balls.vy[i] * f + balls.ay[i] * time_step;
  });
  earn(1);
  return true;
}

void Forecast::earn(int steps) {
  step_ += steps;
  balance_ += steps * static_cast<double>(size_);
  if (const double enough = 64 * static_cast<double>(size_); balance_ > enough) {
    balance_ = enough;
    pause_ = 64;
  }
}

bool Forecast::move(const FixedParts& fixed, Balls& balls, double part, double friction) const {
  if (hot_ != 0 || fixed.scene.gravity > 0 || (size_ > 0 && (in_play_ & bit(0)) == 0)) return false;
  kernels().advance({.x = balls.x.data(),
                     .y = balls.y.data(),
                     .vx = balls.vx.data(),
                     .vy = balls.vy.data(),
                     .ay = nullptr,
                     .moving = moving_,
                     .count = size_,
                     .friction = friction,
                     .part = part,
                     .parts = 1,
                     .steps = 1});
  return true;
}

int Forecast::parts(const FixedParts& fixed, const Balls& balls) {
  if (step_ >= parts_until_) choose_parts(fixed, balls);
  return parts_;
}

BallMask Forecast::due(const FixedParts& fixed, int part, int parts) {
  const TimeScale& scale = fixed.scale;
  const double begin = scale.at(step_);
  const double end = scale.at(step_ + 1);
  const bool last = part == parts;
  now_ = last ? end : begin + (end - begin) * part / parts;
  unit_ = scale.unit(last ? step_ + 1 : step_);
  if (!scale.straight) unit_ = 1;
  BallMask due = 0;
  for (std::size_t i = 0; i < size_; ++i) due |= static_cast<BallMask>(due_[i] <= now_) << i;
  active_ = 0;
  return due;
}

void Forecast::settle(const FixedParts& fixed, Balls& balls, BallMask unsettled) {
  // Stage 1 let all fall.
  for_each_ball(held_ & ~active_, [&](std::size_t i) { balls.ay[i] = 0; });
  const BallMask active = active_ & in_play_;
  if (active == 0) return;
  for_each_ball(active, [&](std::size_t i) {
    classify(fixed, balls, i);
    pack(balls, i);
  });
  // What supports them may be another thing in the next step.
  if (!fixed.scale.straight) hot_ |= active & unsettled, moving_ |= active & unsettled;
  for_each_ball(active, [&](std::size_t i) { note(fixed, balls, i); });
  for_each_ball(active, [&](std::size_t i) { predict(fixed, balls, i); });
  if (fixed.scene.gravity > 0) wake(active & moving_);
  quiet_until_ = -1;
  balance_ -= 4.0 * std::popcount(active);
}

void Forecast::end_step(const FixedParts& fixed, Balls& balls, int part, int parts) {
  ++step_;
  balance_ += 0.7 * static_cast<double>(size_);
  if (fails_) return give_up();
  if (part < parts) begin_clock(fixed, balls);  // the rest of the step was dropped
  if (balance_ < -64.0 * static_cast<double>(size_) - 64) {
    begun_ = false;
    balance_ = 0;
    pause_left_ = pause_;
    pause_ = std::min(2 * pause_, 1024);
  }
}

void Forecast::swap_out(std::size_t i) {
  const std::size_t last = size_ - 1;
  for (BallMask* mask : {&in_play_, &moving_, &hot_, &held_, &active_}) {
    const bool set = (*mask & bit(last)) != 0;
    *mask &= ~(bit(last) | bit(i));
    if (set && i != last) *mask |= bit(i);
  }
  due_[i] = due_[last];
  for (Floats* floats : {&x_, &y_, &vx_, &vy_, &radius_}) (*floats)[i] = (*floats)[last];
  blank(last);
  --size_;
  busy_until_ = 0;
  parts_until_ = 0;
  quiet_until_ = -1;
}

// No ball there.
void Forecast::blank(std::size_t i) {
  due_[i] = never;
  x_[i] = y_[i] = far_away;
  vx_[i] = vy_[i] = radius_[i] = 0;
}

void Forecast::lead_went_out() {
  for (BallMask* mask : {&in_play_, &moving_, &hot_, &held_, &active_}) *mask &= ~bit(0);
  due_[0] = never;
  busy_until_ = 0;
  parts_until_ = 0;
  quiet_until_ = -1;
}

// The fastest ball gets slower by friction and gravity, in each step by no more than in this one.
bool Forecast::is_busy(const FixedParts& fixed, const Balls& balls) {
  double most = 0;
  for_each_ball(moving_, [&](std::size_t i) {
    const double squared = length_squared(balls.velocity(i));
    if (squared > most) {
      most = squared;
      witness_ = i;
    }
  });
  busy_until_ = step_ + 1;
  constexpr double surely_fast = rest_speed * rest_speed * (1 + hair);
  if (!(most > surely_fast)) return false;
  const double speed = std::sqrt(most) * (1 - hair);
  const double loss = fixed.scene.gravity * time_step + (1 - fixed.scene.friction) * speed;
  const double steps = (speed - rest_speed) / (loss * (1 + hair));
  if (steps > 1)
    busy_until_ = steps < TimeScale::most_steps ? step_ + static_cast<int>(steps) : for_ever;
  return true;
}

void Forecast::pack(const Balls& balls) {
  const Kernels& k = kernels();
  k.to_floats(balls.x.data(), x_.data(), size_);
  k.to_floats(balls.y.data(), y_.data(), size_);
  k.to_floats(balls.vx.data(), vx_.data(), size_);
  k.to_floats(balls.vy.data(), vy_.data(), size_);
}

BallMask Forecast::near(std::size_t i) const {
  // A hair more than the touching factor, since it is a float.
  constexpr float factor = 1.0201F;
  const Kernels::Disc one{x_[i], y_[i], 0, 0, radius_[i]};
  const Kernels::Discs others{x_.data(), y_.data(), nullptr, nullptr, radius_.data(), size_};
  return kernels().within(others, one, factor, slack_) & in_play_ & ~bit(i);
}

}  // namespace carom
