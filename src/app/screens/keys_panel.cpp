#include "app/screens/keys_panel.hpp"

#include <algorithm>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"

namespace app {
namespace {

constexpr std::array names{Text::key_again, Text::key_next, Text::key_pause, Text::key_fast,
                           Text::key_mute};
static_assert(names.size() == all_commands.size());

}  // namespace

KeysPanel::KeysPanel(const Words& words, Keyboard& keyboard)
    : words_(words),
      keyboard_(keyboard),
      buttons_(std::vector<std::string>(all_commands.size() + 2)) {
  for (std::size_t i = 0; i < all_commands.size(); ++i) buttons_.explain(i, words_(Text::tip_key));
  buttons_.explain(all_commands.size(), words_(Text::tip_defaults));
  buttons_.explain(all_commands.size() + 1, words_(Text::tip_close_help));
  relabel();
}

void KeysPanel::relabel() {
  for (std::size_t i = 0; i < all_commands.size(); ++i)
    buttons_.relabel(
        i, wanted_ == all_commands[i]
               ? words_(Text::key_wanted, {words_(names[i])})
               : words_(Text::key_line, {words_(names[i]), keyboard_.name(all_commands[i])}));
  buttons_.relabel(all_commands.size(), words_(Text::key_defaults));
  buttons_.relabel(all_commands.size() + 1, words_(Text::help_back));
}

void KeysPanel::resize(const View& view, const Rect& area) {
  Rect rest = centered(area.center(), std::min(area.w, view.px(440)), area.h);
  const bool low = view.height < view.px(480);
  head_ = rest.cut_top(view.px(low ? 36 : 48));
  const float gap = view.px(low ? 4 : 10);
  Rect ends = rest.cut_bottom(view.button(48));
  rest.cut_bottom(gap);
  foot_ = rest.cut_bottom(view.px(28));
  // In a low window the lines move together.
  const float pitch =
      std::min(view.button(48) + view.px(8), rest.h / static_cast<float>(all_commands.size()));
  for (std::size_t i = 0; i < all_commands.size(); ++i)
    buttons_.place(view, i, rest.cut_top(pitch).inset(0, view.px(low ? 1 : view.touch ? 2 : 4)));
  buttons_.place(view, all_commands.size(), ends.cut_left((ends.w - gap) / 2));
  ends.cut_left(gap);
  buttons_.place(view, all_commands.size() + 1, ends);
}

bool KeysPanel::event(const Input& input) {
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
  const auto chosen = buttons_.event(input);
  if (!chosen) return true;
  message_.clear();
  wanted_.reset();
  if (*chosen > all_commands.size()) return false;
  if (*chosen == all_commands.size())
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
