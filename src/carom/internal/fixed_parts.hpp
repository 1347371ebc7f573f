#pragma once

#include <utility>

#include "carom/internal/time_scale.hpp"
#include "carom/scene.hpp"

namespace carom {

struct Box {
  Vec2 low;
  Vec2 high;
};

/// A large part of the play area in which no ball's centre is in a hole.
Box hole_free_box(const Scene& scene);

/// What does not change in a world; its copies share it.
struct FixedParts {
  explicit FixedParts(Scene of)
      : scene(std::move(of)), scale(scene), hole_free(hole_free_box(scene)) {}

  Scene scene;  ///< without balls
  TimeScale scale;
  Box hole_free;
};

}  // namespace carom
