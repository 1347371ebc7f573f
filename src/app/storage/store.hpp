#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/result.hpp"

namespace app {

/// The name of the settings, which the platform keeps where settings lie; all else are data.
inline constexpr const char* settings_file = "settings.json";

/// Endings of the names that Store::list() gives. A double click opens the first two.
inline constexpr std::array<std::string_view, 3> listed_endings{".angry-level", ".angry-replay",
                                                                ".json"};
inline bool is_listed(std::string_view name) {
  return std::ranges::any_of(listed_endings,
                             [&](std::string_view ending) { return name.ends_with(ending); });
}

/// Held by one window at a time, as long as it reads, changes and writes what others share.
class StoreLock {
 public:
  StoreLock() = default;
  virtual ~StoreLock() = default;
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;
};

/// Keeps texts by name beyond the program's end. A name may begin with a folder: "replays/a.json".
/// The platform knows where.
class Store {
 public:
  virtual ~Store() = default;

  /// Waits for other windows, but not for ever: null when one does not let go. Not to be asked for
  /// again while it is held.
  virtual std::unique_ptr<StoreLock> lock() { return std::make_unique<StoreLock>(); }
  /// Returns the text saved under `name`; none if nothing was. Fails when it cannot be read.
  virtual carom::Result<std::optional<std::string>> load(const std::string& name) = 0;
  virtual carom::Status save(const std::string& name, const std::string& text) = 0;
  /// The same, but never over something: false when the name is taken.
  virtual carom::Result<bool> save_new(const std::string& name, const std::string& text) = 0;
  /// Nothing is saved under `name` any more; that may have been so before.
  virtual carom::Status remove(const std::string& name) = 0;
  /// Renames what is there to NAME.broken, so that nothing is saved over it.
  virtual carom::Status set_aside(const std::string& name) = 0;
  /// The names in a folder ("replays/", or "" for those in none) with a listed ending, in order.
  virtual std::vector<std::string> list(const std::string& folder) = 0;
};

/// Forgets everything in the end: for tests, scripts, and players without a home.
class MemoryStore : public Store {
 public:
  carom::Result<std::optional<std::string>> load(const std::string& name) override;
  carom::Status save(const std::string& name, const std::string& text) override;
  carom::Result<bool> save_new(const std::string& name, const std::string& text) override;
  carom::Status remove(const std::string& name) override;
  carom::Status set_aside(const std::string& name) override;
  std::vector<std::string> list(const std::string& folder) override;

 private:
  std::map<std::string, std::string> texts_;
};

}  // namespace app
