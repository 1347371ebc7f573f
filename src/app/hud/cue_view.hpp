#pragma once

#include "app/graphics/draw_list.hpp"
#include "app/play/computer_turn.hpp"
#include "app/view/viewport.hpp"
#include "carom/scene.hpp"

namespace app {

/// A computer's cue behind the cue ball; nothing of it is seen outside of `area`, window px.
void draw_cue(DrawList& list, const Rect& area, const Viewport& viewport, const carom::Ball& ball,
              const ComputerTurn::Cue& cue);

}  // namespace app
