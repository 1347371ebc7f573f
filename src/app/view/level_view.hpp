#pragma once

#include "app/graphics/draw_list.hpp"
#include "app/view/balls.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// Shows a whole level, and more sky if there is room.
Viewport level_viewport(const Rect& area, const carom::Scene& level);

/// The still part: landscape, walls, solid sides, and the projectile's stand.
void draw_level(DrawList& list, const Rect& area, const Viewport& viewport,
                const carom::Scene& level);

/// Trails of quick balls, drawn before every ball.
void draw_level_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                       const carom::Scene& level, const Interpolator& motion, double fraction);
/// The balls in play, `fraction` of the way through the current step, with the cracks they got
/// since `level`; and above the top edge of `area`, signs of the balls that are higher up.
void draw_level_balls(DrawList& list, const Rect& area, const Viewport& viewport,
                      const carom::World& world, const carom::Scene& level,
                      const Interpolator& motion, double fraction);

/// Is true if a ball may be drawn beyond the top edge of `area`.
bool any_above(const Rect& area, const Viewport& viewport, const carom::World& world);

/// A ball's material; `full_solidity` is its first one.
BallKind kind_of(const carom::Ball& ball, double full_solidity, const carom::Scene& level);

}  // namespace app
