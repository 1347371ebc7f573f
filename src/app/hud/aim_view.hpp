#pragma once

#include "app/graphics/canvas.hpp"
#include "app/play/aim.hpp"
#include "app/play/aim_entry.hpp"
#include "app/play/preview.hpp"
#include "app/text/text.hpp"
#include "app/view/viewport.hpp"
#include "carom/world.hpp"

namespace app {

/// The launch: an arrow as strong as it is, and the ways that `preview` foretells.
/// With an empty preview the arrow is as long as the drag.
void draw_aim(DrawList& list, const Viewport& viewport, const carom::World& world, const Aim& aim,
              const Preview& preview);

/// The sling from the lead to where it is pulled, window px.
void draw_sling(DrawList& list, const Viewport& viewport, const carom::Ball& lead, Point to);

/// Where the strength stands in a footer, window px: the whole width means 0 to the greatest.
Rect strength_meter(const View& view, const Rect& footer);

/// Where a finger launches in a footer, window px.
Rect shoot_button(const View& view, const Rect& footer);

/// The line below the world: what the player can do now, and while a launch is aimed its angle and
/// strength in numbers and on a bar up to the greatest, or in their place the fields of `entry`. In
/// practice the strength is a speed in px/s, otherwise a share of the greatest. `shoot`: the button
/// is there.
void draw_footer(Canvas& canvas, const Rect& area, const Aim* aim, const AimEntry* entry,
                 const Words& words, const std::string& hint, Color color, bool practice,
                 bool shoot);

}  // namespace app
