#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "app/draw_list.hpp"

namespace app {

enum class Face : std::uint8_t { regular, bold, black };

/// The one texture: square, one byte of coverage a texel. Its first texels are white.
struct Atlas {
  int side = 0;
  std::vector<std::uint8_t> coverage;  ///< side × side, rows from the top
  std::uint64_t version = 0;           ///< changes whenever the coverage does
};

/// Writes text with glyphs rasterised at exactly the size asked for, on whole pixels (across, on
/// quarters of one), so that texels meet pixels and the text is sharp.
class Font {
 public:
  Font();
  ~Font();

  /// Px; sizes are those of the em square.
  float width(Face face, int size, std::string_view utf8) const;
  /// Height of a capital letter.
  float cap_height(Face face, int size) const;

  /// Draws from the left end of the baseline; gives what the ink covers.
  Rect draw(DrawList& list, Face face, int size, Point baseline, Color color,
            std::string_view utf8);

  const Atlas& atlas() const { return atlas_; }
  /// Forgets all glyphs: their sizes went out of use.
  void clear();
  /// True once a glyph found no room in the atlas and was left out: grow() and draw again.
  bool full() const { return full_; }
  void grow();

 private:
  struct Faces;
  struct Glyph;

  const Glyph& glyph(Face face, int size, int index, int quarter);
  void reset(int side);

  std::unique_ptr<Faces> faces_;
  Atlas atlas_;
  // Glyphs are packed in shelves from the top.
  int shelf_x_ = 0;
  int shelf_y_ = 0;
  int shelf_height_ = 0;
  bool full_ = false;
};

}  // namespace app
