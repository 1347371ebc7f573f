#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/input/input.hpp"
#include "carom/result.hpp"

namespace platform {

/// A script's action at one moment. Points are in window px.
struct Click {  ///< moves there, presses and releases
  app::Point at;
  app::PointerButton button = app::PointerButton::left;
};
struct Move {
  app::Point to;
};
struct PointerDown {  ///< moves there and presses the left button
  app::Point at;
};
struct PointerUp {  ///< moves there and releases the left button
  app::Point at;
};
struct Wheel {
  float notches = 0;  ///< away from the player is positive
};
struct Press {  ///< and releases
  app::KeyPressed key;
};
struct Hold {  ///< a key, until it is let go
  app::Key key;
};
struct LetGo {
  app::Key key;
};
struct Type {
  std::string text;  ///< UTF-8
};
struct Touch {  ///< of one finger
  app::Finger finger;
};
struct PadPress {  ///< and releases
  app::PadButton button;
};
struct PadInput {
  app::Input input;  ///< PadPressed, PadReleased or PadMoved
};
struct Screenshot {
  std::string file;
};

struct Print {};  ///< says what is on screen

struct ScriptLine {
  std::chrono::nanoseconds at{};  ///< from the start
  std::variant<Click, Move, PointerDown, PointerUp, Wheel, Press, Hold, LetGo, Type, Touch,
               PadPress, PadInput, Screenshot, Print>
      action;
};
using Script = std::vector<ScriptLine>;

/// Reads JSON Lines, one action a line, in the order of time; empty lines are skipped:
///   {"at": 0.5, "click": [400, 300]}        also "button": "right"
///   {"at": 1, "move": [10, 20]}
///   {"at": 1, "press": [10, 20]}            and "release"
///   {"at": 1, "wheel": -2}
///   {"at": 1.5, "key": "Escape"}            also "Shift+Left", "Ctrl+Up", …
///   {"at": 1.5, "hold": "Space"}            and "let_go"
///   {"at": 1.5, "type": "Zoé"}
///   {"at": 1.5, "touch": [400, 300]}        also "touch_move", "touch_end"; "finger": 1
///   {"at": 1.5, "pad": "A"}                 pressed and released; "pad_hold", "pad_let_go"
///   {"at": 1.5, "stick": ["left_x", 0.5]}   and stays there
///   {"at": 2, "screenshot": "shot.png"}
///   {"at": 3, "print": true}
/// Gives all errors, each with its line.
carom::Result<Script> parse_script(std::string_view text);

}  // namespace platform
