#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/audio/sound.hpp"
#include "app/graphics/canvas.hpp"
#include "app/input/input.hpp"

namespace app {

/// Names a button within its group: an enumerator of the screen's, or an item's number in a list.
using ButtonId = std::size_t;

/// Buttons that share the keyboard's focus. A button acts when it is released over itself, or by
/// Enter or Space when it has the focus; it clicks when it is pressed. A finger need not be exact:
/// a small button takes what is around it, up to finger_target.
class Buttons {
 public:
  struct Button {
    ButtonId id = 0;
    std::string label{};
    std::string
        tip{};  ///< what it does, in some words: shown while it is pointed at or has the focus
    Rect box{};
    std::string brief{};  ///< shown where the label has too little room; empty: set smaller
  };
  /// In the order of the focus. With `primary`, that button stands out and Enter means it as long
  /// as nothing has the focus.
  explicit Buttons(std::vector<Button> buttons = {}, std::optional<ButtonId> primary = {})
      : buttons_(std::move(buttons)), primary_(primary) {}

  std::size_t size() const { return buttons_.size(); }
  std::span<const Button> all() const { return buttons_; }
  void place(const View& view, ButtonId id, const Rect& box) {
    at(id).box = box;
    finger_ = finger_target * view.density;
  }

  void relabel(ButtonId id, std::string label) { at(id).label = std::move(label); }
  void abbreviate(ButtonId id, std::string brief) { at(id).brief = std::move(brief); }
  void explain(ButtonId id, std::string tip) { at(id).tip = std::move(tip); }

  /// Of the button pointed at, else of the one with the focus; empty if there is none.
  std::string tip() const;

  /// The button that the input sets off, if any. `sounds`: what is to be heard of it.
  std::optional<ButtonId> event(const Input& input, Sounds& sounds);
  /// The same keys that move the focus within one group of buttons move it through all of `groups`
  /// (null: none), in their order, as if they were one. Whether `input` was such a key: then it is
  /// done with.
  static bool move_focus(std::initializer_list<Buttons*> groups, const Input& input);
  /// The focus is on none of them, as at the start.
  void blur() { focused_.reset(); }
  bool has_focus() const { return focused_.has_value(); }
  /// Takes over the focus of the buttons that these take the place of, if the one is here, too.
  void keep_focus(const Buttons& before) {
    if (before.focused_ && find(*before.focused_)) focused_ = before.focused_;
  }
  /// A click here is a button's business.
  bool cover(Point at, bool touch = false) const {
    return (touch ? touched(at) : pointed(at)).has_value();
  }
  void draw(Canvas& canvas, float text_size = 16) const;

  // For those who draw a button themselves, and for draw().
  const Rect& box(ButtonId id) const { return find(id)->box; }
  const std::string& label_of(ButtonId id) const { return find(id)->label; }
  bool hovered(ButtonId id) const { return hovered_ == id; }
  bool pressed(ButtonId id) const { return pressed_ == id && hovered_ == id; }
  bool focused(ButtonId id) const { return focused_ == id; }
  void draw_one(Canvas& canvas, ButtonId id, float text_size) const;
  /// A button without its label; gives where that goes, its colour too.
  struct Look {
    Rect box;
    Color ink;
  };
  Look draw_face(Canvas& canvas, ButtonId id) const;
  /// Lists it among what is on screen; `text`: all that is written on it.
  void list_box(DrawList& list, ButtonId id, std::string text) const;
  /// The buttons stand in rows of so many: with more than one, up and down move the focus to the
  /// nearest in the next row, wherever its buttons stand.
  void set_columns(std::size_t columns) { columns_ = columns; }

 private:
  const Button* find(ButtonId id) const;
  Button& at(ButtonId id) { return *std::ranges::find(buttons_, id, &Button::id); }
  std::size_t index_of(ButtonId id) const {
    return static_cast<std::size_t>(find(id) - buttons_.data());
  }
  std::optional<ButtonId> pointed(Point at) const;
  std::optional<ButtonId> touched(Point at) const;
  void move_focus(std::ptrdiff_t by);
  void move_focus_to_row(bool below);

  std::vector<Button> buttons_;
  std::optional<ButtonId> primary_;
  float finger_ = finger_target;  ///< px
  std::size_t columns_ = 1;
  std::optional<ButtonId> hovered_;
  std::optional<ButtonId> pressed_;
  bool touch_ = false;               ///< pressed_ is, by a finger
  std::optional<ButtonId> focused_;  ///< shown only to those who use the keyboard
};

}  // namespace app
