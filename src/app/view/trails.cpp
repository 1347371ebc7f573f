#include "app/view/trails.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace app {
namespace {

// px/s: no trail yet, and the strongest.
constexpr double slow = 250;
constexpr double fast = 1200;
constexpr float strongest = 0.7f;  ///< opacity, at the ball

struct Stage {
  Point at;
  float left;  ///< how much of the trail is still to come, from 1 at the ball to 0
};

/// A band along `way`, from a ball of `radius` at its front to nothing at its end.
void draw_trail(DrawList& list, const std::vector<Stage>& way, float radius, Color color,
                float opacity) {
  std::int32_t before = -1;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const auto [at, left] = way[i];
    const Point along = way[i > 0 ? i - 1 : 0].at - way[std::min(i + 1, way.size() - 1)].at;
    const Point out = turned(unit(along)) * (radius * (0.25f + 0.65f * left));
    const auto first = list.add(at + out, faded(color, 0));
    list.add(at, faded(color, opacity * left * std::sqrt(left)));
    list.add(at - out, faded(color, 0));
    if (before >= 0) {
      list.quad(before, before + 1, first + 1, first);
      list.quad(before + 1, before + 2, first + 2, first + 1);
    }
    before = first;
  }
}

}  // namespace

void draw_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                 const Interpolator& motion, double fraction,
                 const std::function<Color(const carom::Ball&)>& color_of) {
  std::vector<Stage> way;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!world.in_play(i)) continue;
    const carom::Ball ball = world.ball(i);
    const auto past = motion.past(ball.id);
    const double speed = carom::length(ball.velocity);
    if (past.size() < 2 || speed <= slow) continue;
    // The end follows as the ball goes on: the trail is as long between two steps as after them.
    const std::size_t end = past.size() - 1;
    const auto left = [&](double steps_ago) {
      return static_cast<float>(std::max(1 - steps_ago / static_cast<double>(end), 0.0));
    };
    way.clear();
    way.push_back({viewport.to_window(motion.position(world, i, fraction)), 1});
    for (std::size_t k = 0; k < end; ++k)
      way.push_back({viewport.to_window(past[k]), left(fraction + static_cast<double>(k))});
    way.push_back({viewport.to_window(past[end] + fraction * (past[end - 1] - past[end])), 0});
    const auto strength = static_cast<float>(std::min((speed - slow) / (fast - slow), 1.0));
    draw_trail(list, way, viewport.px(ball.radius), color_of(ball), strongest * strength);
  }
}

}  // namespace app
