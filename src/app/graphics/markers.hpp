#pragma once

#include "app/graphics/draw_list.hpp"

namespace app {

/// A player's sign: a diamond for the first, a disc with a hole for the second, each in the
/// player's accent, so that neither colour nor shape alone has to tell them apart.
void draw_marker(DrawList& list, int player, Point center, float radius, float opacity = 1);
void draw_marker(DrawList& list, int player, Point center, float radius, Color color);

}  // namespace app
