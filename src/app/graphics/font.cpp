#include "app/graphics/font.hpp"

#include <array>
#include <cstdlib>
#include <unordered_map>
#include <vector>

#include "app/base/embedded.hpp"
#include "app/base/utf8.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace app {
namespace {

constexpr char32_t narrow_space = 0x202f;

}  // namespace

struct Font::Glyph {
  Atlas::Part part;
  int left = 0, top = 0;  ///< px, from the pen to the top left texel
};

struct Font::Faces {
  struct One {
    stbtt_fontinfo info;
    float cap_height = 0;  ///< em
  };
  std::array<One, 3> all;
  std::unordered_map<std::uint64_t, Glyph> glyphs;

  Faces() {
    for (std::size_t i = 0; i < all.size(); ++i) {
      One& one = all[i];
      if (!stbtt_InitFont(&one.info, fonts[i].bytes.data(), 0))
        std::abort();  // built in: cannot fail
      const float em = stbtt_ScaleForMappingEmToPixels(&one.info, 1);
      int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
      stbtt_GetCodepointBox(&one.info, 'H', &x0, &y0, &x1, &y1);
      one.cap_height = em * static_cast<float>(y1);
    }
  }

  const One& of(Face face) const { return all[static_cast<std::size_t>(face)]; }
};

namespace {

/// Calls visit(glyph index, pen) for each glyph, the pen in px from the start; gives the width.
template <class Visit>
float lay_out(const stbtt_fontinfo& info, int size, std::string_view utf8, const Visit& visit) {
  const float scale = stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size));
  float pen = 0;
  int previous = 0;
  while (!utf8.empty()) {
    const char32_t code = take_code_point(utf8);
    if (code == narrow_space) {  // not in every face; a fifth of an em is its usual width
      pen += static_cast<float>(size) * 0.2f;
      previous = 0;
      continue;
    }
    const int index = stbtt_FindGlyphIndex(&info, static_cast<int>(code));
    if (previous != 0)
      pen += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(&info, previous, index));
    visit(index, pen);
    int advance, bearing;
    stbtt_GetGlyphHMetrics(&info, index, &advance, &bearing);
    pen += scale * static_cast<float>(advance);
    previous = index;
  }
  return pen;
}

}  // namespace

Font::Font(Atlas& atlas) : faces_(std::make_unique<Faces>()), atlas_(atlas) {}
Font::~Font() = default;

float Font::width(Face face, int size, std::string_view utf8) const {
  return lay_out(faces_->of(face).info, size, utf8, [](int, float) {});
}

float Font::cap_height(Face face, int size) const {
  return faces_->of(face).cap_height * static_cast<float>(size);
}

Rect Font::draw(DrawList& list, Face face, int size, Point baseline, Color color,
                std::string_view utf8) {
  const float row = std::round(baseline.y);
  Rect ink{baseline.x, row, 0, 0};
  lay_out(faces_->of(face).info, size, utf8, [&](int index, float pen) {
    const float x = std::round((baseline.x + pen) * 4) / 4;
    const float column = std::floor(x);
    const Glyph& g = glyph(face, size, index, static_cast<int>((x - column) * 4));
    if (g.part.w == 0) return;
    const Rect box{column + static_cast<float>(g.left), row + static_cast<float>(g.top),
                   static_cast<float>(g.part.w), static_cast<float>(g.part.h)};
    list.picture(box, atlas_.texture(g.part), color);
    ink = ink.w > 0 ? united(ink, box) : box;
  });
  return ink;
}

const Font::Glyph& Font::glyph(Face face, int size, int index, int quarter) {
  if (version_ != atlas_.version()) {
    faces_->glyphs.clear();
    version_ = atlas_.version();
  }
  const std::uint64_t key =
      static_cast<std::uint64_t>(index) << 32 | static_cast<std::uint64_t>(size) << 8 |
      static_cast<std::uint64_t>(face) << 4 | static_cast<std::uint64_t>(quarter);
  const auto [it, is_new] = faces_->glyphs.try_emplace(key);
  Glyph& g = it->second;
  if (!is_new) return g;

  const stbtt_fontinfo& info = faces_->of(face).info;
  const float scale = stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size));
  const float shift = static_cast<float>(quarter) / 4;
  int x0, y0, x1, y1;
  stbtt_GetGlyphBitmapBoxSubpixel(&info, index, scale, scale, shift, 0, &x0, &y0, &x1, &y1);
  const int w = x1 - x0;
  const int h = y1 - y0;
  if (w <= 0 || h <= 0) return g;
  std::vector<std::uint8_t> coverage(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  stbtt_MakeGlyphBitmapSubpixel(&info, coverage.data(), w, h, w, scale, scale, shift, 0, index);
  const auto part = atlas_.add(w, h, [&](int x, int y) {
    return Color{255, 255, 255,
                 coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) +
                          static_cast<std::size_t>(x)]};
  });
  if (part) g = {*part, x0, y0};
  return g;
}

}  // namespace app
