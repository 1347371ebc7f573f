#pragma once

#include <SDL.h>
#include <array>
#include <map>

namespace platform {

/// The gamepads of the page, those whose layout the browser knows ("standard"). SDL is built
/// without its own, so that it is small; these give the same events. Make one only: it lives as
/// long as the page does.
class BrowserGamepads {
 public:
  BrowserGamepads();
  BrowserGamepads(const BrowserGamepads&) = delete;
  BrowserGamepads& operator=(const BrowserGamepads&) = delete;

  /// Gives SDL events of what has changed since the last call. To be called once a frame; costs
  /// nothing while no gamepad is connected.
  void poll();

 private:
  struct State {
    std::array<bool, SDL_CONTROLLER_BUTTON_MAX> buttons{};
    std::array<Sint16, SDL_CONTROLLER_AXIS_MAX> axes{};
  };

  void poll(int pad, State& last);

  std::map<int, State> pads_;  ///< by the number that the browser gives
};

}  // namespace platform
