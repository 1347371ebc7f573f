#pragma once

#include <string>
#include <vector>

#include "app/storage/store.hpp"

namespace platform {

/// Keeps texts in the browser's localStorage, all keys behind one prefix. A text is replaced as a
/// whole or not at all: setItem does either. One of more than max_text is not read.
class BrowserStore final : public app::Store {
 public:
  static constexpr std::size_t max_text = 16 << 20;  ///< bytes

  carom::Result<std::optional<std::string>> load(const std::string& name) override;
  carom::Status save(const std::string& name, const std::string& text) override;
  carom::Result<bool> save_new(const std::string& name, const std::string& text) override;
  carom::Status remove(const std::string& name) override;
  /// A NAME.broken that is there already stays: then it is NAME.broken-2, and so on.
  carom::Status set_aside(const std::string& name) override;
  std::vector<std::string> list(const std::string& folder) override;
};

}  // namespace platform
