#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "app/text/text.hpp"

namespace app {

/// Differences between the places where the game runs. The defaults: a window of a desktop.
struct HostEnvironment {
  /// Stands before "#replay=TEXT" in what is copied: a page's address. Empty: the bare text is.
  std::string link_prefix{};
  bool reduced_motion = false;  ///< the desktop or browser asks for less that moves
  bool touch = false;    ///< fingers are what there is: texts and buttons are for them at once
  bool can_quit = true;  ///< the player may end the program
  /// Lets the player choose a file, which comes by App::open_file() later; offered instead of
  /// quitting.
  std::function<void()> choose_file{};
  /// Asks a finger for a text, where no keyboard comes up by itself: what for, and what it is so
  /// far; nothing if the player takes it back. Empty: it is typed.
  std::function<std::optional<std::string>(const std::string&, const std::string&)> ask_text{};
  /// A number that nobody can foretell. Empty: games of a start have the same luck as those of
  /// another.
  std::function<std::uint64_t()> random{};
  /// The licences in the help. Empty: show_licences() shows them outside of the window.
  std::string_view licences{};
  std::function<void()> show_licences{};
  /// Gets the texts of a language that is wanted and not there (has_texts), for App::take_texts()
  /// later. Empty: all are there.
  std::function<void(Language)> fetch_texts{};
};

}  // namespace app
