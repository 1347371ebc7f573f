#pragma once

#include "app/graphics/canvas.hpp"
#include "app/hud/aim_prompt.hpp"
#include "app/storage/aim_settings.hpp"
#include "app/text/text.hpp"

namespace app {

/// The first minute: how to shoot, in three pictures, at the side of the window where the ball is
/// not.
void draw_lesson(Canvas& canvas, const AimPrompt& call, const Words& words);

/// Rings that go out from the ball, unless the canvas is calm, and what to do with it. `phase` in
/// [0, 1]; 1: no rings.
void draw_nudge(Canvas& canvas, const AimPrompt& call, float phase, const Words& words);

}  // namespace app
