#include "app/input/pad.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

constexpr float dead_zone = 0.2f;
constexpr float flick = 0.6f;  ///< a stick so far out is a cross that is pressed
constexpr nanoseconds first_repeat = milliseconds{400};
constexpr nanoseconds next_repeat = milliseconds{60};

/// Start is a command instead.
KeyPressed key_of(PadButton button) {
  switch (button) {
    case PadButton::up:
      return {Key::up};
    case PadButton::down:
      return {Key::down};
    case PadButton::left:
      return {Key::left};
    case PadButton::right:
      return {Key::right};
    case PadButton::a:
      return {Key::enter};
    case PadButton::b:
      return {Key::escape};
    case PadButton::x:
      return {Key::tab};
    case PadButton::back:
      return {Key::back_tab, true};
    case PadButton::y:
      return {Key::help};
    case PadButton::left_shoulder:
      return {Key::left, true};
    case PadButton::right_shoulder:
    case PadButton::start:
      break;
  }
  return {Key::right, true};
}

bool is_cross(PadButton button) { return button <= PadButton::right; }

}  // namespace

float Pad::deflection(PadAxis axis) const {
  const float value = axes_[static_cast<std::size_t>(axis)];
  return std::copysign(std::max(std::abs(value) - dead_zone, 0.0f) / (1 - dead_zone), value);
}

std::optional<Key> Pad::stick_key() const {
  const float x = axes_[static_cast<std::size_t>(PadAxis::left_x)];
  const float y = axes_[static_cast<std::size_t>(PadAxis::left_y)];
  if (std::max(std::abs(x), std::abs(y)) < flick) return std::nullopt;
  if (std::abs(x) >= std::abs(y)) return x > 0 ? Key::right : Key::left;
  return y > 0 ? Key::down : Key::up;
}

void Pad::hold(std::optional<Key> key) {
  key_ = key;
  until_repeat_ = first_repeat;
}

std::vector<Input> Pad::event(const Input& input, bool steers) {
  if (const auto* pressed = std::get_if<PadPressed>(&input)) {
    if (pressed->button == PadButton::start) return {CommandPressed{Command::pause}};
    const KeyPressed key = key_of(pressed->button);
    if (is_cross(pressed->button)) hold(key.key);
    return {key};
  }
  if (const auto* released = std::get_if<PadReleased>(&input)) {
    if (released->button == PadButton::start) return {CommandReleased{Command::pause}};
    const Key key = key_of(released->button).key;
    if (is_cross(released->button) && key_ == key) hold({});
    return {KeyReleased{key}};
  }
  if (const auto* moved = std::get_if<PadMoved>(&input)) {
    // A value that is not a number would not be a direction either.
    float& axis = axes_[static_cast<std::size_t>(moved->axis)];
    const float before =
        std::exchange(axis, moved->value >= -1 && moved->value <= 1 ? moved->value : 0);
    if (moved->axis == PadAxis::right_trigger) {
      // The trigger that makes a throw stronger makes it pass quicker.
      if (axis > flick && before <= flick && !steers) return {CommandPressed{Command::fast}};
      if (axis <= flick && before > flick) return {CommandReleased{Command::fast}};
      return {};
    }
    const auto key = stick_key();
    if (key == stick_) return {};
    if (stick_ && key_ == stick_) hold({});
    stick_ = key;
    if (!key || steers) return {};
    hold(key);
    return {KeyPressed{*key}};
  }
  const bool hurries = axes_[static_cast<std::size_t>(PadAxis::right_trigger)] > flick;
  *this = {};
  if (hurries) return {CommandReleased{Command::fast}};
  return {};
}

bool Pad::held() const {
  return key_ || std::ranges::any_of(axes_, [](float a) { return std::abs(a) > dead_zone; });
}

std::vector<Input> Pad::advance(nanoseconds elapsed, bool steers) {
  std::vector<Input> inputs;
  if (key_) {
    until_repeat_ -= elapsed;
    if (until_repeat_ <= nanoseconds{0}) {
      until_repeat_ = next_repeat;
      inputs.emplace_back(KeyPressed{*key_});
    }
  }
  if (!steers) return inputs;
  const Steered steered{
      deflection(PadAxis::left_x), -deflection(PadAxis::left_y),
      std::clamp(-deflection(PadAxis::right_y) + deflection(PadAxis::right_trigger) -
                     deflection(PadAxis::left_trigger),
                 -1.0f, 1.0f),
      elapsed};
  if (steered.across != 0 || steered.up != 0 || steered.power != 0) inputs.emplace_back(steered);
  return inputs;
}

}  // namespace app
