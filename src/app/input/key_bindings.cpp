#include "app/input/key_bindings.hpp"

#include <algorithm>

namespace app {
namespace {

constexpr std::array<std::string_view, all_commands.size()> names{"again", "next", "pause",
                                                                  "fast",  "mute", "hint"};

char letter(Key key) {
  return static_cast<char>('a' + (static_cast<int>(key) - static_cast<int>(Key::a)));
}

carom::Error wrong(std::string problem, std::string expected) {
  return {.pointer = {}, .problem = std::move(problem), .expected = std::move(expected)};
}

}  // namespace

carom::Status KeyBindings::bind(Command command, Key key) {
  if (!is_letter(key)) return wrong("is no letter", "a letter");
  for (const Command other : all_commands)
    if (other != command && key_of(other) == key)
      return wrong("\"" + std::string(1, letter(key)) + "\" is taken by \"" +
                       std::string(names[static_cast<std::size_t>(other)]) + "\"",
                   "a letter that is free");
  keys_[static_cast<std::size_t>(command)] = key;
  return carom::Done{};
}

std::optional<Command> KeyBindings::command_of(Key key) const {
  for (const Command command : all_commands)
    if (key_of(command) == key) return command;
  return std::nullopt;
}

std::optional<Input> KeyBindings::meaning(const Input& input) const {
  const auto* pressed = std::get_if<KeyPressed>(&input);
  const auto* released = std::get_if<KeyReleased>(&input);
  if (!pressed && !released) return input;
  const Key key = pressed ? pressed->key : released->key;
  if (!is_letter(key)) return input;
  const auto command = command_of(key);
  if (!command) return std::nullopt;
  return pressed ? Input(CommandPressed{*command}) : Input(CommandReleased{*command});
}

std::vector<std::pair<std::string, std::string>> KeyBindings::to_pairs() const {
  std::vector<std::pair<std::string, std::string>> pairs;
  pairs.reserve(all_commands.size());
  for (const Command command : all_commands)
    pairs.emplace_back(names[static_cast<std::size_t>(command)],
                       std::string(1, letter(key_of(command))));
  return pairs;
}

carom::Result<KeyBindings> KeyBindings::from_pairs(
    const std::vector<std::pair<std::string, std::string>>& pairs) {
  KeyBindings read;
  std::array<bool, all_commands.size()> seen{};
  for (const auto& [name, key] : pairs) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end())
      return wrong("\"" + name + "\" is no command",
                   "\"again\", \"next\", \"pause\", \"fast\" or \"mute\"");
    const auto index = static_cast<std::size_t>(at - names.begin());
    if (seen[index]) return wrong("\"" + name + "\" is there twice", "each command once");
    seen[index] = true;
    if (key.size() != 1 || key[0] < 'a' || key[0] > 'z')
      return wrong("\"" + key + "\" is no letter", "one from \"a\" to \"z\"");
    read.keys_[index] = static_cast<Key>(static_cast<int>(Key::a) + (key[0] - 'a'));
  }
  constexpr auto hint = static_cast<std::size_t>(Command::hint);
  if (!seen[hint]) {
    const auto taken = [&](Key key) {
      return std::ranges::count(read.keys_, key) > (read.keys_[hint] == key ? 1 : 0);
    };
    for (Key free = Key::a; taken(read.keys_[hint]);
         free = static_cast<Key>(static_cast<int>(free) + 1))
      read.keys_[hint] = free;
  }
  // Only now: two may have changed places.
  for (std::size_t i = 0; i < all_commands.size(); ++i)
    for (std::size_t j = i + 1; j < all_commands.size(); ++j)
      if (read.keys_[i] == read.keys_[j])
        return wrong("\"" + std::string(1, letter(read.keys_[i])) + "\" has two commands",
                     "a letter for each");
  return read;
}

std::string Keyboard::name(Command command) const {
  const Key key = bindings.key_of(command);
  std::string name = label ? label(key) : std::string();
  if (name.empty()) name = static_cast<char>(letter(key) - 'a' + 'A');
  return name;
}

}  // namespace app
