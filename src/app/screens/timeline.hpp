#pragma once

#include "app/graphics/canvas.hpp"
#include "replay/player.hpp"

namespace app {

/// The whole replay from left to right in `area`, a mark per turn, and where it stands. The hand
/// that shows this stays in `within`.
void draw_timeline(Canvas& canvas, const Rect& area, const Rect& within,
                   const replay::Player& player);

/// The turn that a click on the timeline means.
std::size_t turn_at(const Rect& area, const replay::Player& player, Point at);

}  // namespace app
