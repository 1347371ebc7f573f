#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/graphics/canvas.hpp"
#include "app/input/input.hpp"

namespace app {

/// Buttons that share the keyboard's focus. A button acts when it is released over itself, or by
/// Enter or Space when it has the focus. A finger need not be exact: a small button takes what is
/// around it, up to finger_target.
class Buttons {
 public:
  /// With `primary`, that button stands out and Enter means it as long as nothing has the focus.
  explicit Buttons(std::vector<std::string> labels, std::optional<std::size_t> primary = {});

  std::size_t size() const { return buttons_.size(); }
  void place(const View& view, std::size_t index, const Rect& box) {
    buttons_[index].box = box;
    finger_ = finger_target * view.density;
  }

  void relabel(std::size_t index, std::string label) { buttons_[index].label = std::move(label); }
  /// What the button does, in some words: shown as long as it is pointed at or has the focus.
  void explain(std::size_t index, std::string tip) { buttons_[index].tip = std::move(tip); }

  /// Of the button pointed at, else of the one with the focus; empty if there is none.
  std::string tip() const;

  /// The button that the input sets off, if any.
  std::optional<std::size_t> event(const Input& input);
  /// The same keys that move the focus within one group of buttons move it through all of `groups`
  /// (null: none), in their order, as if they were one. Whether `input` was such a key: then it is
  /// done with.
  static bool move_focus(std::initializer_list<Buttons*> groups, const Input& input);
  /// The focus is on none of them, as at the start.
  void blur() { focused_.reset(); }
  bool has_focus() const { return focused_.has_value(); }
  /// Takes over the focus of the buttons that these take the place of: of the last `tail` of them
  /// on the one that is as far from the end, of the others on the one that is as far from the
  /// start.
  void keep_focus(const Buttons& before, std::size_t tail);
  /// A click here is a button's business.
  bool cover(Point at, bool touch = false) const {
    return (touch ? touched(at) : find(at)).has_value();
  }
  void draw(Canvas& canvas, float text_size = 16) const;

  // For those who draw a button themselves, and for draw().
  const Rect& box(std::size_t index) const { return buttons_[index].box; }
  const std::string& label_of(std::size_t index) const { return buttons_[index].label; }
  bool hovered(std::size_t index) const { return hovered_ == index; }
  bool pressed(std::size_t index) const { return pressed_ == index && hovered_ == index; }
  bool focused(std::size_t index) const { return focused_ == index; }
  void draw_one(Canvas& canvas, std::size_t index, float text_size) const;
  /// A button without its label; gives where that goes, its colour too.
  struct Look {
    Rect box;
    Color ink;
  };
  Look draw_face(Canvas& canvas, std::size_t index) const;
  /// Lists it among what is on screen; `text`: all that is written on it.
  void list_box(DrawList& list, std::size_t index, std::string text) const;
  /// The buttons stand in rows of so many: with more than one, up and down move the focus to the
  /// nearest in the next row, wherever its buttons stand.
  void set_columns(std::size_t columns) { columns_ = columns; }

 private:
  struct Button {
    std::string label;
    Rect box;
    std::string tip;
  };
  std::optional<std::size_t> find(Point at) const;
  std::optional<std::size_t> touched(Point at) const;
  void move_focus(std::ptrdiff_t by);
  void move_focus_to_row(bool below);

  std::vector<Button> buttons_;
  std::optional<std::size_t> primary_;
  float finger_ = finger_target;  ///< px
  std::size_t columns_ = 1;
  std::optional<std::size_t> hovered_;
  std::optional<std::size_t> pressed_;
  bool touch_ = false;                  ///< pressed_ is, by a finger
  std::optional<std::size_t> focused_;  ///< shown only to those who use the keyboard
};

}  // namespace app
