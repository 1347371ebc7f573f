#pragma once

#include <string>
#include <string_view>

#include "app/graphics/canvas.hpp"

namespace app {

enum class Align : std::uint8_t { left, center, right };

struct TextStyle {
  Face face = Face::regular;
  float size = 16;  ///< units, of the em
  Color color;
  Align align = Align::left;
};

/// Writes one line in the middle of a box's height; a line too long for the box is set smaller.
void label(Canvas& canvas, const Rect& box, const TextStyle& style, std::string_view utf8);

/// The same, but a line that would come out under 16 units is elided instead: for what may be of
/// any length, such as names.
void label_or_elide(Canvas& canvas, const Rect& box, const TextStyle& style, std::string_view utf8);

/// Width of the line if it has all the room it wants, px.
float label_width(const Canvas& canvas, const TextStyle& style, std::string_view utf8);

/// The line, or as much of its start as fits in `width` (px), and "…".
std::string elided(const Canvas& canvas, const TextStyle& style, std::string_view utf8,
                   float width);

/// Writes on as many lines as there is room for, from the top; the last is elided.
void paragraph(Canvas& canvas, Rect box, const TextStyle& style, std::string_view utf8);

/// The ground of a line around `middle`, pushed inside `bounds`.
Rect pill_box(const Canvas& canvas, Point middle, const Rect& bounds, const TextStyle& style,
              std::string_view utf8);
/// A line on a dark, rounded ground: legible over anything.
void pill(Canvas& canvas, const Rect& box, const TextStyle& style, std::string_view utf8,
          float opacity = 1);

}  // namespace app
