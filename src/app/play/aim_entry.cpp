#include "app/play/aim_entry.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

constexpr double greatest_angle = 360;

bool is_digit(char sign) { return sign >= '0' && sign <= '9'; }

std::optional<double> number(std::string text) {
  std::ranges::replace(text, ',', '.');
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return value;
}

}  // namespace

bool AimEntry::accepts(char sign) {
  return is_digit(sign) || sign == '-' || sign == '.' || sign == ',';
}

void AimEntry::event(const Input& input) {
  std::string& text = text_[field_];
  if (const auto* typed = std::get_if<TextTyped>(&input)) {
    for (const char sign : typed->text) {
      const bool allowed = sign == '-' ? field_ == angle && text.empty()
                           : is_digit(sign)
                               ? true
                               : accepts(sign) && text.find_first_of(".,") == std::string::npos;
      if (allowed && text.size() < longest) text += sign;
    }
  } else if (is_key(input, Key::backspace)) {
    if (!text.empty()) text.pop_back();
  } else if (is_key(input, Key::tab) || is_key(input, Key::back_tab)) {
    field_ = field_ == angle ? speed : angle;
  }
}

void AimEntry::apply(Aim& aim) const {
  const auto degrees = number(text_[angle]);
  if (degrees && std::abs(*degrees) <= greatest_angle) aim.set_degrees(*degrees);
  if (const auto wanted = number(text_[speed])) aim.set_speed(*wanted);
}

void AimEntry::draw(Canvas& canvas, const Rect& area, const Words& words) const {
  const float gap = canvas.px(8);
  Rect rest = area;
  // A speed has the longer unit.
  const Rect first = rest.cut_left((rest.w - gap) * 0.44f);
  rest.cut_left(gap);
  const std::array boxes{first, rest};
  for (const Field field : {angle, speed}) {
    const bool focused = field == field_;
    const Rect& box = boxes[field];
    fill_rounded(canvas.list, box, canvas.px(5), palette::slate_bottom);
    stroke_rounded(canvas.list, box, canvas.px(5), canvas.px(focused ? 2 : 1),
                   focused ? palette::brass : palette::panel_edge);
    const std::string typed = text_[field] + (focused ? "|" : text_[field].empty() ? "–" : "");
    label(canvas, box.inset(canvas.px(4), 0),
          {Face::bold, 18, focused ? palette::cream : palette::muted, Align::center},
          words(field == angle ? Text::entered_angle : Text::entered_speed, {typed}));
  }
}

}  // namespace app
