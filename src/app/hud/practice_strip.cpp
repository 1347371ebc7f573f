#include "app/hud/practice_strip.hpp"

#include <array>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

constexpr std::array labels{Text::take_back,    Text::repeat,    Text::slower_throw,
                            Text::faster_throw, Text::turn_left, Text::turn_right};

/// Of the width, as long as the labels are.
constexpr std::array shares{0.21f, 0.18f, 0.165f, 0.165f, 0.14f, 0.14f};

constexpr std::array tips{Text::tip_take_back,    Text::tip_repeat,    Text::tip_slower_throw,
                          Text::tip_faster_throw, Text::tip_turn_left, Text::tip_turn_right};

PracticeCommand command_of(std::size_t button) {
  constexpr std::array changes{Change::slower, Change::faster, Change::left, Change::right};
  if (button == 0) return TakeBack{};
  if (button == 1) return Repeat{};
  return changes[button - 2];
}

}  // namespace

PracticeStrip::PracticeStrip(const Words& words)
    : words_(words), buttons_(std::vector<std::string>(labels.size())) {}

float PracticeStrip::height(const View& view) { return view.px(view.touch ? 64 : 48); }

void PracticeStrip::resize(const View& view, const Rect& area) {
  area_ = area;
  const float gap = view.px(view.narrow() ? 4 : 8);
  Rect row = centered(area.center(), std::min(area.w, view.px(760)), area.h).inset(gap, view.px(5));
  const float room = row.w - gap * static_cast<float>(shares.size() - 1);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    buttons_.relabel(i, words_(labels[i]));
    buttons_.explain(i, words_(tips[i]));
    buttons_.place(view, i, row.cut_left(room * shares[i]));
    row.cut_left(gap);
  }
}

std::optional<PracticeCommand> PracticeStrip::event(const Input& input) {
  // What the other buttons do, the keys of aiming do.
  if (is_key(input, Key::backspace)) return TakeBack{};
  if (is_command(input, Command::again)) return Repeat{};
  // The focus is moved from outside, through the bar's buttons too.
  if (is_key(input, Key::tab) || is_key(input, Key::back_tab)) return std::nullopt;
  const auto chosen = buttons_.event(input);
  return chosen ? std::optional(command_of(*chosen)) : std::nullopt;
}

void PracticeStrip::draw(Canvas& canvas) const {
  fill_rounded(canvas.list, area_, 0,
               Paint::vertical(area_, palette::slate_top, palette::slate_bottom));
  line(canvas.list, {area_.x, area_.y}, {area_.right(), area_.y}, canvas.px(1),
       palette::brass_dark);
  buttons_.draw(canvas);
}

std::string practised(const Words& words, const Aim& aim) {
  return words(Text::practised, {words.tenths(aim.speed()), words.tenths(aim.degrees())});
}

}  // namespace app
