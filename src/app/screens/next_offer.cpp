#include "app/screens/next_offer.hpp"

namespace app {

void NextOffer::place(const View& view, const Rect& world, std::string label, std::string tip) {
  const float height = view.button(48);
  const Point middle{world.center().x, world.y + view.px(16) + height / 2};
  prompt_.relabel(0, std::move(label));
  prompt_.explain(0, std::move(tip));
  prompt_.place(view, 0, centered(middle, std::min(view.px(300), world.w - view.px(32)), height));
}

bool NextOffer::event(const Input& input, bool focus_elsewhere, bool on_button, Sounds& sounds) {
  const bool key = is_key(input, Key::enter) || is_key(input, Key::space);
  // The focus is moved from outside, through other buttons too.
  if (!std::holds_alternative<KeyPressed>(input) || (key && !focus_elsewhere))
    prompt_.event(input, sounds);
  if (const auto* press = std::get_if<PointerPressed>(&input))
    return press->button == PointerButton::left && !on_button;
  return is_command(input, Command::next) || (key && !focus_elsewhere);
}

}  // namespace app
