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

/// A ring around the lead; it opens up under the pointer.
void draw_invitation(DrawList& list, const Viewport& viewport, const carom::Ball& lead,
                     bool hovered, Color color);

/// The line below the world.
struct Footer {
  const Aim* aim = nullptr;         ///< what is aimed
  const AimEntry* entry = nullptr;  ///< fields, in place of the numbers
  std::string hint;                 ///< what the player can do now
  Color color;                      ///< of the hint
  bool practice = false;     ///< the strength is a speed in px/s, else a share of the greatest
  bool slides = false;       ///< the bar of the strength can be held
  bool shoot = false;        ///< the button that launches is there
  bool hint_button = false;  ///< another button, which is not drawn here, has its place
  bool fine = false;         ///< the field for small steps is there
};
/// While a launch is aimed its angle and strength in numbers and on a bar up to the greatest, and
/// what sets them; beside them the hint, where there is room for it.
void draw_footer(Canvas& canvas, const Rect& area, const Footer& footer, const Words& words);

}  // namespace app
