#pragma once

#include <filesystem>
#include <vector>

#include "app/app.hpp"
#include "platform/raster.hpp"
#include "platform/script.hpp"

namespace platform {

/// A window that is not there: plays a script as fast as it can, the same every time.
class NullPlatform {
 public:
  /// `levels`: beside the shipped ones. Scores are kept in memory only.
  NullPlatform(app::Language language, int width, int height, std::vector<app::Level> levels = {});

  /// Plays on until the script ends or the game quits. Fails when a picture cannot be written.
  carom::Status run(const Script& script);
  /// Lets game time pass, in frames of at most 1/60 s.
  void pass(std::chrono::nanoseconds time);
  void click(app::Point at, app::PointerButton button = app::PointerButton::left);
  Image picture();
  carom::Status screenshot(const std::filesystem::path& path);

  app::App& app() { return app_; }
  app::Store& store() { return store_; }

 private:
  app::MemoryStore store_;
  app::App app_;
  int width_;
  int height_;
};

}  // namespace platform
