#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/storage/store.hpp"

namespace platform {

/// Where the player's own things lie: $XDG_DATA_HOME/angry-balls, or ~/.local/share/angry-balls.
/// None for a player without a home.
std::optional<std::filesystem::path> data_folder();

/// Where settings lie: $XDG_CONFIG_HOME/angry-balls, or ~/.config/angry-balls. None for a player
/// without a home.
std::optional<std::filesystem::path> config_folder();

/// Keeps texts as files of a folder, made when first needed; the settings in another one. A file is
/// replaced as a whole or not at all; what a process that was killed left half written is removed
/// at the start. One of more than max_text is not read.
class FolderStore final : public app::Store {
 public:
  static constexpr std::uintmax_t max_text = 16 << 20;  ///< bytes

  /// Everything in one folder.
  explicit FolderStore(const std::filesystem::path& folder) : FolderStore(folder, folder) {}
  FolderStore(std::filesystem::path data, std::filesystem::path config);

  /// By flock on the file .lock of the data folder: waits a second at most. Null when the folder
  /// cannot be written to.
  std::unique_ptr<app::StoreLock> lock() override;
  carom::Result<std::optional<std::string>> load(const std::string& name) override;
  carom::Status save(const std::string& name, const std::string& text) override;
  carom::Result<bool> save_new(const std::string& name, const std::string& text) override;
  carom::Status remove(const std::string& name) override;
  /// A NAME.broken that is there already stays: then it is NAME.broken-2, and so on.
  carom::Status set_aside(const std::string& name) override;
  std::vector<std::string> list(const std::string& folder) override;

 private:
  std::filesystem::path path_of(const std::string& name) const {
    return (name == app::settings_file ? config_ : data_) / name;
  }

  std::filesystem::path data_;
  std::filesystem::path config_;
};

}  // namespace platform
