#pragma once

#include <array>
#include <optional>

#include "app/text.hpp"
#include "app/widgets.hpp"

namespace app {

/// The strip above the table (§1.1.4): both players' scores, whose turn it is, what is left, and
/// the buttons that restart and close the game.
class UserBar {
 public:
  struct Content {
    std::array<int, 2> scores{};
    std::optional<int> on;  ///< whose turn it is; none when the game is over
    int balls_left = 0;
    int turn_points = 0;
  };
  enum class Command : std::uint8_t { restart, close };

  explicit UserBar(const Words& words);

  void resize(const View& view, const Rect& area);
  std::optional<Command> event(const Input& input);
  /// A click here is a button's business; elsewhere in the bar it may end a drag.
  bool has_button_at(Point at) const { return buttons_.cover(at); }
  void draw(Canvas& canvas, const Content& content) const;

 private:
  void draw_player(Canvas& canvas, const Content& content, int player) const;

  Words words_;
  Buttons buttons_;
  Rect area_;
  std::array<Rect, 2> players_;
  std::array<Rect, 2> counts_;  ///< balls left, points of this turn
};

}  // namespace app
