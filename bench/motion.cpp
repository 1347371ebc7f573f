#include "motion.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

// Over square cells that no ball is wider than: only those of neighbouring cells can overlap.
double deepest_overlap(const std::vector<carom::Ball>& balls, const carom::Scene& scene) {
  double cell = 1;
  for (const carom::Ball& ball : balls) cell = std::max(cell, 2 * ball.radius);
  const auto cells = [&](double extent) { return static_cast<std::size_t>(extent / cell) + 1; };
  const std::size_t columns = cells(scene.width);
  const std::size_t rows = cells(scene.height);
  // A ball beyond an open side counts to the last cell.
  const auto index = [&](double coordinate, std::size_t count) {
    return std::min(static_cast<std::size_t>(std::max(coordinate / cell, 0.0)), count - 1);
  };
  std::vector<std::vector<const carom::Ball*>> grid(columns * rows);
  double deepest = 0;
  for (const carom::Ball& ball : balls) {
    const std::size_t column = index(ball.position.x, columns);
    const std::size_t row = index(ball.position.y, rows);
    for (std::size_t y = row - std::min<std::size_t>(row, 1); y <= std::min(row + 1, rows - 1); ++y)
      for (std::size_t x = column - std::min<std::size_t>(column, 1);
           x <= std::min(column + 1, columns - 1); ++x)
        for (const carom::Ball* other : grid[y * columns + x])
          deepest = std::max(deepest, other->radius + ball.radius -
                                          carom::length(other->position - ball.position));
    grid[row * columns + column].push_back(&ball);
  }
  return deepest;
}

}  // namespace

Motion motion(const std::vector<carom::Ball>& balls, const carom::Scene& scene) {
  Motion result;
  const auto beyond = [](carom::Edge edge, double distance) {
    return edge == carom::Edge::solid && !(distance >= 0);
  };
  for (const carom::Ball& ball : balls) {
    result.rms_speed += carom::length_squared(ball.velocity);
    result.mean_height += ball.position.y;
    if (beyond(scene.edges.left, ball.position.x) ||
        beyond(scene.edges.right, scene.width - ball.position.x) ||
        beyond(scene.edges.bottom, ball.position.y) ||
        beyond(scene.edges.top, scene.height - ball.position.y))
      ++result.outside;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(balls.size(), 1));
  result.rms_speed = std::sqrt(result.rms_speed / count);
  result.mean_height /= count;
  // Far out, or not a number: no cell is theirs.
  if (result.outside == 0) result.deepest_overlap = deepest_overlap(balls, scene);
  return result;
}

}  // namespace bench
