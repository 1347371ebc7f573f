#pragma once

#include <cstddef>

#include "app/graphics/draw_list.hpp"

namespace app {

/// Cuts the triangles from index `first` on off at the sides of `box`; what is left looks as
/// before, where clip() only squeezes.
void crop(DrawList& list, std::size_t first, const Rect& box);

}  // namespace app
