#pragma once

#include <span>
#include <string>

#include "app/storage/settings.hpp"
#include "app/text/text.hpp"

namespace app {

/// A line of the settings.
struct SettingsRow {
  enum class Kind : std::uint8_t {
    choice,  ///< goes from value to value, round and round
    amount,  ///< goes up and down between two ends
    name,    ///< a player's name, which is typed
  };
  Kind kind{};
  Text label{};
  Text about{};
  /// The value in words; of a name, what the player is called.
  std::string (*get)(const Words& words, const Settings& settings) = nullptr;
  /// `by`: 1 to the next value, -1 to the one before. Of a name null.
  void (*set)(Settings& settings, int by) = nullptr;
  std::size_t player = 0;  ///< of a name: 0 or 1

  /// The texts, with the player's number where it is a name.
  std::string label_in(const Words& words) const { return words(label, {number(words)}); }
  std::string about_in(const Words& words) const { return words(about, {number(words)}); }

 private:
  std::string number(const Words& words) const {
    return words.number(static_cast<int>(player) + 1);
  }
};

struct SettingsPage {
  Text title;
  std::span<const SettingsRow> rows;
};

inline constexpr std::size_t settings_pages = 4;
inline constexpr std::size_t most_settings_rows = 4;  ///< of a page

const SettingsPage& settings_page(std::size_t page);

}  // namespace app
