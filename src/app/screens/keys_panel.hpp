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
  bool event(const Input& input, Sounds& sounds);
  void draw(Canvas& canvas) const;

 private:
  /// The commands come first, each by its own number.
  enum Button : ButtonId { defaults = all_commands.size(), back };
  static ButtonId id_of(Command command) { return static_cast<ButtonId>(command); }

  void relabel();

  Words words_;
  Keyboard& keyboard_;
  Buttons buttons_;
  std::optional<Command> wanted_;  ///< the next letter is for this one
  std::string message_;
  Rect head_;
  Rect foot_;
};

}  // namespace app
