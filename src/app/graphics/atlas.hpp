#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/graphics/color.hpp"
#include "app/graphics/geometry.hpp"

namespace app {

/// The one texture of all pictures: square; its first texels are white. Small pictures are packed
/// in it in shelves from the top, glyphs and stamps alike.
class Atlas {
 public:
  /// Texels.
  struct Part {
    int x = 0, y = 0, w = 0, h = 0;
  };

  explicit Atlas(int side = 1024) { reset(side); }

  int side() const { return side_; }
  /// side × side, rows from the top, alpha straight; white and clear where nothing lies.
  const std::vector<Color>& texels() const { return texels_; }
  const Color& texel(int x, int y) const { return texels_[index(x, y)]; }
  /// Changes whenever all was forgotten.
  std::uint64_t version() const { return version_; }
  /// The parts added since then, in order.
  std::span<const Part> parts() const { return parts_; }
  /// Where `part` lies in texture coordinates.
  Rect texture(const Part& part) const;

  /// Keeps a picture of w × h texels; nothing if there is no room for it. `texel(x, y)` gives its
  /// colours.
  template <class Texel>
  std::optional<Part> add(int w, int h, const Texel& texel) {
    const std::optional<Part> part = make_room(w, h);
    if (part)
      for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) texels_[index(part->x + x, part->y + y)] = texel(x, y);
    return part;
  }

  /// Forgets all: it is out of use.
  void clear() { reset(side_); }
  /// True once something found no room: grow() and draw again.
  bool full() const { return full_; }
  void grow();

 private:
  std::optional<Part> make_room(int w, int h);
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(x);
  }
  void reset(int side);

  int side_ = 0;
  std::vector<Color> texels_;
  std::vector<Part> parts_;
  std::uint64_t version_ = 0;
  int shelf_x_ = 0;
  int shelf_y_ = 0;
  int shelf_height_ = 0;
  bool full_ = false;
};

}  // namespace app
