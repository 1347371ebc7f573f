#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "carom/internal/time_scale.hpp"
#include "carom/region.hpp"
#include "carom/scene.hpp"

namespace carom {

/// A large part of the play area in which no ball's centre is in a hole.
Box hole_free_box(const Scene& scene);

/// The first holes rounded, for choosing; empty places are far away.
struct RoundedHoles {
  explicit RoundedHoles(const Scene& scene);

  static constexpr std::size_t most = 32;
  std::array<float, most + 8> x, y, radius;
};

/// The parts of a world that do not change; its copies share them.
struct FixedParts {
  FixedParts(Scene of, double whole)
      : scene(std::move(of)),
        scale(scene),
        hole_free(hole_free_box(scene)),
        holes(scene),
        lead_solidity(whole) {}

  Scene scene;  ///< without balls
  TimeScale scale;
  Box hole_free;
  RoundedHoles holes;
  double lead_solidity;  ///< of ball 0 at the start
};

}  // namespace carom
