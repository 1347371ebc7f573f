#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/base/time.hpp"
#include "app/graphics/canvas.hpp"
#include "app/input/input.hpp"
#include "app/text/text.hpp"

namespace app {

/// Where the player goes from a screen; `level` is the campaign's current one. What a screen hands
/// on lies in the Session.
enum class Transition : std::uint8_t {
  stay,
  title,
  billiards,
  practice_table,
  levels,
  level,
  load,        ///< plays the game kept up to where it was left
  resume,      ///< goes on with the game loaded
  kept_games,  ///< those that can be continued
  replays,     ///< the replays saved
  replay,      ///< shows a replay; the screen left is kept
  settings,    ///< the settings; the screen left is kept
  help,        ///< all keys, over the screen, which waits
  back,        ///< to the screen kept
  quit,
};

/// Where the player has to do something with a ball, and what.
struct AimPrompt {
  Point at;          ///< window px, the ball's centre
  float radius = 0;  ///< window px
  Text what{};
  std::vector<Rect> in_sight{};  ///< what a lesson should not cover, window px
};

/// What fills the window. Input and time go in; a picture and a transition come out.
class Screen {
 public:
  virtual ~Screen() = default;

  /// Called before all else, whenever the window's size changes, and when the player comes back to
  /// a screen that was kept: then the language may be another.
  virtual void resize(const View& view) = 0;
  virtual Transition event(const Input& input) = 0;
  /// Only a screen that waits for something goes elsewhere by itself.
  virtual Transition iterate(nanoseconds elapsed) = 0;
  virtual void draw(Canvas& canvas) const = 0;
  /// What is on screen, in one line.
  virtual std::string describe() const = 0;
  /// The ball that is the player's to aim or to place now: then sticks steer it. None otherwise.
  virtual std::optional<AimPrompt> aim_prompt() const { return std::nullopt; }
  /// What is typed is a text: letters are no commands.
  virtual bool typing() const { return false; }
  /// The picture changes without input.
  virtual bool animating() const = 0;
};

}  // namespace app
