#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/graphics/palette.hpp"
#include "app/input/key_bindings.hpp"
#include "app/storage/aim_settings.hpp"
#include "app/storage/store.hpp"
#include "app/text/text.hpp"
#include "games/billiards.hpp"

namespace app {

/// Less motion than the games like to show.
enum class ReducedMotion : std::uint8_t { system, on, off };
/// The player who has the first turn of a game of billiards.
enum class Breaks : std::uint8_t {
  player_1,
  player_2,
  alternate,  ///< who did not have it in the last game
  loser,      ///< who lost the last game
};

/// Who plays a game of billiards.
enum class Seats : std::uint8_t {
  two,
  computer,  ///< the second player is one
  alone,
};
/// How many games decide a match.
enum class BestOf : std::uint8_t { one, three, five };
constexpr int games_of(BestOf match) { return 2 * static_cast<int>(match) + 1; }

/// How far a player's drags miss: 1 standard deviation along the drag and across it.
enum class Steadiness : std::uint8_t { exact, half, one, two, four, eight, fifteen };
/// px of the world.
constexpr double error_of(Steadiness hand) {
  constexpr std::array errors{0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 15.0};
  return errors[static_cast<std::size_t>(hand)];
}

inline constexpr int most_volume = 100;
inline constexpr std::size_t max_settings = 64 << 10;  ///< bytes of a file
inline constexpr std::size_t longest_name = 24;        ///< code points

/// The player's choices. A plain value; the defaults are those of the first start.
struct Settings {
  std::optional<Language> language;  ///< the system's if none
  int volume = 80;                   ///< per cent, 0 to most_volume
  bool mute = false;
  ReducedMotion reduced_motion = ReducedMotion::system;
  bool screen_shake = false;
  Colours colours = Colours::standard;
  AimSettings aiming;
  bool hints = true;
  /// As name_of() makes them; empty: "Player 1", "Player 2".
  std::array<std::string, 2> names;
  Breaks breaks = Breaks::player_1;
  bool taught = false;  ///< has done something while it was shown how to shoot
  // The game of billiards that was chosen last (games::billiards::Options).
  bool keep_turn = false;  ///< who scores plays on
  Seats seats = Seats::two;
  games::billiards::Rack rack = games::billiards::Rack::classic;
  bool touch_red = false;  ///< a shot that touches no red gives the cue ball away
  int opponent = 3;        ///< level of the computer, 1 to replay::most_computer
  BestOf match = BestOf::one;
  Steadiness hand = Steadiness::two;  ///< what hints take the player's for
  // The pace.
  bool go_on = false;          ///< the next throw comes by itself when nothing can change any more
  bool go_on_offered = false;  ///< the player was asked about it
  bool quick_rolling = true;   ///< slow balls that meet nothing more roll faster
  KeyBindings keys;

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// The part of a text, typed, pasted or from a file, that can be shown: whole UTF-8 without what
/// carom::display_text() writes out, without blanks at its ends, at most longest_name code points.
/// `unfinished`:
/// a blank at the end may be followed by more, and stays.
std::string name_of(std::string_view typed, bool unfinished = false);

/// A game of billiards that was played to its end.
struct FinishedGame {
  int first_player = 0;       ///< 0 or 1
  std::optional<int> winner;  ///< 0 or 1; none: a draw
};
/// The player of the first turn after `last`; none: no game was finished yet. A draw's loser is
/// the one who did not have it.
int first_player(Breaks breaks, const std::optional<FinishedGame>& last);

/// The settings, saved in a Store after every change.
class KeptSettings {
 public:
  enum class Trouble : std::uint8_t {
    none,
    set_aside,  ///< what was stored were no settings; they are saved under another name
    not_kept,   ///< the store does not work: changes last until the program ends
  };

  /// The store must outlive this.
  explicit KeptSettings(Store& store);

  const Settings& get() const { return settings_; }
  /// Takes over and saves. Names are taken as name_of() makes them, the volume as the nearest that
  /// there is.
  void set(Settings settings);
  Trouble trouble() const { return trouble_; }
  /// The trouble of the start, to be reported once.
  Trouble take_trouble();

 private:
  std::optional<Settings> load();

  Store& store_;
  Settings settings_;
  Trouble trouble_ = Trouble::none;
  bool told_ = false;
  bool blocked_ = false;  ///< something unreadable is there that cannot be moved away
};

}  // namespace app
