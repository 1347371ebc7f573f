#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "carom/balls.hpp"
#include "carom/internal/vectors.hpp"
#include "carom/vec2.hpp"

namespace carom {

/// An index of a few balls for RowPairs: compares every two, eight at a time, by coordinates packed
/// into 16 bits. For a table of billiards that takes less time than any sorting.
///
/// A coordinate is a whole number of units; how far two balls are from each other is judged by
/// their bounding boxes, enlarged by what the rounding can take away. What lies outside the range
/// of 16 bits is moved to its border, which brings balls nearer to each other, never apart.
class PackedIndex {
 public:
  /// Above, the quadtree is quicker (docs/performance.md).
  static constexpr std::size_t max_balls = 48;

  void build(const Balls& balls) {
    balls_ = &balls;
    const bool as_before = size_ == balls.size();
    size_ = balls.size();
    const bool new_units = builds_until_units_-- == 0;
    if (new_units) choose_units();
    // Loops that the compiler can make take several balls at a time.
    pack_all(balls.x.data(), middle_.x, x_.data());
    pack_all(balls.y.data(), middle_.y, y_.data());
    // Which ball has which radius changes only when one is removed.
    if (!as_before || new_units) {
      for (std::size_t i = 0; i < size_; ++i) reach_[i] = reach(balls.radius[i]);
      // Nothing is near what fills the last eight up.
      for (std::size_t i = size_; i < size_ + 8; ++i) reach_[i] = -4 * far;
    }
  }

  void moved(std::size_t i) { pack(i); }

  template <class Hit>
  void pairs(Hit hit) const {
    for (std::size_t i = 0; i + 1 < size_; ++i) {
      const Short8 x = splat8(x_[i]);
      const Short8 y = splat8(y_[i]);
      const Short8 reach = splat8(reach_[i]);
      for (std::size_t j = i + 1; j < size_; j += 8) {
        for_each_bit(hits(j, x, y, reach), [&](std::uint32_t lane) {
          hit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j) + lane);
        });
      }
    }
  }

  template <class Hit>
  void near(double x, double y, double own, float factor, Hit hit) const {
    const Short8 x8 = splat8(coordinate(x - middle_.x));
    const Short8 y8 = splat8(coordinate(y - middle_.y));
    const Short8 reach8 = splat8(reach(own + (static_cast<double>(factor) - 1) * largest_));
    for (std::size_t j = 0; j < size_; j += 8)
      for_each_bit(hits(j, x8, y8, reach8),
                   [&](std::uint32_t lane) { hit(static_cast<std::uint32_t>(j) + lane); });
  }

  bool any_near(double x, double y, double own, std::uint32_t a, std::uint32_t b) const {
    bool any = false;
    near(x, y, own, 1, [&](std::uint32_t i) { any |= i != a && i != b; });
    return any;
  }

  bool any_near_both(std::uint32_t i, std::uint32_t j, float factor) const {
    const auto more = static_cast<double>(factor) - 1;
    const auto reach8 = [&](std::uint32_t k) {
      return splat8(reach(balls_->radius[k] * (1 + more) + more * largest_));
    };
    const Short8 reach_i = reach8(i);
    const Short8 reach_j = reach8(j);
    bool any = false;
    for (std::size_t k = 0; k < size_; k += 8)
      for_each_bit(hits(k, splat8(x_[i]), splat8(y_[i]), reach_i) &
                       hits(k, splat8(x_[j]), splat8(y_[j]), reach_j),
                   [&](std::uint32_t lane) {
                     const std::uint32_t third = static_cast<std::uint32_t>(k) + lane;
                     any |= third != i && third != j;
                   });
    return any;
  }

  template <class Hit>
  void box(Vec2 low, Vec2 high, double factor, Hit hit) const {
    const double more = (factor - 1) * largest_ + 1 / units_per_px_;
    const Short8 left = splat8(coordinate(low.x - more - middle_.x));
    const Short8 right = splat8(coordinate(high.x + more - middle_.x));
    const Short8 bottom = splat8(coordinate(low.y - more - middle_.y));
    const Short8 top = splat8(coordinate(high.y + more - middle_.y));
    for (std::size_t j = 0; j < size_; j += 8) {
      const Short8 x = load8(&x_[j]);
      const Short8 y = load8(&y_[j]);
      const Short8 reach = load8(&reach_[j]);
      const Short8 miss =
          (x + reach < left) | (x - reach > right) | (y + reach < bottom) | (y - reach > top);
      for_each_bit(~bits(miss) & 0xffU,
                   [&](std::uint32_t lane) { hit(static_cast<std::uint32_t>(j) + lane); });
    }
  }

 private:
  // The largest coordinate, in units: four times this fits into 16 bits.
  static constexpr std::int16_t far = 8000;
  static constexpr int builds_per_units = 64;

  // Units that spread the balls over 16 bits. Those chosen earlier would do, too: the coarser they
  // are, the more is found in vain.
  void choose_units() {
    builds_until_units_ = builds_per_units;
    double left = 0, right = 0, bottom = 0, top = 0;
    largest_ = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec2 position = balls_->position(i);
      left = i == 0 ? position.x : std::min(left, position.x);
      right = i == 0 ? position.x : std::max(right, position.x);
      bottom = i == 0 ? position.y : std::min(bottom, position.y);
      top = i == 0 ? position.y : std::max(top, position.y);
      largest_ = std::max(largest_, balls_->radius[i]);
    }
    middle_ = {left / 2 + right / 2, bottom / 2 + top / 2};
    const double spread = std::max(right / 2 - left / 2, top / 2 - bottom / 2) + largest_;
    units_per_px_ = far / (1.5 * spread);
  }

  static double bounded(double units) {
    const double not_less = units > -far ? units : -far;
    return not_less < far ? not_less : far;
  }
  // Less than a unit nearer to the middle than it is.
  std::int16_t coordinate(double px) const {
    return static_cast<std::int16_t>(bounded(px * units_per_px_));
  }
  // More than a unit longer than it is, so that two reaches make up for two coordinates.
  std::int16_t reach(double px) const {
    const double units = px * units_per_px_;
    return units < far ? static_cast<std::int16_t>(units + 2) : std::int16_t{2 * far + 2};
  }

  void pack(std::size_t i) {
    x_[i] = coordinate(balls_->x[i] - middle_.x);
    y_[i] = coordinate(balls_->y[i] - middle_.y);
  }

  void pack_all(const double* __restrict px, double middle, std::int16_t* __restrict packed) const {
    const double units = units_per_px_;
    for (std::size_t i = 0; i < size_; ++i)
      packed[i] =
          static_cast<std::int16_t>(static_cast<std::int32_t>(bounded((px[i] - middle) * units)));
  }

  /// Which of the eight balls from j on, as bits, are that near.
  [[gnu::always_inline]] unsigned hits(std::size_t j, Short8 x, Short8 y, Short8 reach) const {
    const Short8 dx = load8(&x_[j]) - x;
    const Short8 dy = load8(&y_[j]) - y;
    const Short8 sum = load8(&reach_[j]) + reach;
    const Short8 negative = -sum;
    return ~bits((dx > sum) | (dx < negative) | (dy > sum) | (dy < negative)) & 0xffU;
  }

  const Balls* balls_ = nullptr;
  std::size_t size_ = 0;
  int builds_until_units_ = 0;
  Vec2 middle_{};
  double units_per_px_ = 1;
  double largest_ = 0;
  std::array<std::int16_t, max_balls + 8> x_{};
  std::array<std::int16_t, max_balls + 8> y_{};
  std::array<std::int16_t, max_balls + 8> reach_{};
};

}  // namespace carom
