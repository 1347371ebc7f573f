#include "platform/browser_gamepads.hpp"

#include <algorithm>
#include <emscripten/html5.h>
#include <string_view>

namespace platform {
namespace {

constexpr auto none = SDL_CONTROLLER_BUTTON_INVALID;

// By the numbers of the Gamepad API's standard layout; 6 and 7 are the triggers, axes of SDL's.
constexpr std::array buttons{SDL_CONTROLLER_BUTTON_A,
                             SDL_CONTROLLER_BUTTON_B,
                             SDL_CONTROLLER_BUTTON_X,
                             SDL_CONTROLLER_BUTTON_Y,
                             SDL_CONTROLLER_BUTTON_LEFTSHOULDER,
                             SDL_CONTROLLER_BUTTON_RIGHTSHOULDER,
                             none,
                             none,
                             SDL_CONTROLLER_BUTTON_BACK,
                             SDL_CONTROLLER_BUTTON_START,
                             SDL_CONTROLLER_BUTTON_LEFTSTICK,
                             SDL_CONTROLLER_BUTTON_RIGHTSTICK,
                             SDL_CONTROLLER_BUTTON_DPAD_UP,
                             SDL_CONTROLLER_BUTTON_DPAD_DOWN,
                             SDL_CONTROLLER_BUTTON_DPAD_LEFT,
                             SDL_CONTROLLER_BUTTON_DPAD_RIGHT};
constexpr std::array sticks{SDL_CONTROLLER_AXIS_LEFTX, SDL_CONTROLLER_AXIS_LEFTY,
                            SDL_CONTROLLER_AXIS_RIGHTX, SDL_CONTROLLER_AXIS_RIGHTY};
constexpr std::array triggers{SDL_CONTROLLER_AXIS_TRIGGERLEFT, SDL_CONTROLLER_AXIS_TRIGGERRIGHT};
constexpr std::size_t first_trigger = 6;

Sint16 axis_value(double value) {  // in [−1, 1]; anything may come from a page
  return static_cast<Sint16>(value >= -1 && value <= 1 ? value * SDL_JOYSTICK_AXIS_MAX : 0);
}

void push_unplugged(int pad) {
  SDL_Event event{};
  event.type = SDL_CONTROLLERDEVICEREMOVED;
  event.cdevice.which = pad;
  SDL_PushEvent(&event);
}

}  // namespace

BrowserGamepads::BrowserGamepads() {
  emscripten_set_gamepadconnected_callback(
      this, false, [](int, const EmscriptenGamepadEvent* event, void* pads) -> EM_BOOL {
        if (std::string_view(event->mapping) == "standard")
          static_cast<BrowserGamepads*>(pads)->pads_.try_emplace(event->index);
        return false;
      });
  emscripten_set_gamepaddisconnected_callback(
      this, false, [](int, const EmscriptenGamepadEvent* event, void* pads) -> EM_BOOL {
        if (static_cast<BrowserGamepads*>(pads)->pads_.erase(event->index) != 0)
          push_unplugged(event->index);
        return false;
      });
}

void BrowserGamepads::poll() {
  if (pads_.empty() || emscripten_sample_gamepad_data() != EMSCRIPTEN_RESULT_SUCCESS) return;
  for (auto& [pad, last] : pads_) poll(pad, last);
}

void BrowserGamepads::poll(int pad, State& last) {
  EmscriptenGamepadEvent now{};
  if (emscripten_get_gamepad_status(pad, &now) != EMSCRIPTEN_RESULT_SUCCESS) return;
  const auto count = static_cast<std::size_t>(std::clamp(now.numButtons, 0, 64));
  for (std::size_t i = 0; i < std::min(buttons.size(), count); ++i) {
    if (buttons[i] == none) continue;
    bool& was = last.buttons[static_cast<std::size_t>(buttons[i])];
    const bool is = now.digitalButton[i];
    if (is == was) continue;
    was = is;
    SDL_Event event{};
    event.type = is ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
    event.cbutton.which = pad;
    event.cbutton.button = static_cast<Uint8>(buttons[i]);
    SDL_PushEvent(&event);
  }
  const auto move = [&](SDL_GameControllerAxis axis, double value) {
    Sint16& was = last.axes[static_cast<std::size_t>(axis)];
    const Sint16 is = axis_value(value);
    if (is == was) return;
    was = is;
    SDL_Event event{};
    event.type = SDL_CONTROLLERAXISMOTION;
    event.caxis.which = pad;
    event.caxis.axis = static_cast<Uint8>(axis);
    event.caxis.value = is;
    SDL_PushEvent(&event);
  };
  const auto axes = static_cast<std::size_t>(std::clamp(now.numAxes, 0, 64));
  for (std::size_t i = 0; i < std::min(sticks.size(), axes); ++i) move(sticks[i], now.axis[i]);
  for (std::size_t i = 0; i < triggers.size() && first_trigger + i < count; ++i)
    move(triggers[i], now.analogButton[first_trigger + i]);
}

}  // namespace platform
