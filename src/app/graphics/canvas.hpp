#pragma once

#include "app/graphics/draw_list.hpp"
#include "app/graphics/font.hpp"
#include "app/graphics/view.hpp"

namespace app {

/// The target of a screen's drawing.
struct Canvas {
  DrawList& list;
  Font& font;
  const View& view;
  bool calm = false;   ///< nothing moves for show only (Session::calm)
  bool shake = false;  ///< what breaks may shake the picture

  float px(float units) const { return view.px(units); }
};

}  // namespace app
