#pragma once

#include "app/draw_list.hpp"

namespace app {

/// Sky, far hills and the ground, whose surface lies at `horizon` (window y). `unit`: the height
/// that the hills are measured by, px.
void draw_landscape(DrawList& list, const Rect& area, float horizon, float unit);

}  // namespace app
