#pragma once

#include <optional>

#include "app/play/practice.hpp"
#include "app/text/text.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The buttons below the world that take back, repeat and change a throw. Backspace takes back and
/// Command::again repeats, too.
class PracticeStrip {
 public:
  explicit PracticeStrip(const Words& words);

  static float height(const View& view);
  void resize(const View& view, const Rect& area);
  std::optional<PracticeCommand> event(const Input& input, Sounds& sounds);
  bool has_button_at(Point at, bool touch) const { return buttons_.cover(at, touch); }
  Buttons& buttons() { return buttons_; }
  const Buttons& buttons() const { return buttons_; }
  void draw(Canvas& canvas) const;

 private:
  Words words_;
  Buttons buttons_;
  Rect area_;
};

/// "559 px/s, 26.6°": what a repetition would throw.
std::string practised(const Words& words, const Aim& aim);

}  // namespace app
