#pragma once

#include "app/graphics/raster.hpp"

namespace app {

/// The window's icon: the angry ball on a rounded square, like web/icon.svg; `side` px.
Image draw_icon(int side);

}  // namespace app
