#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "carom/balls.hpp"
#include "carom/index_list.hpp"
#include "carom/vec2.hpp"
#include "carom/vectors.hpp"

namespace carom {

/// An index of a few balls for RowPairs: compares every two, eight at a time, by coordinates packed
/// into 16 bits. For a table of billiards that takes less time than any sorting.
///
/// A coordinate is a whole number of units; how far two balls are from each other is judged by
/// their bounding boxes, enlarged by what the rounding can take away. What lies outside the range
/// of 16 bits is moved to its border, which brings balls nearer to each other, never apart.
class PackedIndex {
 public:
  static constexpr std::size_t max_balls = 128;

  void build(const Balls& balls) {
    balls_ = &balls;
    size_ = balls.size();
    if (builds_until_units_-- == 0) choose_units();
    for (std::size_t i = 0; i < size_; ++i) pack(i);
    // Nothing is near what fills the last eight up.
    for (std::size_t i = size_; i < size_ + 8; ++i) reach_[i] = -4 * far;
  }

  void moved(std::size_t i) { pack(i); }

  template <class Hit>
  void pairs(Hit hit) const {
    for (std::size_t i = 0; i + 1 < size_; ++i) {
      const Short8 x = splat8(x_[i]);
      const Short8 y = splat8(y_[i]);
      const Short8 reach = splat8(reach_[i]);
      for (std::size_t j = i + 1; j < size_; j += 8) {
        for_each_false(misses(j, x, y, reach), [&](std::size_t lane) {
          hit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j + lane));
        });
      }
    }
  }

  void near(double x, double y, double own, float factor, IndexList& found) const {
    const Short8 x8 = splat8(coordinate(x - middle_.x));
    const Short8 y8 = splat8(coordinate(y - middle_.y));
    const Short8 reach8 = splat8(reach(own + (static_cast<double>(factor) - 1) * largest_));
    for (std::size_t j = 0; j < size_; j += 8)
      for_each_false(misses(j, x8, y8, reach8),
                     [&](std::size_t lane) { found.append(static_cast<std::uint32_t>(j + lane)); });
  }

  void box(Vec2 low, Vec2 high, double factor, IndexList& found) const {
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
      for_each_false(miss,
                     [&](std::size_t lane) { found.append(static_cast<std::uint32_t>(j + lane)); });
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
    return std::min(std::max(-double{far}, units), double{far});
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
    reach_[i] = reach(balls_->radius[i]);
  }

  Short8 misses(std::size_t j, Short8 x, Short8 y, Short8 reach) const {
    const Short8 dx = load8(&x_[j]) - x;
    const Short8 dy = load8(&y_[j]) - y;
    const Short8 sum = load8(&reach_[j]) + reach;
    const Short8 negative = -sum;
    return (dx > sum) | (dx < negative) | (dy > sum) | (dy < negative);
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
