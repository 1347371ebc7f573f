#pragma once

#include <map>
#include <optional>
#include <string>

#include "carom/result.hpp"

namespace app {

/// Keeps a few small texts by name beyond the program's end. The platform knows where.
class Store {
 public:
  virtual ~Store() = default;

  /// What was saved under `name`; none if nothing was. Fails when it is there and cannot be read.
  virtual carom::Result<std::optional<std::string>> load(const std::string& name) = 0;
  virtual carom::Status save(const std::string& name, const std::string& text) = 0;
  /// Renames what is there to NAME.broken, so that it is kept and nothing is saved over it.
  virtual carom::Status set_aside(const std::string& name) = 0;
};

/// Forgets everything in the end: for tests, scripts, and players without a home.
class MemoryStore final : public Store {
 public:
  carom::Result<std::optional<std::string>> load(const std::string& name) override;
  carom::Status save(const std::string& name, const std::string& text) override;
  carom::Status set_aside(const std::string& name) override;

 private:
  std::map<std::string, std::string> texts_;
};

}  // namespace app
