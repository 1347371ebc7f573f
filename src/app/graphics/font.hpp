#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "app/graphics/atlas.hpp"
#include "app/graphics/draw_list.hpp"

namespace app {

enum class Face : std::uint8_t { regular, bold, black };

/// Writes text with glyphs rasterised at exactly the size asked for, on whole pixels (across, on
/// quarters of one), so that texels meet pixels and the text is sharp.
class Font {
 public:
  /// The atlas keeps the glyphs; it must outlive this.
  explicit Font(Atlas& atlas);
  ~Font();

  /// Px; sizes are those of the em square.
  float width(Face face, int size, std::string_view utf8) const;
  /// Height of a capital letter.
  float cap_height(Face face, int size) const;

  /// Draws from the left end of the baseline; gives what the ink covers.
  Rect draw(DrawList& list, Face face, int size, Point baseline, Color color,
            std::string_view utf8);

 private:
  struct Faces;
  struct Glyph;

  const Glyph& glyph(Face face, int size, int index, int quarter);

  std::unique_ptr<Faces> faces_;
  Atlas& atlas_;
  std::uint64_t version_ = 0;  ///< of the atlas that the glyphs lie in
};

}  // namespace app
