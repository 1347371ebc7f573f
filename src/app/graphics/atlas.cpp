#include "app/graphics/atlas.hpp"

namespace app {
namespace {

constexpr int largest_side = 4096;
constexpr int white_side = 4;  ///< texels of white in the corner, safe from filtering

}  // namespace

Rect Atlas::texture(const Part& part) const {
  const float texel = 1 / static_cast<float>(side_);
  return {static_cast<float>(part.x) * texel, static_cast<float>(part.y) * texel,
          static_cast<float>(part.w) * texel, static_cast<float>(part.h) * texel};
}

void Atlas::grow() { reset(std::min(side_ * 2, largest_side)); }

void Atlas::reset(int side) {
  side_ = side;
  texels_.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                 {255, 255, 255, 0});
  for (int y = 0; y < white_side; ++y)
    for (int x = 0; x < white_side; ++x) texels_[index(x, y)].a = 255;
  parts_.clear();
  ++version_;
  shelf_x_ = white_side + 1;
  shelf_y_ = 0;
  shelf_height_ = white_side;
  full_ = false;
}

std::optional<Atlas::Part> Atlas::make_room(int w, int h) {
  if (shelf_x_ + w > side_) {
    shelf_x_ = 0;
    shelf_y_ += shelf_height_ + 1;
    shelf_height_ = 0;
  }
  if (shelf_y_ + h > side_ || w > side_) {
    // At the largest side a picture stays out rather than growing for ever.
    full_ = side_ < largest_side;
    return std::nullopt;
  }
  const Part part{shelf_x_, shelf_y_, w, h};
  parts_.push_back(part);
  shelf_x_ += w + 1;
  shelf_height_ = std::max(shelf_height_, h);
  return part;
}

}  // namespace app
