#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/storage/level.hpp"

namespace platform {

/// The levels in a file, or in the *.json and *.angry-level files of a folder, by name. What cannot
/// be read is a level that cannot be played.
std::vector<app::Level> read_levels(const std::filesystem::path& file_or_folder);

/// The same for several, in the order given.
std::vector<app::Level> read_levels(const std::vector<std::filesystem::path>& files_and_folders);

/// Notices when files of levels change.
class LevelWatch {
 public:
  explicit LevelWatch(std::vector<std::filesystem::path> files_and_folders)
      : paths_(std::move(files_and_folders)), seen_(look()) {}

  /// True if a file was changed, added or removed since the last call.
  bool changed() {
    const Seen now = look();
    return now != std::exchange(seen_, now);
  }

 private:
  struct Stamp {
    std::filesystem::path file;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  using Seen = std::vector<Stamp>;
  Seen look() const;

  std::vector<std::filesystem::path> paths_;
  Seen seen_;
};

}  // namespace platform
