#pragma once

#include "app/draw_list.hpp"
#include "app/font.hpp"
#include "app/view.hpp"

namespace app {

/// What a screen draws on.
struct Canvas {
  DrawList& list;
  Font& font;
  const View& view;
  bool calm = false;   ///< nothing moves for show only (Session::calm)
  bool shake = false;  ///< what breaks may shake the picture

  float px(float units) const { return view.px(units); }
};

}  // namespace app
