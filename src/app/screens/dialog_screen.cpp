#include "app/screens/dialog_screen.hpp"

#include <utility>

namespace app {

Navigation DialogScreen::event(const Input& input) {
  for (const auto& [press, answer] : ask_.shortcuts) {
    const auto* key = std::get_if<Key>(&press);
    if (key ? is_key(input, *key) : is_command(input, std::get<Command>(press)))
      return Answer{answer};
  }
  const auto chosen = ask_.dialog.event(input, sounds_);
  if (!chosen) return Stay{};
  if (ask_.message) return Back{};
  return Answer{*chosen};
}

Ask message(const Words& words, const std::string& title, std::vector<Dialog::Line> lines) {
  return {.dialog =
              Dialog(title, std::move(lines), {{0, words(Text::ok), words(Text::tip_close_help)}}),
          .line = words(Text::product) + " · " + title,
          .message = true};
}

}  // namespace app
