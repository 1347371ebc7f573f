#pragma once

#include <string>

#include "app/graphics/canvas.hpp"
#include "app/graphics/label.hpp"

namespace app {

// The title's picture. `art`: what the poster shows, standing on the rail; `rail`: of wood, as wide
// as the window.

/// Dusk over the rail; on a tall window the felt lies below it.
void draw_title_ground(Canvas& canvas, const Rect& art, const Rect& rail);
/// The rack of one game piled up like a tower of the other, and who flies at it.
void draw_poster(Canvas& canvas, const Rect& art);
/// The product's name in two lines; a very low window has no room for it.
void draw_wordmark(Canvas& canvas, const Rect& area, std::string product, Align align);

}  // namespace app
