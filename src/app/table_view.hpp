#pragma once

#include "app/draw_list.hpp"
#include "app/motion.hpp"
#include "app/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// World px from the play area to the outer edge of the table's wood.
inline constexpr double table_margin = 46;

/// The room, which fills the window, and in it bed, cushions, wood and pockets.
void draw_table(DrawList& list, const Rect& window, const Viewport& viewport,
                const carom::Scene& scene);

/// What quick balls leave behind, drawn before every ball.
void draw_table_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                       const Motion& motion, double fraction);
/// The balls in play, `fraction` of the way through the current step.
void draw_balls(DrawList& list, const Viewport& viewport, const carom::World& world,
                const Motion& motion, double fraction);

}  // namespace app
