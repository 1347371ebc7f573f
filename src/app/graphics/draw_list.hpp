#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/graphics/color.hpp"
#include "app/graphics/geometry.hpp"
#include "app/graphics/palette.hpp"

namespace app {

struct Vertex {
  Point position;  ///< window px
  Point texture;   ///< in the atlas, 0 to 1; (0, 0) is a white texel
  Color color;     ///< multiplies the atlas

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// The area of a text or button: for tests of the layout and for assistive tools.
struct Box {
  enum class Kind : std::uint8_t {
    text,
    button,
    tip,  ///< stands for a moment over what is beneath
  };
  Kind kind = Kind::text;
  Rect area;  ///< of a text, what its ink covers
  std::string text;
  int text_size = 0;  ///< px, of the em; 0 for a button
  // Of a button.
  bool focused = false;  ///< Enter and Space press it
  bool primary = false;  ///< Enter presses it as long as none has the focus
  std::string tip{};     ///< what it does
};

/// A button's tip, for anyone pointing at it.
struct Tip {
  Rect button;  ///< window px
  std::string text;
};

class Stamps;

/// One frame, all of it: triangles over one texture, back to front.
struct DrawList {
  /// The colours that it is drawn with; never null.
  const Palette* palette = &Palette::of(Colours::standard);
  /// Keeps what is drawn again and again as pictures; null: all is drawn as triangles.
  Stamps* stamps = nullptr;
  std::vector<Vertex> vertices;
  std::vector<std::int32_t> indices;  ///< three a triangle
  std::vector<Box> boxes;
  std::size_t covered = 0;  ///< so many boxes, the first, lie below a window that takes all input
  std::optional<Tip> tip;   ///< to be drawn over all else
  // So many vertices and indices, the first, are mostly the same from frame to frame: whoever
  // shows the list may keep their picture.
  std::size_t still_vertices = 0;
  std::size_t still_indices = 0;

  void clear() {
    vertices.clear();
    indices.clear();
    boxes.clear();
    covered = 0;
    tip.reset();
    still_vertices = 0;
    still_indices = 0;
  }
  /// Adds a vertex and gives its index.
  std::int32_t add(Point position, Color color, Point texture = {}) {
    vertices.push_back({position, texture, color});
    return static_cast<std::int32_t>(vertices.size()) - 1;
  }
  void triangle(std::int32_t a, std::int32_t b, std::int32_t c) {
    indices.insert(indices.end(), {a, b, c});
  }
  void quad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    indices.insert(indices.end(), {a, b, c, a, c, d});
  }
  /// A part of the atlas (Atlas::texture) over `box`.
  void picture(const Rect& box, const Rect& texture, Color color) {
    const auto a = add({box.x, box.y}, color, {texture.x, texture.y});
    const auto b = add({box.right(), box.y}, color, {texture.right(), texture.y});
    const auto c = add({box.right(), box.bottom()}, color, {texture.right(), texture.bottom()});
    const auto d = add({box.x, box.bottom()}, color, {texture.x, texture.bottom()});
    quad(a, b, c, d);
  }
  /// Marks all that was drawn up to here as still.
  void stand_still() {
    still_vertices = vertices.size();
    still_indices = indices.size();
  }
};

}  // namespace app
