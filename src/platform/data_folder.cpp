#include "platform/data_folder.hpp"

#include <cstdlib>
#include <system_error>

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

}  // namespace

std::optional<fs::path> data_folder() {
  if (const auto data = environment_folder("XDG_DATA_HOME")) return *data / "angry-balls";
  if (const auto home = environment_folder("HOME")) return *home / ".local/share/angry-balls";
  return std::nullopt;
}

carom::Result<std::optional<std::string>> FolderStore::load(const std::string& name) {
  std::error_code ignored;
  if (fs::symlink_status(folder_ / name, ignored).type() == fs::file_type::not_found)
    return std::optional<std::string>();
  if (!fs::is_regular_file(folder_ / name, ignored))
    return carom::Error{.pointer = name, .problem = "is no file"};
  auto text = files::read(folder_ / name);
  if (!text) return text.errors();
  return std::optional(std::move(text).value());
}

carom::Status FolderStore::save(const std::string& name, const std::string& text) {
  std::error_code ignored;
  fs::create_directories(folder_, ignored);  // write() tells if it is not there
  return files::write(folder_ / name, text);
}

carom::Status FolderStore::set_aside(const std::string& name) {
  std::error_code error;
  fs::path aside = folder_ / (name + ".broken");
  for (int i = 2; fs::exists(aside, error); ++i)
    aside = folder_ / (name + ".broken-" + std::to_string(i));
  fs::rename(folder_ / name, aside, error);
  if (error) return carom::Error{.pointer = name, .problem = error.message()};
  return carom::Done{};
}

}  // namespace platform
