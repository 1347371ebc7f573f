#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "app/geometry.hpp"

/// What the player does, free of any platform. Points are in window px.
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
  r,
  n,
  backspace,
  plus,
  minus,
  period,
  copy,   ///< Ctrl+C
  paste,  ///< Ctrl+V
  settings,
  f,
  m,
  p,
};

struct PointerMoved {
  Point at;
};
struct PointerPressed {
  Point at;
  PointerButton button = PointerButton::left;
};
struct PointerReleased {
  Point at;
  PointerButton button = PointerButton::left;
};
struct KeyPressed {
  Key key = Key::enter;
  bool shift = false;
  bool ctrl = false;
};
struct KeyReleased {
  Key key = Key::enter;
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
};

using Input = std::variant<PointerMoved, PointerPressed, PointerReleased, KeyPressed, KeyReleased,
                           TextTyped, WheelTurned, Resized>;

/// The key pressed, if `input` is one.
inline bool is_key(const Input& input, Key key) {
  const auto* pressed = std::get_if<KeyPressed>(&input);
  return pressed != nullptr && pressed->key == key;
}

}  // namespace app
