#pragma once

#include <cstdint>
#include <vector>

#include "app/graphics/atlas.hpp"
#include "app/graphics/draw_list.hpp"

namespace app {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<Color> pixels;  ///< width × height, rows from the top
  Image(int wide, int high, Color ground)
      : width(wide),
        height(high),
        pixels(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), ground) {}

  Color& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  const Color& at(int x, int y) const { return const_cast<Image&>(*this).at(x, y); }
};

/// Draws a frame in software, over what the image shows. Vertices are taken to 1/256 px; a pixel
/// belongs to a triangle if its centre does, and of two triangles that share an edge through it, to
/// one: nothing is blended twice and nothing is left out. Between texels it interpolates. Same
/// list, same bytes.
void rasterize(const DrawList& list, const Atlas& atlas, Image& image);

}  // namespace app
