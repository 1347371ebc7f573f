#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "app/view/viewport.hpp"
#include "games/billiards.hpp"
#include "games/launch.hpp"

/// Plays billiards well enough to finish a game: tries a few promising shots and takes the best.
namespace greedy {

namespace billiards = games::billiards;

struct Shot {
  app::Point grab;    ///< window px, the first click
  app::Point target;  ///< window px, the second
};

inline carom::Vec2 drag_of(const Shot& shot, const app::Viewport& viewport) {
  return viewport.to_world(shot.target) - viewport.to_world(shot.grab);
}

/// Value of the shot: points, and a cue ball lost counts against it.
inline std::int64_t worth(billiards::Game game, carom::Vec2 drag) {
  const int player = game.player();
  const std::int64_t before = game.score(player);
  if (!game.apply(billiards::Shoot{drag})) return -1000;
  while (game.phase() == billiards::Phase::roll) game.step();
  return game.score(player) - before - (game.phase() == billiards::Phase::place ? 150 : 0);
}

/// Whole pixels, so that a script can write the clicks down.
inline app::Point on_pixel(app::Point p) { return {std::round(p.x), std::round(p.y)}; }

/// Is true if the cue ball can roll straight to a place with no ball in its way but the `aimed`.
inline bool is_free(const carom::World& world, carom::Vec2 from, carom::Vec2 to,
                    std::size_t aimed) {
  const carom::Vec2 way = carom::unit(to - from);
  for (std::size_t i = 1; i < world.size(); ++i) {
    const carom::Vec2 between = world.ball(i).position - from;
    const double along = carom::dot(between, way);
    const double reach = world.ball(0).radius + world.ball(i).radius;
    const double aside_squared = carom::length_squared(between) - along * along;
    if (i != aimed && along > 0 && along < carom::length(to - from) + reach &&
        aside_squared < reach * reach)
      return false;
  }
  return true;
}

inline Shot choose_shot(const billiards::Game& game, const app::Viewport& viewport,
                        std::size_t tries) {
  struct Candidate {
    double straightness;
    Shot shot;
  };
  const carom::World& world = game.world();
  const carom::Vec2 cue = world.ball(0).position;
  const app::Point grab = on_pixel(viewport.to_window(cue));
  std::vector<Candidate> candidates;
  const auto add = [&](double straightness, carom::Vec2 direction, double speed) {
    const auto target = [&] {
      const carom::Vec2 drag = direction * (speed / games::launch_factor);
      return on_pixel(viewport.to_window(viewport.to_world(grab) + drag));
    };
    // Drags end on the table: beyond it there may be buttons, or no window.
    const auto outside = [&](carom::Vec2 at) {
      return at.x < -40 || at.x > world.scene().width + 40 || at.y < -40 ||
             at.y > world.scene().height + 40;
    };
    while (outside(viewport.to_world(target()))) speed *= 0.95;
    candidates.push_back({straightness, {grab, target()}});
  };
  for (std::size_t i = 1; i < world.size(); ++i) {
    const carom::Ball red = world.ball(i);
    for (const carom::Hole& hole : world.scene().holes) {
      const carom::Vec2 to_hole = carom::unit(hole.position - red.position);
      const carom::Vec2 ghost = red.position - (red.radius + world.ball(0).radius) * to_hole;
      const carom::Vec2 direction = carom::unit(ghost - cue);
      const bool direct = is_free(world, cue, ghost, i);
      const double cut = carom::dot(direction, to_hole);
      if (direct && cut > 0.2) {
        add(cut, direction, 1900);
        add(cut - 0.1, direction, 1100);
      }
    }
    add(-1, carom::unit(red.position - cue), 2000);
  }
  std::ranges::stable_sort(candidates, std::greater{}, &Candidate::straightness);
  candidates.resize(std::min(candidates.size(), tries));
  return std::ranges::max(candidates, {},
                          [&](const Candidate& candidate) {
                            return worth(game, drag_of(candidate.shot, viewport));
                          })
      .shot;
}

/// A free place for the cue ball, in window px.
inline app::Point choose_place(const billiards::Game& game, const app::Viewport& viewport) {
  for (double x = 200; x < 800; x += 13) {
    for (double y = 200; y < 390; y += 11) {
      const app::Point at = on_pixel(viewport.to_window({x, y}));
      if (game.obstruction(viewport.to_world(at)) == billiards::Obstruction::none) return at;
    }
  }
  return {};
}

}  // namespace greedy
