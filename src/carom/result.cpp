#include "carom/result.hpp"

#include "carom/internal/display_text.hpp"

namespace carom {

std::string to_string(const Error& error, std::string_view file) {
  std::string text = display_text(file);
  const auto append = [&](std::string_view separator, std::string_view part) {
    if (part.empty()) return;
    if (!text.empty()) text += separator;
    text += display_text(part);
  };
  if (error.line != 0) append(":", std::to_string(error.line));
  if (error.column != 0) append(":", std::to_string(error.column));
  append(": ", error.pointer);
  append(": ", error.problem);
  if (!error.expected.empty()) append("; ", "expected " + error.expected);
  return text;
}

}  // namespace carom
