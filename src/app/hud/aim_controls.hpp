#pragma once

#include "app/graphics/view.hpp"

/// The places of what aims in a game's footer, window px.
namespace app {

/// The strength: the whole width means 0 to the greatest. It is 300 points of the screen wide, in
/// every window that has them.
Rect strength_meter(const View& view, const Rect& footer);

/// The strength and the numbers over it.
Rect strength_column(const View& view, const Rect& footer);

/// The button that launches.
Rect shoot_button(const View& view, const Rect& footer);

/// The field for small steps (AimDrag::On::fine).
Rect fine_field(const View& view, const Rect& footer);

}  // namespace app
