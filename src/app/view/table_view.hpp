#pragma once

#include "app/graphics/draw_list.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// The table with its wood, as large as fits into `area`: upright where it is larger so, as on a
/// phone; the cue ball starts below then.
Viewport table_viewport(const Rect& area, const carom::Scene& table);
/// The table's area, window px.
Rect table_box(const Viewport& viewport, const carom::Scene& table);

/// The room, which fills the window, and in it bed, cushions, wood and pockets.
void draw_table(DrawList& list, const Rect& window, const Viewport& viewport,
                const carom::Scene& scene);

/// Trails of quick balls, drawn before every ball.
void draw_table_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                       const Interpolator& motion, double fraction);
/// The balls in play, `fraction` of the way through the current step.
void draw_balls(DrawList& list, const Viewport& viewport, const carom::World& world,
                const Interpolator& motion, double fraction);

}  // namespace app
