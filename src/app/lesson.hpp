#pragma once

#include "app/aim_settings.hpp"
#include "app/canvas.hpp"
#include "app/screen.hpp"
#include "app/text.hpp"

namespace app {

/// The first minute: how to shoot, in three pictures, at the side of the window where the ball is
/// not.
void draw_lesson(Canvas& canvas, const Call& call, const Words& words);

/// Rings that go out from the ball, unless the canvas is calm, and what to do with it. `phase` in
/// [0, 1]; 1: no rings.
void draw_nudge(Canvas& canvas, const Call& call, float phase, const Words& words);

}  // namespace app
