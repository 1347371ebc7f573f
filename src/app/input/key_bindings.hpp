#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/input/input.hpp"
#include "carom/result.hpp"

namespace app {

inline constexpr std::array all_commands{Command::again, Command::next, Command::pause,
                                         Command::fast,  Command::mute, Command::hint};

/// Which letter does what. No letter does two things.
class KeyBindings {
 public:
  Key key_of(Command command) const { return keys_[static_cast<std::size_t>(command)]; }
  /// Only letters can be taken, and none that does something else: then nothing changes.
  carom::Status bind(Command command, Key key);
  /// The command of a letter; none if it has none, or is not a letter.
  std::optional<Command> command_of(Key key) const;
  /// Returns a screen's input: for a letter its command, none if it has none; else `input` itself.
  std::optional<Input> meaning(const Input& input) const;

  /// Names of commands and letters, "again" and "r", for a file.
  std::vector<std::pair<std::string, std::string>> to_pairs() const;
  /// Commands left out stay at their defaults; hint, which older files do not know, takes a free
  /// letter if its own is taken. Fails on unknown names, names given twice, and
  /// letters that would do two things.
  static carom::Result<KeyBindings> from_pairs(
      const std::vector<std::pair<std::string, std::string>>& pairs);

  friend bool operator==(const KeyBindings&, const KeyBindings&) = default;

 private:
  std::array<Key, all_commands.size()> keys_{Key::r, Key::n, Key::p, Key::f, Key::m, Key::h};
};

inline bool is_letter(Key key) { return key >= Key::a && key <= Key::z; }

/// The keyboard as the player has it.
struct Keyboard {
  KeyBindings bindings;
  /// The print on a letter's key; empty: as in the United States. May give an empty text.
  std::function<std::string(Key)> label;

  /// Name of a command's key.
  std::string name(Command command) const;
};

}  // namespace app
