#pragma once

#include "app/aim.hpp"
#include "app/canvas.hpp"
#include "app/text.hpp"
#include "app/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// Where the launch goes: an arrow as long as the drag, on to the first thing the ball would meet.
void draw_aim(DrawList& list, const Viewport& viewport, const carom::World& world, const Aim& aim);

/// How strong the launch is: a bar up to the greatest speed, and the speed in numbers.
void draw_strength(Canvas& canvas, const Rect& area, const Aim& aim, const Words& words);

}  // namespace app
