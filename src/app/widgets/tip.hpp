#pragma once

#include "app/graphics/canvas.hpp"

namespace app {

/// Writes what `canvas.list.tip` tells, if it is there, beside its button and over no other one as
/// far as there is room.
void draw_tip(Canvas& canvas);

/// A line over all else around `middle`, within the window; it counts as a tip.
void draw_note(Canvas& canvas, Point middle, std::string_view text);

}  // namespace app
