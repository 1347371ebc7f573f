#include "platform/sdl_input.hpp"

#include <algorithm>

namespace platform {

std::optional<app::Key> key_of(const SDL_Keysym& key) {
  if ((key.mod & KMOD_CTRL) != 0) {
    // These are known by their letters everywhere.
    if (key.sym == SDLK_c) return app::Key::copy;
    if (key.sym == SDLK_v) return app::Key::paste;
  }
  if (key.scancode >= SDL_SCANCODE_A && key.scancode <= SDL_SCANCODE_Z) {
    if ((key.mod & KMOD_CTRL) != 0) return std::nullopt;
    return static_cast<app::Key>(static_cast<int>(app::Key::a) + (key.scancode - SDL_SCANCODE_A));
  }
  switch (key.sym) {
    case SDLK_RETURN:
    case SDLK_KP_ENTER:
      return app::Key::enter;
    case SDLK_SPACE:
      return app::Key::space;
    case SDLK_TAB:
      return (key.mod & KMOD_SHIFT) != 0 ? app::Key::back_tab : app::Key::tab;
    case SDLK_ESCAPE:
      return app::Key::escape;
    case SDLK_LEFT:
      return app::Key::left;
    case SDLK_RIGHT:
      return app::Key::right;
    case SDLK_UP:
      return app::Key::up;
    case SDLK_DOWN:
      return app::Key::down;
    case SDLK_BACKSPACE:
      return app::Key::backspace;
    case SDLK_F10:
      return app::Key::settings;
    case SDLK_F1:
      return app::Key::help;
    default:
      return std::nullopt;
  }
}

std::string label_of(app::Key letter) {
  const auto code = static_cast<SDL_Scancode>(
      SDL_SCANCODE_A + (static_cast<int>(letter) - static_cast<int>(app::Key::a)));
  return SDL_GetKeyName(SDL_GetKeyFromScancode(code));
}

std::optional<app::PadButton> pad_button_of(int button) {
  switch (button) {
    case SDL_CONTROLLER_BUTTON_DPAD_UP:
      return app::PadButton::up;
    case SDL_CONTROLLER_BUTTON_DPAD_DOWN:
      return app::PadButton::down;
    case SDL_CONTROLLER_BUTTON_DPAD_LEFT:
      return app::PadButton::left;
    case SDL_CONTROLLER_BUTTON_DPAD_RIGHT:
      return app::PadButton::right;
    case SDL_CONTROLLER_BUTTON_A:
      return app::PadButton::a;
    case SDL_CONTROLLER_BUTTON_B:
      return app::PadButton::b;
    case SDL_CONTROLLER_BUTTON_X:
      return app::PadButton::x;
    case SDL_CONTROLLER_BUTTON_Y:
      return app::PadButton::y;
    case SDL_CONTROLLER_BUTTON_START:
      return app::PadButton::start;
    case SDL_CONTROLLER_BUTTON_BACK:
      return app::PadButton::back;
    case SDL_CONTROLLER_BUTTON_LEFTSHOULDER:
      return app::PadButton::left_shoulder;
    case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER:
      return app::PadButton::right_shoulder;
    default:
      return std::nullopt;
  }
}

std::optional<app::PadMoved> pad_moved(const SDL_ControllerAxisEvent& event) {
  // The range is −32768 to 32767.
  const float value = std::max(static_cast<float>(event.value) / SDL_JOYSTICK_AXIS_MAX, -1.0f);
  switch (event.axis) {
    case SDL_CONTROLLER_AXIS_LEFTX:
      return app::PadMoved{app::PadAxis::left_x, value};
    case SDL_CONTROLLER_AXIS_LEFTY:
      return app::PadMoved{app::PadAxis::left_y, value};
    case SDL_CONTROLLER_AXIS_RIGHTX:
      return app::PadMoved{app::PadAxis::right_x, value};
    case SDL_CONTROLLER_AXIS_RIGHTY:
      return app::PadMoved{app::PadAxis::right_y, value};
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT:
      return app::PadMoved{app::PadAxis::left_trigger, value};
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT:
      return app::PadMoved{app::PadAxis::right_trigger, value};
    default:
      return std::nullopt;
  }
}

std::optional<app::Input> Gamepads::event(const SDL_Event& event) {
  switch (event.type) {
#ifdef __EMSCRIPTEN__
    case SDL_CONTROLLERDEVICEREMOVED:
      return app::PadUnplugged{};
#else
    case SDL_CONTROLLERDEVICEADDED:
      if (SDL_GameController* pad = SDL_GameControllerOpen(event.cdevice.which)) {
        const SDL_JoystickID id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad));
        open_[id].reset(pad);
      }
      return std::nullopt;
    case SDL_CONTROLLERDEVICEREMOVED:
      open_.erase(event.cdevice.which);
      return app::PadUnplugged{};
#endif
    case SDL_CONTROLLERBUTTONDOWN:
      if (const auto button = pad_button_of(event.cbutton.button)) return app::PadPressed{*button};
      return std::nullopt;
    case SDL_CONTROLLERBUTTONUP:
      if (const auto button = pad_button_of(event.cbutton.button)) return app::PadReleased{*button};
      return std::nullopt;
    case SDL_CONTROLLERAXISMOTION:
      if (const auto moved = pad_moved(event.caxis)) return *moved;
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace platform
