#pragma once

#include <cstdint>
#include <vector>

#include "app/draw_list.hpp"
#include "app/font.hpp"

namespace platform {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< rows from the top
};

/// Draws a frame in software, over black. Vertices are taken to 1/256 px; a pixel belongs to a
/// triangle if its centre does, and of two triangles that share an edge through it, to one: nothing
/// is blended twice and nothing is left out. Same list, same bytes.
Image rasterize(const app::DrawList& list, const app::Atlas& atlas, int width, int height);

}  // namespace platform
