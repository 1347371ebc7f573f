#include "platform/data_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

#include "files/files.hpp"

namespace platform {
namespace {

namespace fs = std::filesystem;

/// An absolute path from the environment; the XDG specification ignores others.
std::optional<fs::path> environment_folder(const char* variable) {
  const char* value = std::getenv(variable);
  if (!value || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

/// Closing a file lets its flock go, and so does the end of a process that was killed.
class FileLock final : public app::StoreLock {
 public:
  explicit FileLock(int file) : file_(file) {}
  ~FileLock() override { close(file_); }

 private:
  int file_;
};

}  // namespace

std::optional<fs::path> data_folder() {
  if (const auto data = environment_folder("XDG_DATA_HOME")) return *data / "angry-balls";
  if (const auto home = environment_folder("HOME")) return *home / ".local/share/angry-balls";
  return std::nullopt;
}

std::optional<fs::path> config_folder() {
  if (const auto config = environment_folder("XDG_CONFIG_HOME")) return *config / "angry-balls";
  if (const auto home = environment_folder("HOME")) return *home / ".config/angry-balls";
  return std::nullopt;
}

FolderStore::FolderStore(fs::path data, fs::path config)
    : data_(std::move(data)), config_(std::move(config)) {
  for (const fs::path& folder : {data_, data_ / "replays", config_})
    for (const std::string_view ending : app::listed_endings)
      files::remove_abandoned(folder, ending);
}

std::unique_ptr<app::StoreLock> FolderStore::lock() {
  constexpr std::chrono::milliseconds most{1000};
  constexpr std::chrono::milliseconds pause{2};
  std::error_code ignored;
  fs::create_directories(data_, ignored);
  const int file = open((data_ / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (file < 0) return nullptr;
  auto lock = std::make_unique<FileLock>(file);
  for (auto waited = pause; flock(file, LOCK_EX | LOCK_NB) != 0; waited += pause) {
    // A file system without locks has to do without.
    if (errno != EWOULDBLOCK && errno != EINTR) break;
    if (waited > most) return nullptr;
    std::this_thread::sleep_for(pause);
  }
  return lock;
}

carom::Result<std::optional<std::string>> FolderStore::load(const std::string& name) {
  std::error_code ignored;
  if (fs::symlink_status(path_of(name), ignored).type() == fs::file_type::not_found)
    return std::optional<std::string>();
  if (!fs::is_regular_file(path_of(name), ignored))
    return carom::Error{.pointer = name, .problem = "is no file"};
  if (const auto size = fs::file_size(path_of(name), ignored); !ignored && size > max_text)
    return carom::Error{.pointer = name, .problem = "is larger than 16 MiB"};
  auto text = files::read(path_of(name), max_text);
  if (!text) return text.errors();
  return std::optional(std::move(text).value());
}

carom::Status FolderStore::save(const std::string& name, const std::string& text) {
  const fs::path path = path_of(name);
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);  // write() tells if it is not there
  return files::write(path, text);
}

carom::Result<bool> FolderStore::save_new(const std::string& name, const std::string& text) {
  const fs::path path = path_of(name);
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);  // write_new() tells if it is not there
  return files::write_new(path, text);
}

carom::Status FolderStore::remove(const std::string& name) {
  std::error_code error;
  fs::remove(path_of(name), error);
  if (error) return carom::Error{.pointer = name, .problem = error.message()};
  return carom::Done{};
}

carom::Status FolderStore::set_aside(const std::string& name) {
  std::error_code error;
  const fs::path path = path_of(name);
  fs::path aside = path;
  aside += ".broken";
  for (int i = 2; fs::exists(aside, error); ++i) {
    aside = path;
    aside += ".broken-" + std::to_string(i);
  }
  fs::rename(path, aside, error);
  if (error) return carom::Error{.pointer = name, .problem = error.message()};
  return carom::Done{};
}

std::vector<std::string> FolderStore::list(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator entry(data_ / folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (app::is_listed(entry->path().filename().string()) && entry->is_regular_file(ignored))
      names.push_back(folder + entry->path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace platform
