#pragma once

#include "app/aim.hpp"
#include "app/canvas.hpp"
#include "app/text.hpp"
#include "app/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// Where the launch goes: an arrow as long as the drag; on a table, on to the first thing the ball
/// would meet.
void draw_aim(DrawList& list, const Viewport& viewport, const carom::World& world, const Aim& aim);

/// The line below the world: what the player can do now, and how strong the launch is while one is
/// aimed: a bar up to the greatest speed, and the speed in numbers.
void draw_footer(Canvas& canvas, const Rect& area, const Aim* aim, const Words& words,
                 const std::string& hint, Color color);

}  // namespace app
