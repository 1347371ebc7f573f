#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/app.hpp"
#include "carom/result.hpp"

namespace platform {

/// Parts of a game in a window. Store and clipboard must outlive the window.
struct WindowSetup {
  app::StartLanguage language;
  int width = 1280;  ///< points
  int height = 720;
  int least_width = 480;  ///< points; the player makes it no smaller
  int least_height = 360;
  app::Store& store;
  app::Clipboard* clipboard = nullptr;  ///< none: the desktop's
  std::vector<app::Level> levels{};     ///< beside the shipped ones
  app::HostEnvironment host{};
};

/// The game in a window. Whoever has it owns the loop.
class GameWindow {
 public:
  virtual ~GameWindow() = default;
  virtual app::App& app() = 0;
  /// Takes what the player did, lets the time pass since the last call, and shows the picture if it
  /// has changed. False once the game is closed.
  virtual bool iterate() = 0;
  /// Waits until there may be something to do.
  virtual void wait() = 0;
};

/// Fails when there is no display.
carom::Result<std::unique_ptr<GameWindow>> open_window(WindowSetup setup);

}  // namespace platform
