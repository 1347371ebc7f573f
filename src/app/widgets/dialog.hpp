#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/widgets/widgets.hpp"

namespace app {

/// A question in the middle of the window, over everything else, that takes all input.
class Dialog {
 public:
  struct Line {
    std::string text{};
    std::string score{};          ///< set on the right; without one the text is in the middle
    std::optional<int> player{};  ///< whose sign stands before it
    /// A row of a table instead: the text, and what it says of both players.
    std::optional<std::array<std::string, 2>> columns{};
    bool heads = false;  ///< of a row: the columns are the players' names
  };
  using Button = Buttons::Button;
  /// The first button is the primary one; Esc means the last.
  Dialog(std::string title, std::vector<Line> lines, std::vector<Button> buttons);

  void resize(const View& view);
  /// The button chosen, if any.
  std::optional<ButtonId> event(const Input& input, Sounds& sounds);
  void draw(Canvas& canvas) const;
  const std::string& title() const { return title_; }

 private:
  void draw_row(Canvas& canvas, Rect row, const Line& line) const;

  std::string title_;
  std::vector<Line> lines_;
  Buttons buttons_;
  Rect panel_;
  float line_height_ = 0;  ///< px
};

}  // namespace app
