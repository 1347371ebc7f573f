#include "carom/internal/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/internal/kernels.hpp"
#include "carom/internal/pair.hpp"
#include "carom/world.hpp"

namespace carom {

namespace {

constexpr float far_away = 1e8F;
constexpr int for_ever = std::numeric_limits<int>::max() / 2;

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
  for (std::size_t i = size_; i < size_ + lanes; ++i) blank(i);
  least_radius_ = never;
  for (std::size_t i = 0; i < size_; ++i) {
    least_radius_ = std::min(least_radius_, balls.radius[i]);
    radius_[i] = static_cast<float>(balls.radius[i]);
    set_due(i, never, never, never);
  }
  begun_ = true;
  moving_ = hot_ = held_ = 0;
  if (events && !begins_anywhere(fixed))  // any ball may have been put where others are
    moving_ = hot_ = in_play_;
  else
    for_each_ball(in_play_, [&](std::size_t i) { classify(fixed, balls, i); });
  begin_clock(fixed, balls);
  if (!begun_ || !begins_anywhere(fixed)) return;
  for_each_ball(in_play_, [&](std::size_t i) {
    const bool moves = (moving_ & bit(i)) != 0;
    if (!inside(fixed, balls, i) || (!moves && !stands_clear(fixed, balls, i)))
      set_due(i, always, always, always);
  });
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
  for_each_ball(in_play_, [&](std::size_t i) { note_place(fixed, balls, i); });
  if (fails_) return give_up();
  pack(balls);
  // A ball that stands is in the predictions of those that move.
  for_each_ball(moving_, [&](std::size_t i) { predict(fixed, balls, i); });
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

bool Forecast::inside(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  const double x = balls.x[i];
  const double y = balls.y[i];
  const double radius = balls.radius[i];
  return x - radius >= 0 && x + radius <= fixed.scene.width && y - radius >= 0 &&
         y + radius <= fixed.scene.height;
}

// True if no other ball and no hole does anything to a ball that stands as long as all others
// stand.
bool Forecast::stands_clear(const FixedParts& fixed, const Balls& balls, std::size_t i) const {
  const Box& free = fixed.hole_free;
  return near(i) == 0 && balls.x[i] > free.low.x && balls.x[i] < free.high.x &&
         balls.y[i] > free.low.y && balls.y[i] < free.high.y;
}

// Takes in where a ball is now, and how fast, before any ball is predicted.
void Forecast::note_place(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  const double gravity = fixed.scene.gravity;
  const double horizon = fixed.scale.horizon;
  const double reached = std::abs(balls.x[i]) + std::abs(balls.y[i]) + balls.radius[i] +
                         (std::abs(balls.vx[i]) + std::abs(balls.vy[i])) * horizon +
                         gravity * horizon * horizon;
  if (!(reached <= extent_)) widen(2 * reached);
}

void Forecast::note_speed(const FixedParts& fixed, const Balls& balls, std::size_t i) {
  if (witness_ == i) busy_until_ = 0;
  if (parts_until_ > 0) {
    if (parts_ == 1)
      parts_until_ = std::min(parts_until_, one_part_until(fixed, balls, i));
    else
      parts_until_ = 0;
  }
}

Forecast::Ahead Forecast::look_ahead(const FixedParts& fixed, const Balls& balls,
                                     std::uint64_t most) {
  const TimeScale& scale = fixed.scale;
  if (step_ >= scale.steps) {
    begin_clock(fixed, balls);
    if (!begun_) return {};
  }
  if (quiet_until_ < step_) {
    quiet_until_ = scale.last_before(kernels().least(due_.data(), size_), step_);
    // The bounds of a curved way are below the truth: near their end, better ones are had for less
    // than a step costs.
    if (quiet_until_ == step_ && !scale.straight && hot_ == 0) {
      now_ = scale.at(step_);
      for_each_ball(in_play_, [&](std::size_t i) {
        if (due_[i] <= scale.at(step_ + 1) && due_[i] != always) predict(fixed, balls, i);
      });
      quiet_until_ = scale.last_before(kernels().least(due_.data(), size_), step_);
    }
  }
  const auto limit = static_cast<int>(std::min<std::uint64_t>(most, TimeScale::most_steps));
  const int quiet = std::min(limit, quiet_until_ - step_);
  if (quiet == 0) {
    const bool whole = step_ < parts_until_ && parts_ == 1 && hot_ == 0;
    return {.quiet = 0, .due = true, .whole = whole};
  }
  if (step_ >= parts_until_) choose_parts(fixed, balls);
  if (parts_until_ - step_ <= quiet) return {.quiet = parts_until_ - step_};
  const bool due = quiet < limit && quiet_until_ < scale.steps;
  return {.quiet = quiet, .due = due, .whole = parts_ == 1 && hot_ == 0};
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
  const double fewer = (parts_ - 1) * fixed.scale.unit(step_) * (1 + hair);
  parts_until_ = std::max(parts_until_, fixed.scale.first_slower(fewer / most, parts_until_));
}

void Forecast::advance(const FixedParts& fixed, Balls& balls, int steps) const {
  kernels().advance({.x = balls.x.data(),
                     .y = balls.y.data(),
                     .vx = balls.vx.data(),
                     .vy = balls.vy.data(),
                     .ax = fixed.scene.gravity > 0 ? balls.ax.data() : nullptr,
                     .ay = balls.ay.data(),
                     .balls = moving_,
                     .friction = fixed.scene.friction,
                     .part = time_step / parts_,
                     .parts = parts_,
                     .steps = steps});
}

// A ball that touches one of these may lose its support with its next move.
void Forecast::wake(BallMask moving) {
  for_each_ball(moving, [&](std::size_t i) {
    for_each_ball(near(i), [&](std::size_t j) { set_due(j, always, always, always); });
  });
}

bool Forecast::pass_quiet_step(const FixedParts& fixed, Balls& balls) {
  if (!begun_ || step_ >= quiet_until_ || step_ >= parts_until_) return false;
  if (parts_ == 1) {  // one by one: mostly, few move
    const double f = fixed.scene.friction;
    for_each_ball(moving_, [&](std::size_t i) {
      balls.x[i] += balls.vx[i] * time_step;
      balls.y[i] += balls.vy[i] * time_step;
      balls.vx[i] = balls.vx[i] * f;
      balls.vy[i] = balls.vy[i] * f + balls.ay[i] * time_step;
    });
  } else {
    advance(fixed, balls, 1);
  }
  pass(1);
  return true;
}

void Forecast::pass(int steps) {
  step_ += steps;
  balance_ += steps * static_cast<double>(size_);
  if (const double enough = 16 * static_cast<double>(size_); balance_ > enough) {
    balance_ = enough;
    pause_ = shortest_pause;
  }
}

// The acceleration of what is not hot stays as it is; the stages after this one begin with gravity
// alone for those that are active.
void Forecast::move(const FixedParts& fixed, Balls& balls, double part, double friction) const {
  kernels().advance({.x = balls.x.data(),
                     .y = balls.y.data(),
                     .vx = balls.vx.data(),
                     .vy = balls.vy.data(),
                     .ax = fixed.scene.gravity > 0 ? balls.ax.data() : nullptr,
                     .ay = balls.ay.data(),
                     .balls = moving_ & ~hot_,
                     .friction = friction,
                     .part = part,
                     .parts = 1,
                     .steps = 1});
  for_each_ball(hot_, [&](std::size_t i) {
    balls.set_position(i, balls.position(i) + balls.velocity(i) * part);
    balls.set_velocity(i, balls.velocity(i) * friction + balls.acceleration(i) * part);
  });
}

int Forecast::parts(const FixedParts& fixed, const Balls& balls) {
  if (step_ >= parts_until_) choose_parts(fixed, balls);
  return parts_;
}

Forecast::Due Forecast::due(const FixedParts& fixed, const Balls& balls, int part, int parts) {
  const TimeScale& scale = fixed.scale;
  const double begin = scale.at(step_);
  const double end = scale.at(step_ + 1);
  const bool last = part == parts;
  now_ = last ? end : begin + (end - begin) * part / parts;
  unit_ = scale.unit(last ? step_ + 1 : step_);
  active_ = 0;
  Due due{.balls = kernels().not_after(due_.data(), size_, now_)};
  if (due.balls == 0) return due;
  pack(balls);
  for_each_ball(due.balls, [&](std::size_t i) {
    if (pairs_due_[i] <= now_) due.pairs |= bit(i);
    if (holes_due_[i] <= now_) due.holes |= bit(i);
  });
  return due;
}

void Forecast::settle(const FixedParts& fixed, const Balls& balls, BallMask struck,
                      BallMask unsettled) {
  const BallMask active = active_ & in_play_;
  const BallMask pulled = hot_;
  for_each_ball(active, [&](std::size_t i) {
    classify(fixed, balls, i);
    note_place(fixed, balls, i);
    pack(balls, i);
  });
  // A cushion only turns a ball; under gravity, one that stood may begin to fall.
  const BallMask faster = fixed.scale.straight ? active & (struck | pulled | hot_) : active;
  for_each_ball(faster, [&](std::size_t i) { note_speed(fixed, balls, i); });
  // Their support may be another one in the next step.
  if (!fixed.scale.straight) hot_ |= active & unsettled, moving_ |= active & unsettled;
  for_each_ball(active, [&](std::size_t i) { predict(fixed, balls, i); });
  if (fixed.scene.gravity > 0) wake(active & moving_);
  quiet_until_ = -1;
  balance_ -= 5.5 * std::popcount(active);
}

void Forecast::end_step(const FixedParts& fixed, Balls& balls, int part, int parts) {
  ++step_;
  balance_ += 0.7 * static_cast<double>(size_);
  if (fails_) return give_up();
  if (part < parts) begin_clock(fixed, balls);  // the rest of the step was dropped
  if (balance_ < -12.0 * static_cast<double>(size_) - 32) {
    begun_ = false;
    balance_ = -9.0 * static_cast<double>(size_);  // the next trial ends sooner
    pause_left_ = pause_;
    pause_ = std::min(2 * pause_, 4096);
  }
}

void Forecast::swap_out(std::size_t i) {
  const std::size_t last = size_ - 1;
  for (BallMask* mask : {&in_play_, &moving_, &hot_, &held_, &active_}) {
    const bool set = (*mask & bit(last)) != 0;
    *mask &= ~(bit(last) | bit(i));
    if (set && i != last) *mask |= bit(i);
  }
  set_due(i, pairs_due_[last], holes_due_[last], due_[last]);
  for (Floats* floats : {&x_, &y_, &vx_, &vy_, &radius_}) (*floats)[i] = (*floats)[last];
  blank(last);
  --size_;
  busy_until_ = 0;
  parts_until_ = 0;
  quiet_until_ = -1;
}

// No ball there.
void Forecast::blank(std::size_t i) {
  set_due(i, never, never, never);
  x_[i] = y_[i] = far_away;
  vx_[i] = vy_[i] = radius_[i] = 0;
}

void Forecast::lead_went_out() {
  for (BallMask* mask : {&in_play_, &moving_, &hot_, &held_, &active_}) *mask &= ~bit(0);
  set_due(0, never, never, never);
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
  constexpr double surely_fast = rest_speed * rest_speed * (1 + hair);
  if (!(most > surely_fast)) return false;
  busy_until_ = step_ + 1;
  const double speed = std::sqrt(most) * (1 - hair);
  if (fixed.scale.straight) {
    const double share = rest_speed * (1 + hair) / speed * fixed.scale.unit(step_);
    busy_until_ = std::max(busy_until_, fixed.scale.first_slower(share, step_));
    return true;
  }
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
