#pragma once

#include <optional>
#include <string>

namespace app {

/// Text shared with other programs. The platform knows how.
class Clipboard {
 public:
  virtual ~Clipboard() = default;

  /// Empty if there is none, or no text in it. None: it was asked for, and comes with Key::paste.
  virtual std::optional<std::string> text() = 0;
  /// Tells whether it worked.
  virtual bool set_text(const std::string& text) = 0;
};

/// Shares with nobody: for tests and scripts.
class MemoryClipboard final : public Clipboard {
 public:
  std::optional<std::string> text() override { return text_; }
  bool set_text(const std::string& text) override {
    text_ = text;
    return true;
  }

 private:
  std::string text_;
};

}  // namespace app
