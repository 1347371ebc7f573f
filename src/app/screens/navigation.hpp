#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/input/input.hpp"
#include "app/play/session.hpp"
#include "app/widgets/dialog.hpp"
#include "search/simulation.hpp"

/// Requests by which one screen leads to another. A request carries all that it needs; App applies
/// it to the stack of screens.
namespace app {

/// The effect of a screen on those below it.
enum class Cover : std::uint8_t {
  whole,    ///< they are not drawn, and wait
  waiting,  ///< they are drawn, and wait
  running,  ///< they are drawn, and time passes for them
};

// Requests that the stack does by itself.
struct Stay {};
/// Closes the uppermost screen.
struct Back {};
/// Opens a window with a question over the screen that asks.
struct Ask {
  struct Shortcut {
    std::variant<Key, Command> press;
    ButtonId answer{};
  };
  Dialog dialog;
  std::string line;  ///< for Screen::describe()
  Cover cover = Cover::waiting;
  std::vector<Shortcut> shortcuts{};  ///< presses that answer as a button would
  bool message = false;               ///< the screen below is not told the answer
};
/// Closes the window; the screen below gets the button (Screen::answered()).
struct Answer {
  ButtonId button{};
};

// Requests for a screen in place of all others.
struct ShowTitle {};
struct PlayBilliards {
  bool practice = false;
};
struct ShowLevels {};
struct PlayLevel {
  std::size_t level = 0;  ///< index in Campaign::levels; it must be one that can be played
  bool practice = false;
};
struct ShowSavedGames {};
/// Plays a saved game, unseen, up to where it was left.
struct Load {
  KeptGames::Kept kept;
};
/// Goes on with a game that was loaded. Its level, if it has one, is the campaign's current one.
struct Resume {
  std::variant<BilliardsRecorder, LevelRecorder> game;
  KeptGames::Place place;  ///< where it is saved
};
struct ShowReplays {};

// Requests for a screen over the others.
struct Watch {
  replay::Replay replay;
  std::optional<std::size_t> turn{};     ///< it begins there, standing still
  std::optional<search::Shot> better{};  ///< than that turn's, to be seen before it
};
/// What each shot of a game of billiards was worth.
struct ShowReview {
  replay::Replay replay;
};
struct ShowSettings {
  std::size_t page = 0;
};
struct ShowHelp {};
/// The choice of the next game of billiards.
struct ShowNewGame {};
/// The choice of the computer's level.
struct ShowOpponents {};

/// Ends the program.
struct Quit {};

using Navigation =
    std::variant<Stay, Back, Ask, Answer, ShowTitle, PlayBilliards, ShowLevels, PlayLevel,
                 ShowSavedGames, Load, Resume, ShowReplays, Watch, ShowReview, ShowSettings,
                 ShowHelp, ShowNewGame, ShowOpponents, Quit>;

}  // namespace app
