#pragma once

#include <optional>

#include "app/aim.hpp"
#include "app/draw_list.hpp"
#include "app/view.hpp"
#include "app/viewport.hpp"
#include "carom/scene.hpp"

namespace app {

/// The player's two clicks that launch the lead, cue ball or projectile, and what goes wrong.
struct Launcher {
  Aim aim;
  bool missed = false;   ///< the last click was not on the lead
  bool refused = false;  ///< the last click was too near the first

  /// A click at a place of the world (px). The one that launches gives the drag.
  std::optional<carom::Vec2> click(carom::Vec2 at, bool on_lead);
};

/// Whether a click takes the lead. It is small: next to it will do.
bool on_lead(const carom::Ball& lead, Point at, const Viewport& viewport, const View& view);

/// A ring around the lead; it opens up under the pointer.
void draw_invitation(DrawList& list, const Viewport& viewport, const carom::Ball& lead,
                     bool hovered, Color color);

}  // namespace app
