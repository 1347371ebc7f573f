#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/canvas.hpp"
#include "app/input.hpp"

namespace app {

/// Buttons that share the keyboard's focus. A button acts when it is released over itself, or by
/// Enter or Space when it has the focus.
class Buttons {
 public:
  /// With `primary`, that button stands out and Enter means it as long as nothing has the focus.
  explicit Buttons(std::vector<std::string> labels, std::optional<std::size_t> primary = {});

  std::size_t size() const { return buttons_.size(); }
  void place(std::size_t index, const Rect& box) { buttons_[index].box = box; }

  /// The button that the input sets off, if any.
  std::optional<std::size_t> event(const Input& input);
  /// A click here is a button's business.
  bool cover(Point at) const { return find(at).has_value(); }
  void draw(Canvas& canvas, float text_size = 16) const;

 private:
  struct Button {
    std::string label;
    Rect box;
  };
  std::optional<std::size_t> find(Point at) const;
  void move_focus(std::size_t by);

  std::vector<Button> buttons_;
  std::optional<std::size_t> primary_;
  std::optional<std::size_t> hovered_;
  std::optional<std::size_t> pressed_;
  std::optional<std::size_t> focused_;  ///< shown only to those who use the keyboard
};

}  // namespace app
