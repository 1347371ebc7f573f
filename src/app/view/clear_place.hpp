#pragma once

#include <span>
#include <vector>

#include "app/graphics/geometry.hpp"
#include "app/view/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// What should stay in sight, window px: the holes, and the balls in play of a world of a few.
std::vector<Rect> things_in(const carom::World& world, const Viewport& viewport);

/// How many of `things` a box lies over.
std::size_t covered(const Rect& box, std::span<const Rect> things);

/// `box` moved within `area` to where it covers the fewest of `things`; of such places, to the
/// nearest.
Rect clear_place(const Rect& box, const Rect& area, std::span<const Rect> things);

}  // namespace app
