#pragma once

#include <cstdint>
#include <string>

#include "app/canvas.hpp"
#include "app/clock.hpp"
#include "app/input.hpp"

namespace app {

/// Where the player goes from a screen; `level` is the campaign's current one.
enum class Transition : std::uint8_t { stay, title, billiards, levels, level, quit };

/// What fills the window. Input and time go in; a picture and a transition come out.
class Screen {
 public:
  virtual ~Screen() = default;

  /// Called before all else, and whenever the window's size changes.
  virtual void resize(const View& view) = 0;
  virtual Transition event(const Input& input) = 0;
  virtual void iterate(nanoseconds elapsed) = 0;
  virtual void draw(Canvas& canvas) const = 0;
  /// What is on screen, in one line.
  virtual std::string describe() const = 0;
  /// The picture changes without input.
  virtual bool animating() const = 0;
};

}  // namespace app
