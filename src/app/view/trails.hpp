#pragma once

#include <functional>

#include "app/graphics/draw_list.hpp"
#include "app/view/interpolator.hpp"
#include "app/view/viewport.hpp"

namespace app {

/// Trails of quick balls for some hundredths of a second, softer the slower the balls are.
/// `color_of`: of a ball.
void draw_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                 const Interpolator& motion, double fraction,
                 const std::function<Color(const carom::Ball&)>& color_of);

}  // namespace app
