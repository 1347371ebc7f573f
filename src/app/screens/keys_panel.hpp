#pragma once

#include <optional>
#include <string>

#include "app/input/key_bindings.hpp"
#include "app/text/text.hpp"
#include "app/widgets/widgets.hpp"

namespace app {

/// Where the player puts commands on other letters: a line is chosen, and the next letter pressed
/// is taken.
class KeysPanel {
 public:
  /// `keyboard` must outlive this.
  KeysPanel(const Words& words, Keyboard& keyboard);

  /// Within `area`, window px.
  void resize(const View& view, const Rect& area);
  /// `input` with the keys as they are pressed. False: closed.
  bool event(const Input& input);
  void draw(Canvas& canvas) const;

 private:
  void relabel();

  Words words_;
  Keyboard& keyboard_;
  Buttons buttons_;                ///< the commands, then defaults, then back
  std::optional<Command> wanted_;  ///< the next letter is for this one
  std::string message_;
  Rect head_;
  Rect foot_;
};

}  // namespace app
