#pragma once

#include <cstddef>
#include <vector>

#include "carom/scene.hpp"

namespace bench {

/// A state in a few figures, to see whether an engine moved the balls as one would expect.
struct Motion {
  double rms_speed = 0;        ///< px/s, root of the mean square
  double mean_height = 0;      ///< px above the floor
  std::size_t outside = 0;     ///< balls whose centre is beyond a solid side, or nowhere (NaN)
  double deepest_overlap = 0;  ///< px by which two balls are closer than the sum of their radii
};

Motion motion(const std::vector<carom::Ball>& balls, const carom::Scene& scene);

}  // namespace bench
