#pragma once

#include "app/graphics/canvas.hpp"
#include "app/input/input.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The next throw is offered: a click anywhere takes it, and some keys.
class NextOffer {
 public:
  /// Puts the button into the world's upper part.
  void place(const View& view, const Rect& world, std::string label, std::string tip);
  /// Returns true if it is taken. `focus_elsewhere`: another button has the focus; `on_button`:
  /// the pointer is on one.
  bool event(const Input& input, bool focus_elsewhere, bool on_button, Sounds& sounds);
  Buttons& buttons() { return prompt_; }
  void draw(Canvas& canvas) const { prompt_.draw(canvas, 20); }

 private:
  Buttons prompt_{{{0}}, 0};
};

}  // namespace app
