#include "app/screens/keys_panel.hpp"

#include <algorithm>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"

namespace app {
namespace {

constexpr std::array names{Text::key_again, Text::key_next, Text::key_pause,
                           Text::key_fast,  Text::key_mute, Text::key_hint};
static_assert(names.size() == all_commands.size());

}  // namespace

KeysPanel::KeysPanel(const Words& words, Keyboard& keyboard) : words_(words), keyboard_(keyboard) {
  std::vector<Buttons::Button> buttons;
  for (const Command command : all_commands)
    buttons.push_back({id_of(command), {}, words_(Text::tip_key)});
  buttons.push_back({defaults, words_(Text::key_defaults), words_(Text::tip_defaults)});
  buttons.push_back({back, words_(Text::help_back), words_(Text::tip_close_help)});
  buttons_ = Buttons(std::move(buttons));
  relabel();
}

void KeysPanel::relabel() {
  for (const Command command : all_commands) {
    const std::string name = words_(names[id_of(command)]);
    buttons_.relabel(id_of(command), wanted_ == command
                                         ? words_(Text::key_wanted, {name})
                                         : words_(Text::key_line, {name, keyboard_.name(command)}));
  }
}

void KeysPanel::resize(const View& view, const Rect& area) {
  const bool low = view.height < view.px(480);
  // In a low window two stand side by side, if it is wide enough.
  const std::size_t columns = low && view.width >= view.px(620) ? 2 : 1;
  Rect rest = centered(area.center(), std::min(area.w, view.px(columns == 2 ? 640 : 440)), area.h);
  head_ = rest.cut_top(view.px(low ? 36 : 48));
  const float gap = view.px(low ? 4 : 10);
  Rect ends = rest.cut_bottom(view.button(48));
  rest.cut_bottom(gap);
  foot_ = rest.cut_bottom(view.px(28));
  const std::size_t rows = (all_commands.size() + columns - 1) / columns;
  const float pitch = std::min(view.button(48) + view.px(8), rest.h / static_cast<float>(rows));
  const float width =
      (rest.w - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  const float between = view.px(low ? 1 : view.touch ? 2 : 4);
  Rect row;
  for (const Command command : all_commands) {
    if (id_of(command) % columns == 0) row = rest.cut_top(pitch).inset(0, between);
    buttons_.place(view, id_of(command), row.cut_left(width));
    row.cut_left(gap);
  }
  buttons_.set_columns(columns);
  buttons_.place(view, defaults, ends.cut_left((ends.w - gap) / 2));
  ends.cut_left(gap);
  buttons_.place(view, back, ends);
}

bool KeysPanel::event(const Input& input, Sounds& sounds) {
  const auto* key = std::get_if<KeyPressed>(&input);
  if (wanted_ && key) {
    const Command command = *std::exchange(wanted_, std::nullopt);
    message_.clear();
    if (key->key != Key::escape && !keyboard_.bindings.bind(command, key->key)) {
      message_ = words_(is_letter(key->key) ? Text::key_taken : Text::key_no_letter);
      wanted_ = command;
    }
    relabel();
    return true;
  }
  if (is_key(input, Key::escape) || is_key(input, Key::help)) return false;
  const auto chosen = buttons_.event(input, sounds);
  if (!chosen) return true;
  message_.clear();
  wanted_.reset();
  if (*chosen == back) return false;
  if (*chosen == defaults)
    keyboard_.bindings = {};
  else
    wanted_ = all_commands[*chosen];
  relabel();
  return true;
}

void KeysPanel::draw(Canvas& canvas) const {
  label(canvas, head_, {Face::black, 28, palette::cream, Align::center}, words_(Text::keys_title));
  buttons_.draw(canvas, 18);
  label(canvas, foot_,
        {Face::regular, 16, message_.empty() ? palette::muted : canvas.list.palette->refused,
         Align::center},
        message_.empty() ? words_(Text::hint_keys_panel) : message_);
}

}  // namespace app
