#pragma once

#include <SDL.h>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/input/input.hpp"

/// SDL's input in the app's terms.
namespace platform {

/// The key, letters by their place; none: nothing of ours.
std::optional<app::Key> key_of(const SDL_Keysym& key);
/// The print on a letter's key.
std::string label_of(app::Key letter);
std::optional<app::PadButton> pad_button_of(int button);
/// Of SDL_CONTROLLERAXISMOTION.
std::optional<app::PadMoved> pad_moved(const SDL_ControllerAxisEvent& event);

/// The gamepads that are plugged in, opened as long as they are (a page has others:
/// browser_gamepads.hpp). All are one to the app.
class Gamepads {
 public:
  /// Returns the app's input; none: no event of a gamepad, or none that matters.
  std::optional<app::Input> event(const SDL_Event& event);

#ifndef __EMSCRIPTEN__
 private:
  struct Close {
    void operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }
  };
  std::map<SDL_JoystickID, std::unique_ptr<SDL_GameController, Close>> open_;
#endif
};

}  // namespace platform
