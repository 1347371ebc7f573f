#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/text/text.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// The strip above the world (§1.1.4) with the buttons that restart and leave the game and open
/// the pause menu. What else stands in it is each game's own.
class UserBar {
 public:
  enum class Command : std::uint8_t { pause, restart, close };

  std::optional<Command> event(const Input& input, Sounds& sounds);
  /// A click here is a button's business; elsewhere in the bar it may end a drag.
  bool has_button_at(Point at, bool touch) const { return buttons_.cover(at, touch); }
  Buttons& buttons() { return buttons_; }
  const Buttons& buttons() const { return buttons_; }

 protected:
  /// Room for the game's own: side by side, or above each other in a narrow window.
  struct Room {
    Rect first;
    Rect second;  ///< narrow: beside the buttons; otherwise empty
  };

  UserBar();
  void relabel(std::string pause, std::string restart, std::string close);
  /// In the order of Command.
  void explain(std::array<std::string, 3> tips);
  Room place(const View& view, const Rect& area);
  void draw_strip(Canvas& canvas) const;
  /// A number over what it counts.
  static void draw_count(Canvas& canvas, const Rect& box, std::string_view value,
                         std::string_view title);

 private:
  Buttons buttons_;
  Rect area_;
};

}  // namespace app
