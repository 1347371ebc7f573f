#pragma once

#include "app/graphics/shapes.hpp"

namespace app {

/// The skyline of far hills, from left to right: range 0 is the farthest of three.
Outline ridge(const Rect& area, float horizon, float unit, int range);

/// Sky, far hills and the ground, whose surface lies at `horizon` (window y). `unit`: the height
/// that the hills are measured by, px.
void draw_landscape(DrawList& list, const Rect& area, float horizon, float unit);

/// The same land by night, dim, behind a menu whose foot begins at `horizon`.
void draw_night(DrawList& list, const Rect& area, float horizon);

}  // namespace app
