#pragma once

#include "app/graphics/canvas.hpp"
#include "app/play/aim.hpp"
#include "app/play/preview.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/world_view.hpp"
#include "carom/world.hpp"

namespace app {

/// While the lead is pulled: where its way meets the first ball, or without one the lead itself,
/// magnified, in the corner of the world that is furthest from `hand` (window px) and the lead.
void draw_loupe(Canvas& canvas, const WorldView& view, const carom::World& world,
                const Interpolator& motion, const Aim& aim, const Preview& preview, Point hand);

}  // namespace app
