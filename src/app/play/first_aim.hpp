#pragma once

#include "carom/vec2.hpp"
#include "carom/world.hpp"

namespace app {

/// The ball of a role that is nearest to `from`; `other` if there is none.
carom::Vec2 nearest(const carom::World& world, carom::Role role, carom::Vec2 from,
                    carom::Vec2 other);

/// The drag (px) with which keys and sticks start: 500 px/s towards the nearest ball of `role` that
/// nothing lies before, no other ball, no hole and no obstacle; if there is something before each,
/// towards the nearest; to the right if there is none. The way is a straight line, without gravity.
carom::Vec2 first_aim(const carom::World& world, carom::Role role);

}  // namespace app
