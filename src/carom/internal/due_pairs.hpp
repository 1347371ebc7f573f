#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "carom/balls.hpp"
#include "carom/internal/forecast.hpp"
#include "carom/internal/pair.hpp"

namespace carom {

/// The broad phase of a step in which a Forecast says which balls are due: no pair of others
/// overlaps. The answers of AllPairs, with a bit a ball.
///
/// The due balls are looked up, and so is each ball that a collision moves: so at any time the rows
/// below hold all overlaps there are, and the next pair in order is the next bit.
///
/// Balls are active that are due or were moved; under gravity, also those that touch one of these.
/// Only active balls need the stages that follow the pairs.
class DuePairs {
 public:
  DuePairs(const Balls& balls, const std::vector<std::uint8_t>& gone, Forecast& forecast,
           const Forecast::Due& due, bool gravity)
      : balls_(balls), gone_(gone), forecast_(forecast), active_(due.balls), gravity_(gravity) {
    for_each_ball(due.pairs, [&](std::size_t i) { look(i); });
  }

  std::optional<Pair> next_overlap(Pair after) {
    look_after_moved();
    std::size_t i = after.first;
    BallMask later = ~BallMask{1} << after.second;
    for (;;) {
      const BallMask row = rows_ >> i & 1 ? overlaps_[i] & later : 0;
      for (BallMask rest = row; rest != 0; rest &= rest - 1) {
        const auto j = static_cast<std::size_t>(std::countr_zero(rest));
        if (gone_[i] == 0 && gone_[j] == 0) return Pair{i, j};
      }
      const BallMask next = rows_ & (~BallMask{1} << i);
      if (next == 0) return std::nullopt;
      i = static_cast<std::size_t>(std::countr_zero(next));
      later = ~BallMask{1} << i;
    }
  }

  std::optional<std::size_t> touching_both(Pair pair) {
    for (BallMask near = forecast_.near(pair.first) & ~bit(pair.second); near != 0;
         near &= near - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(near));
      if (gone_[k] != 0 || !touch(balls_, k, pair.first) || !touch(balls_, k, pair.second))
        continue;
      // Its velocity changes, even where its position does not.
      active_ |= bit(k);
      struck_ |= bit(k);
      return k;
    }
    return std::nullopt;
  }

  void moved(std::size_t i) {
    moved_ |= bit(i);
    put_ |= bit(i);
    struck_ |= bit(i);
    active_ |= bit(i);
  }

  /// To be called after stage 2: which balls are active from now on.
  void choose_active() {
    pack_moved();
    if (gravity_) {
      const BallMask centre = active_;
      for_each_ball(centre, [&](std::size_t i) { active_ |= forecast_.near(i); });
    }
    forecast_.set_active(active_);
  }
  BallMask active() const { return active_; }
  /// Those that were moved.
  BallMask put() const { return put_; }
  /// Those that were moved or met another ball.
  BallMask struck() const { return struck_; }

  template <class Visit>
  void for_each_touching(Visit visit) const {
    for_each_ball(active_, [&](std::size_t i) {
      if (gone_[i] != 0) return;
      for_each_ball(forecast_.near(i), [&](std::size_t k) {
        const bool below = balls_.y[k] < balls_.y[i] || (balls_.y[k] == balls_.y[i] && k < i);
        if (below && gone_[k] == 0 && touch(balls_, i, k)) visit(k < i ? Pair{k, i} : Pair{i, k});
      });
    });
  }

  template <class Visit>
  void for_each_in_box(Vec2, Vec2, Visit visit) const {
    for_each_ball(active_, visit);
  }

 private:
  void pack_moved() {
    for_each_ball(moved_, [&](std::size_t i) { forecast_.pack(balls_, i); });
    moved_ = 0;
  }

  void look_after_moved() {
    const BallMask moved = moved_;
    if (moved == 0) return;
    pack_moved();
    for_each_ball(moved, [&](std::size_t i) { look(i); });
  }

  // Enters what ball i overlaps now into the rows.
  void look(std::size_t i) {
    BallMask now = forecast_.near(i);
    for_each_ball(now, [&](std::size_t j) {
      if (!overlap(balls_, i, j)) now &= ~bit(j);
    });
    const BallMask before = (rows_ & bit(i)) != 0 ? overlaps_[i] : 0;
    if ((now | before) == 0) return;
    rows_ |= bit(i);
    overlaps_[i] = now;
    for_each_ball(now ^ before, [&](std::size_t j) {
      if ((rows_ & bit(j)) == 0) overlaps_[j] = 0;
      rows_ |= bit(j);
      overlaps_[j] ^= bit(i);
    });
  }

  const Balls& balls_;
  const std::vector<std::uint8_t>& gone_;
  Forecast& forecast_;
  BallMask active_;
  bool gravity_;
  BallMask moved_ = 0;  ///< since the last look
  BallMask put_ = 0;    ///< since stage 1
  BallMask struck_ = 0;
  BallMask rows_ = 0;  ///< those of the next that mean something
  std::array<BallMask, Forecast::max_balls> overlaps_;
};

}  // namespace carom
