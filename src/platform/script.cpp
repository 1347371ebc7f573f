#include "platform/script.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "carom/scene.hpp"
#include "json/limits.hpp"

namespace platform {
namespace {

using nlohmann::json;

constexpr double longest = 86'400;  ///< s
constexpr double widest = 100'000;  ///< px

constexpr std::array<std::pair<std::string_view, app::Key>, 17> keys{{
    {"Return", app::Key::enter},
    {"Space", app::Key::space},
    {"Tab", app::Key::tab},
    {"Shift+Tab", app::Key::back_tab},
    {"Escape", app::Key::escape},
    {"Left", app::Key::left},
    {"Right", app::Key::right},
    {"Up", app::Key::up},
    {"Down", app::Key::down},
    {"F1", app::Key::help},
    {"Backspace", app::Key::backspace},
    {"+", app::Key::plus},
    {"-", app::Key::minus},
    {".", app::Key::period},
    {"Ctrl+C", app::Key::copy},
    {"Ctrl+V", app::Key::paste},
    {"F10", app::Key::settings},
}};

constexpr std::string_view key_names =
    "Return, Space, Tab, Shift+Tab, Escape, Left, Right, Up, Down (these four also with Shift+ or "
    "Ctrl+), A to Z, Backspace, +, -, ., F1, F10, Ctrl+C or Ctrl+V";

constexpr std::array<std::pair<std::string_view, app::PadButton>, 12> pad_buttons{{
    {"Up", app::PadButton::up},
    {"Down", app::PadButton::down},
    {"Left", app::PadButton::left},
    {"Right", app::PadButton::right},
    {"A", app::PadButton::a},
    {"B", app::PadButton::b},
    {"X", app::PadButton::x},
    {"Y", app::PadButton::y},
    {"Start", app::PadButton::start},
    {"Back", app::PadButton::back},
    {"LB", app::PadButton::left_shoulder},
    {"RB", app::PadButton::right_shoulder},
}};
constexpr std::string_view pad_button_names =
    "Up, Down, Left, Right, A, B, X, Y, Start, Back, LB or RB";
constexpr std::array<std::pair<std::string_view, app::PadAxis>, 6> pad_axes{{
    {"left_x", app::PadAxis::left_x},
    {"left_y", app::PadAxis::left_y},
    {"right_x", app::PadAxis::right_x},
    {"right_y", app::PadAxis::right_y},
    {"left_trigger", app::PadAxis::left_trigger},
    {"right_trigger", app::PadAxis::right_trigger},
}};
constexpr int most_fingers = 10;

constexpr std::string_view line_form =
    "an object with \"at\" and one of \"click\", \"move\", \"press\", \"release\", \"wheel\", "
    "\"key\", \"hold\", \"let_go\", \"type\", \"touch\", \"touch_move\", \"touch_end\", \"pad\", "
    "\"pad_hold\", \"pad_let_go\", \"stick\", \"screenshot\", \"print\"";
constexpr double most_notches = 1000;

std::optional<app::Point> point(const json& value) {
  if (!value.is_array() || value.size() != 2) return std::nullopt;
  for (const json& number : value)
    if (!number.is_number() || !(std::abs(number.get<double>()) <= widest)) return std::nullopt;
  return app::Point{value[0].get<float>(), value[1].get<float>()};
}

std::optional<app::KeyPressed> key(const json& value) {
  if (!value.is_string()) return std::nullopt;
  std::string_view wanted = value.get_ref<const std::string&>();
  for (const auto& [name, key] : keys)
    if (wanted == name) return app::KeyPressed{key, key == app::Key::back_tab};
  if (wanted.size() == 1 && wanted[0] >= 'A' && wanted[0] <= 'Z')
    return app::KeyPressed{
        static_cast<app::Key>(static_cast<int>(app::Key::a) + (wanted[0] - 'A'))};
  app::KeyPressed pressed;
  if (wanted.starts_with("Shift+"))
    pressed.shift = true;
  else if (wanted.starts_with("Ctrl+"))
    pressed.ctrl = true;
  else
    return std::nullopt;
  wanted.remove_prefix(wanted.find('+') + 1);
  for (const auto& [name, key] : keys) {
    const bool arrow = key == app::Key::left || key == app::Key::right || key == app::Key::up ||
                       key == app::Key::down;
    if (!arrow || wanted != name) continue;
    pressed.key = key;
    return pressed;
  }
  return std::nullopt;
}

template <class Named>
auto named(const Named& table, const json& value) {
  using Meant = typename Named::value_type::second_type;
  if (value.is_string())
    for (const auto& [name, meant] : table)
      if (value.get_ref<const std::string&>() == name) return std::optional<Meant>(meant);
  return std::optional<Meant>();
}

/// ["left_x", 0.5]
std::optional<app::PadMoved> stick(const json& value) {
  if (!value.is_array() || value.size() != 2 || !value[1].is_number()) return std::nullopt;
  const auto axis = named(pad_axes, value[0]);
  const auto to = value[1].get<double>();
  if (!axis || !(std::abs(to) <= 1)) return std::nullopt;
  if (to < 0 && *axis >= app::PadAxis::left_trigger) return std::nullopt;
  return app::PadMoved{*axis, value[1].get<float>()};
}

carom::Error wrong(std::string pointer, const json& value, std::string expected) {
  return {.pointer = std::move(pointer),
          .problem = "is " + value.dump(-1, ' ', false, json::error_handler_t::replace),
          .expected = std::move(expected)};
}

carom::Result<ScriptLine> parse_line(std::string_view text) {
  const json line = ::json::parse(text);
  if (line.is_discarded() || !line.is_object())
    return carom::Error{
        .pointer = {}, .problem = "is no JSON object", .expected = std::string(line_form)};
  ScriptLine result;
  int actions = 0;
  for (const auto& [name, value] : line.items()) {
    if (name == "at") {
      if (!value.is_number() || !(value.get<double>() >= 0 && value.get<double>() <= longest))
        return wrong("/at", value, "a time from 0 to 86400 (s)");
      result.at = std::chrono::nanoseconds(std::llround(value.get<double>() * 1e9));
    } else if (name == "click" || name == "move" || name == "press" || name == "release") {
      const auto at = point(value);
      if (!at) return wrong("/" + name, value, "a point of the window, [x, y] (px)");
      ++actions;
      if (name == "click")
        result.action = Click{*at};
      else if (name == "move")
        result.action = Move{*at};
      else if (name == "press")
        result.action = PointerDown{*at};
      else
        result.action = PointerUp{*at};
    } else if (name == "wheel") {
      if (!value.is_number() || !(std::abs(value.get<double>()) <= most_notches))
        return wrong("/wheel", value, "notches, from -1000 to 1000");
      ++actions;
      result.action = Wheel{value.get<float>()};
    } else if (name == "key" || name == "hold" || name == "let_go") {
      const auto pressed = key(value);
      if (!pressed) return wrong("/" + name, value, std::string(key_names));
      ++actions;
      if (name == "key")
        result.action = Press{*pressed};
      else if (name == "hold")
        result.action = Hold{pressed->key};
      else
        result.action = LetGo{pressed->key};
    } else if (name == "type") {
      if (!value.is_string()) return wrong("/type", value, "a text");
      ++actions;
      result.action = Type{value.get<std::string>()};
    } else if (name == "touch" || name == "touch_move" || name == "touch_end") {
      const auto at = point(value);
      if (!at) return wrong("/" + name, value, "a point of the window, [x, y] (px)");
      ++actions;
      using Phase = app::Finger::Phase;
      const Phase phase = name == "touch"        ? Phase::down
                          : name == "touch_move" ? Phase::moved
                                                 : Phase::up;
      result.action = Touch{{0, phase, *at}};
    } else if (name == "pad" || name == "pad_hold" || name == "pad_let_go") {
      const auto button = named(pad_buttons, value);
      if (!button) return wrong("/" + name, value, std::string(pad_button_names));
      ++actions;
      if (name == "pad")
        result.action = PadPress{*button};
      else if (name == "pad_hold")
        result.action = PadInput{app::PadPressed{*button}};
      else
        result.action = PadInput{app::PadReleased{*button}};
    } else if (name == "stick") {
      const auto moved = stick(value);
      if (!moved)
        return wrong("/stick", value,
                     "an axis and how far, such as [\"left_x\", -0.5]; left_x, left_y, right_x, "
                     "right_y from -1 to 1, left_trigger, right_trigger from 0 to 1");
      ++actions;
      result.action = PadInput{*moved};
    } else if (name == "screenshot") {
      // The system would take a name up to its first NUL.
      const auto* const file = value.get_ptr<const std::string*>();
      if (!file || file->empty() || file->find('\0') != std::string::npos)
        return wrong("/screenshot", value, "the name of a PNG file to write");
      ++actions;
      result.action = Screenshot{*file};
    } else if (name == "print") {
      if (value != true) return wrong("/print", value, "true");
      ++actions;
      result.action = Print{};
    } else if (name != "button" && name != "finger") {
      return carom::Error{.pointer = "/" + name,
                          .problem = "is an unknown key",
                          .expected = std::string(line_form)};
    }
  }
  if (!line.contains("at") || actions != 1)
    return carom::Error{
        .pointer = {}, .problem = "is " + std::string(text), .expected = std::string(line_form)};
  if (line.contains("finger")) {
    const json& finger = line["finger"];
    auto* touch = std::get_if<Touch>(&result.action);
    if (!touch || !finger.is_number_integer() || finger < 0 || finger >= most_fingers)
      return wrong("/finger", finger, "a number from 0 to 9, beside a touch");
    touch->finger.id = finger.get<int>();
  }
  if (line.contains("button")) {
    const json& button = line["button"];
    auto* click = std::get_if<Click>(&result.action);
    if (!click || (button != "left" && button != "right"))
      return wrong("/button", button, "\"left\" or \"right\", beside \"click\"");
    if (button == "right") click->button = app::PointerButton::right;
  }
  return result;
}

}  // namespace

carom::Result<Script> parse_script(std::string_view text) {
  Script script;
  carom::Errors errors;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;

    auto parsed = parse_line(line);
    if (parsed && !script.empty() && parsed.value().at < script.back().at)
      parsed = carom::Error{.pointer = "/at",
                            .problem = "goes back in time",
                            .expected = "lines in the order of time"};
    if (parsed) {
      script.push_back(std::move(parsed.value()));
    } else if (errors.size() < carom::max_errors) {
      carom::Error error = parsed.errors().front();
      error.line = number;
      errors.push_back(std::move(error));
    }
  }
  if (!errors.empty()) return errors;
  return script;
}

}  // namespace platform
