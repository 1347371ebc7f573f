#include "app/hud/practice_strip.hpp"

#include <array>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

struct Entry {
  PracticeCommand command;
  Text label;
  Text tip;
  float share;  ///< of the width, as long as the label is
};
const std::array<Entry, 6> entries{{
    {TakeBack{}, Text::take_back, Text::tip_take_back, 0.21f},
    {Repeat{}, Text::repeat, Text::tip_repeat, 0.18f},
    {Change::slower, Text::slower_throw, Text::tip_slower_throw, 0.165f},
    {Change::faster, Text::faster_throw, Text::tip_faster_throw, 0.165f},
    {Change::left, Text::turn_left, Text::tip_turn_left, 0.14f},
    {Change::right, Text::turn_right, Text::tip_turn_right, 0.14f},
}};

std::vector<Buttons::Button> numbered() {
  std::vector<Buttons::Button> buttons;
  for (ButtonId id = 0; id < entries.size(); ++id) buttons.push_back({id});
  return buttons;
}

}  // namespace

PracticeStrip::PracticeStrip(const Words& words) : words_(words), buttons_(numbered()) {}

float PracticeStrip::height(const View& view) { return view.px(view.touch ? 64 : 48); }

void PracticeStrip::resize(const View& view, const Rect& area) {
  area_ = area;
  const float gap = view.px(view.narrow() ? 4 : 8);
  Rect row = centered(area.center(), std::min(area.w, view.px(760)), area.h).inset(gap, view.px(5));
  const float room = row.w - gap * static_cast<float>(entries.size() - 1);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    buttons_.relabel(i, words_(entries[i].label));
    buttons_.explain(i, words_(entries[i].tip));
    buttons_.place(view, i, row.cut_left(room * entries[i].share));
    row.cut_left(gap);
  }
}

std::optional<PracticeCommand> PracticeStrip::event(const Input& input, Sounds& sounds) {
  // The keys of aiming do the same as the other buttons.
  if (is_key(input, Key::backspace)) return TakeBack{};
  if (is_command(input, Command::again)) return Repeat{};
  // The focus is moved from outside, through the bar's buttons too.
  if (is_key(input, Key::tab) || is_key(input, Key::back_tab)) return std::nullopt;
  const auto chosen = buttons_.event(input, sounds);
  return chosen ? std::optional(entries[*chosen].command) : std::nullopt;
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
