#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "app/base/time.hpp"
#include "app/graphics/geometry.hpp"

/// The player's input, free of any platform. Points are in window px.
namespace app {

enum class PointerButton : std::uint8_t { left, right };
enum class Key : std::uint8_t {
  enter,
  space,
  tab,
  back_tab,
  escape,
  left,
  right,
  up,
  down,
  backspace,
  plus,
  minus,
  period,
  copy,      ///< Ctrl+C
  paste,     ///< Ctrl+V
  help,      ///< F1
  settings,  ///< F10
  // By its place on the keyboard: what is printed there in the United States. Only key bindings
  // know letters: screens get CommandPressed instead.
  // clang-format off
  a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
  // clang-format on
};

/// The effect of a letter, which the player can move to another one (key_bindings.hpp). Other keys
/// are fixed.
enum class Command : std::uint8_t {
  again,  ///< starts anew; in practice repeats the throw
  next,   ///< the next throw
  pause,
  fast,  ///< as long as it is held
  mute,
  hint,  ///< shows a good shot, or more of it
};

struct PointerMoved {
  Point at;
};
struct PointerPressed {
  Point at;
  PointerButton button = PointerButton::left;
  bool touch = false;  ///< by a finger
};
struct PointerReleased {
  Point at;
  PointerButton button = PointerButton::left;
};
/// The pointer is nowhere any more: a finger was lifted.
struct PointerLeft {};
/// The pointer's press is taken back, and the pointer is nowhere any more.
struct PointerCancelled {};
struct KeyPressed {
  Key key = Key::enter;
  bool shift = false;
  bool ctrl = false;
};
struct KeyReleased {
  Key key = Key::enter;
};
struct CommandPressed {
  Command command{};
};
struct CommandReleased {
  Command command{};
};
struct WheelTurned {
  float notches = 0;  ///< away from the player is positive
};
/// Text, whatever keys that took.
struct TextTyped {
  std::string text;  ///< UTF-8
};
/// The window's new size, px.
struct Resized {
  int width = 800;
  int height = 600;
  float density = 1;  ///< px a point of the screen, as View::of() takes it
};

/// One of several fingers; screens get what it means for the pointer (fingers.hpp).
struct Finger {
  enum class Phase : std::uint8_t { down, moved, up };
  std::int64_t id = 0;
  Phase phase = Phase::down;
  Point at;
};

enum class PadButton : std::uint8_t {
  up,
  down,
  left,
  right,
  a,  ///< the lower one of four
  b,  ///< the right one
  x,  ///< the left one
  y,  ///< the upper one
  start,
  back,
  left_shoulder,
  right_shoulder,
};
enum class PadAxis : std::uint8_t { left_x, left_y, right_x, right_y, left_trigger, right_trigger };
// A gamepad's; screens get keys, and Steered (pad.hpp).
struct PadPressed {
  PadButton button = PadButton::a;
};
struct PadReleased {
  PadButton button = PadButton::a;
};
struct PadMoved {
  PadAxis axis = PadAxis::left_x;
  float value = 0;  ///< in [−1, 1], to the right and down; of a trigger in [0, 1]
};
/// All is let go.
struct PadUnplugged {};
/// Sticks are held for a time. Each in [−1, 1].
struct Steered {
  float across = 0;  ///< to the right
  float up = 0;
  float power = 0;
  nanoseconds time{};
};

using Input =
    std::variant<PointerMoved, PointerPressed, PointerReleased, PointerLeft, PointerCancelled,
                 KeyPressed, KeyReleased, CommandPressed, CommandReleased, TextTyped, WheelTurned,
                 Resized, Finger, PadPressed, PadReleased, PadMoved, PadUnplugged, Steered>;

/// The key pressed, if `input` is one.
inline bool is_key(const Input& input, Key key) {
  const auto* pressed = std::get_if<KeyPressed>(&input);
  return pressed != nullptr && pressed->key == key;
}

/// The command pressed, if `input` is one.
inline bool is_command(const Input& input, Command command) {
  const auto* pressed = std::get_if<CommandPressed>(&input);
  return pressed != nullptr && pressed->command == command;
}

/// A key or a command is pressed, whichever.
inline bool is_press_of_key(const Input& input) {
  return std::holds_alternative<KeyPressed>(input) || std::holds_alternative<CommandPressed>(input);
}

}  // namespace app
