#pragma once

#include <filesystem>
#include <vector>

#include "app/storage/level.hpp"

namespace platform {

/// The levels in a file, or in the *.json and *.angry-level files of a folder, by name. What cannot
/// be read is a level that cannot be played.
std::vector<app::Level> read_levels(const std::filesystem::path& file_or_folder);

/// The same for several, in the order given.
std::vector<app::Level> read_levels(const std::vector<std::filesystem::path>& files_and_folders);

}  // namespace platform
