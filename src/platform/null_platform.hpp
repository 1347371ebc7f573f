#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/app.hpp"
#include "app/graphics/raster.hpp"
#include "platform/script.hpp"

namespace platform {

/// A window that is not there: plays a script as fast as it can, the same every time.
class NullPlatform {
 public:
  /// `levels`: beside the shipped ones. Scores, games and what is copied stay in memory.
  NullPlatform(app::StartLanguage language, int width, int height,
               std::vector<app::Level> levels = {});
  /// Keeps scores and games in `store`, which must outlive this.
  NullPlatform(app::StartLanguage language, int width, int height, std::vector<app::Level> levels,
               app::Store& store);

  using Print = std::function<void(const std::string&)>;
  /// Plays on until the script ends or the game quits; `print` gets what the script prints. Fails
  /// when a picture cannot be written.
  carom::Status run(const Script& script, const Print& print = {});
  /// Lets game time pass, in frames of at most 1/60 s.
  void pass(std::chrono::nanoseconds time);
  void click(app::Point at, app::PointerButton button = app::PointerButton::left);
  app::Image picture();
  carom::Status screenshot(const std::filesystem::path& path);

  app::App& app() { return app_; }
  app::Store& store() { return store_; }
  app::Clipboard& clipboard() { return clipboard_; }
  /// All that was to be heard.
  const std::vector<app::SoundEvent>& sounds() const { return sounds_; }

 private:
  app::MemoryStore memory_;
  app::Store& store_;
  app::MemoryClipboard clipboard_;
  app::App app_;
  std::vector<app::SoundEvent> sounds_;
  int width_;
  int height_;
};

}  // namespace platform
