#pragma once

#include <optional>
#include <string>

#include "app/base/time.hpp"
#include "app/graphics/canvas.hpp"
#include "app/hud/aim_prompt.hpp"
#include "app/screens/navigation.hpp"

namespace app {

/// The meaning of letters to a screen.
enum class Letters : std::uint8_t {
  commands,  ///< those that they are bound to
  text,      ///< a text that is typed
  keys,      ///< keys as they are pressed: the screen binds them
};

/// Fills the window, or lies over another screen (ScreenStack). Takes input and time; gives a
/// picture and requests.
class Screen {
 public:
  virtual ~Screen() = default;

  /// Called before all else, whenever the window's size changes, and when the player comes back to
  /// a screen that was covered whole: then the language may be another.
  virtual void resize(const View& view) = 0;
  virtual Navigation event(const Input& input) = 0;
  /// Only a screen that waits for something goes elsewhere by itself.
  virtual Navigation iterate(nanoseconds) { return Stay{}; }
  virtual void draw(Canvas& canvas) const = 0;
  /// The content of the screen in one line.
  virtual std::string describe() const = 0;
  /// The picture changes without input.
  virtual bool animating() const { return false; }

  /// There is no screen to go back to.
  virtual bool is_first() const { return false; }

  virtual Cover cover() const { return Cover::whole; }
  /// The window to open over this screen now. Called whenever the screen is the uppermost one.
  virtual std::optional<Ask> opens() { return std::nullopt; }
  /// The button chosen in the window that this screen opened, which is closed.
  virtual Navigation answered(ButtonId) { return Stay{}; }

  /// The ball that is the player's to aim or to place now: then sticks steer it. None otherwise.
  virtual std::optional<AimPrompt> aim_prompt() const { return std::nullopt; }
  virtual Letters letters() const { return Letters::commands; }

  /// The identity of the level in play (level.hpp); empty if none is.
  virtual std::string level_in_play() const { return {}; }
  /// Shows the campaign's levels, which have changed: where to go to show them anew.
  virtual Navigation levels_changed() { return Stay{}; }
};

}  // namespace app
