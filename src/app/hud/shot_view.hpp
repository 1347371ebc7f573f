#pragma once

#include "app/graphics/draw_list.hpp"
#include "app/play/preview.hpp"
#include "app/view/viewport.hpp"
#include "games/billiards.hpp"
#include "search/simulation.hpp"

namespace app {

/// A shot that could be made in `game`, the cue ball in hand where it would go.
void draw_shot(DrawList& list, const Viewport& viewport, games::billiards::Game game,
               const search::Shot& shot, Previewer& previewer);

}  // namespace app
