#pragma once

#include <algorithm>
#include <cstdint>

#include "carom/balls.hpp"
#include "carom/quadtree.hpp"
#include "carom/region.hpp"

namespace carom {

/// The index behind a world's questions about places: built when one is asked after a step or a
/// change, kept until the next.
class Places {
 public:
  void forget() { known_ = false; }

  const Quadtree& of(const Balls& balls, std::uint64_t steps) {
    if (known_ && steps == steps_) return tree_;
    tree_.build(balls.x, balls.y, balls.radius);
    bounds_ = {};
    double sum = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Vec2 reach{balls.radius[i], balls.radius[i]};
      const Vec2 low = balls.position(i) - reach;
      const Vec2 high = balls.position(i) + reach;
      if (i == 0) bounds_ = {low, high};
      bounds_.low = {std::min(bounds_.low.x, low.x), std::min(bounds_.low.y, low.y)};
      bounds_.high = {std::max(bounds_.high.x, high.x), std::max(bounds_.high.y, high.y)};
      sum += balls.radius[i];
    }
    mean_radius_ = balls.size() == 0 ? 0 : sum / static_cast<double>(balls.size());
    known_ = true;
    steps_ = steps;
    return tree_;
  }

  // Of the balls that it was built for.
  const Box& bounds() const { return bounds_; }
  double mean_radius() const { return mean_radius_; }

 private:
  Quadtree tree_;
  Box bounds_;
  double mean_radius_ = 0;
  bool known_ = false;
  std::uint64_t steps_ = 0;
};

}  // namespace carom
