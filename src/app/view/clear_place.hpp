#pragma once

#include <span>
#include <vector>

#include "app/graphics/geometry.hpp"
#include "app/view/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// Things that should stay in sight, window px: holes, and the balls in play if they are few.
std::vector<Rect> things_in(const carom::World& world, const Viewport& viewport);

/// Number of `things` that a box lies over.
std::size_t covered(const Rect& box, std::span<const Rect> things);

/// `box` moved within `area` to where it covers the fewest of `things`; of such places, to the
/// nearest.
Rect clear_place(const Rect& box, const Rect& area, std::span<const Rect> things);

}  // namespace app
