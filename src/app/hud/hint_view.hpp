#pragma once

#include <string>

#include "app/graphics/canvas.hpp"
#include "app/play/hint.hpp"
#include "app/text/text.hpp"
#include "app/view/viewport.hpp"

namespace app {

/// What the hint tells by now, in words.
std::string hint_in_words(const Words& words, const Hint& hint, bool level);

/// The hint over the world, which `area` (window px) shows: a ring around the ball, the way to it,
/// and its words. The aim itself is the player's from then on.
void draw_hint(Canvas& canvas, const Rect& area, const Viewport& viewport,
               const carom::World& world, const Hint& hint, const Words& words);

}  // namespace app
