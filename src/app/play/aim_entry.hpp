#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "app/graphics/canvas.hpp"
#include "app/input/input.hpp"
#include "app/play/aim.hpp"
#include "app/text/text.hpp"

namespace app {

/// Two fields into which a launch is typed: its angle in degrees, its speed in px/s. A field left
/// empty changes nothing.
class AimEntry {
 public:
  /// Is true if a sign can be part of a number.
  static bool accepts(char sign);

  /// Digits, a point or comma, and a minus before an angle; Tab changes the field, Backspace takes
  /// a sign back. Takes every key.
  void event(const Input& input);
  /// Sets what is typed: an angle, and a speed as Aim::set_speed() takes it. A text that is not a
  /// number changes nothing.
  void apply(Aim& aim) const;
  /// Fills `area`.
  void draw(Canvas& canvas, const Rect& area, const Words& words) const;

  /// Nothing is typed.
  bool empty() const { return text_[0].empty() && text_[1].empty(); }

 private:
  enum Field : std::size_t { angle, speed };
  static constexpr std::size_t longest = 8;

  std::array<std::string, 2> text_;
  Field field_ = angle;
};

}  // namespace app
