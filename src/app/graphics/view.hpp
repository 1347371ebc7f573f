#pragma once

#include "app/graphics/geometry.hpp"

namespace app {

/// The size that a finger needs, each way, in points of the screen.
inline constexpr float finger_target = 44;

/// The window's size and the scale of everything drawn in it. Lengths of the interface are written
/// in units: 1 px when the window is 800 × 600, more in a larger one.
struct View {
  float width = 800;   ///< px
  float height = 600;  ///< px
  float scale = 1;     ///< px a unit
  bool touch = false;  ///< fingers are used: what they press is larger
  float density = 1;   ///< px a point of the screen

  /// `density`: pixels a point of the screen, above 1 on fine displays; nothing is drawn smaller in
  /// points because of it.
  static View of(int width, int height, float density = 1);

  float px(float units) const { return std::round(units * scale); }
  /// The size of a button, px: enough for a finger, if fingers are used.
  float button(float units) const {
    return touch ? std::max(px(units), std::ceil(finger_target * density)) : px(units);
  }
  Rect area() const { return {0, 0, width, height}; }
  /// Too narrow for what otherwise stands side by side; a little less room does where height is
  /// scarcer still.
  bool narrow() const { return width < (height < 480 * scale ? 700 : 760) * scale; }
  /// There is room for more side by side.
  bool wide() const { return width >= 900 * scale; }
};

/// Where a game's parts stand: the user bar on top, the world between, words to the player below.
struct GameLayout {
  Rect bar;
  Rect world;
  Rect footer;

  static GameLayout of(const View& view);
};

}  // namespace app
