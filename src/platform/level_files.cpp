#include "platform/level_files.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

#include "files/files.hpp"
#include "search/proof_file.hpp"

namespace platform {
namespace {

namespace fs = std::filesystem;

app::Level unreadable(const fs::path& path, const std::error_code& error) {
  return app::read_level(
      path.filename().string(),
      carom::Error{.pointer = {},
                   .problem = {carom::MessageCode::cannot_be_opened, {error.message()}}});
}

/// The files of levels in a folder, by name; as far as it could be read.
std::vector<fs::path> files_of(const fs::path& folder, std::error_code& error) {
  std::vector<fs::path> found;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    const fs::path ending = entry->path().extension();
    if ((ending == ".json" || ending == ".angry-level") && entry->is_regular_file(ignored) &&
        !search::lies_beside_levels(entry->path().filename().string()))
      found.push_back(entry->path());
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

std::vector<app::Level> read_levels(const fs::path& file_or_folder) {
  std::error_code error;
  if (!fs::is_directory(file_or_folder, error)) {
    if (fs::exists(file_or_folder, error) && !fs::is_regular_file(file_or_folder, error))
      return {unreadable(file_or_folder, std::make_error_code(std::errc::invalid_argument))};
    return {app::read_level(file_or_folder.filename().string(),
                            files::read_text(file_or_folder, files::max_small_file))};
  }
  const std::vector<fs::path> found = files_of(file_or_folder, error);
  std::vector<app::Level> levels;
  levels.reserve(found.size());
  for (const fs::path& file : found)
    levels.push_back(
        app::read_level(file.filename().string(), files::read_text(file, files::max_small_file)));
  if (error) levels.push_back(unreadable(file_or_folder, error));
  return levels;
}

std::vector<app::Level> read_levels(const std::vector<fs::path>& files_and_folders) {
  std::vector<app::Level> levels;
  for (const fs::path& path : files_and_folders)
    std::ranges::move(read_levels(path), std::back_inserter(levels));
  return levels;
}

LevelWatch::Seen LevelWatch::look() const {
  Seen seen;
  for (const fs::path& path : paths_) {
    std::error_code ignored;
    const std::vector<fs::path> files =
        fs::is_directory(path, ignored) ? files_of(path, ignored) : std::vector{path};
    for (const fs::path& file : files)
      seen.push_back({file, fs::last_write_time(file, ignored), fs::file_size(file, ignored)});
  }
  return seen;
}

}  // namespace platform
