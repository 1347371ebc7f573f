#pragma once

#include <functional>

#include "app/draw_list.hpp"
#include "app/motion.hpp"
#include "app/viewport.hpp"

namespace app {

/// What quick balls leave behind them for some hundredths of a second, softer the slower they are.
/// `color_of`: of a ball.
void draw_trails(DrawList& list, const Viewport& viewport, const carom::World& world,
                 const Motion& motion, double fraction,
                 const std::function<Color(const carom::Ball&)>& color_of);

}  // namespace app
