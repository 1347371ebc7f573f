#include "carom/result.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "carom/display_text.hpp"

namespace carom {

namespace {

struct Row {
  std::string_view name;
  std::string_view english;
};

constexpr std::array rows{
#define CAROM_ROW(code, english) Row{#code, english},
    CAROM_MESSAGES(CAROM_ROW)
#undef CAROM_ROW
};

}  // namespace

std::string_view name(MessageCode code) { return rows[static_cast<std::size_t>(code)].name; }

std::string_view english(MessageCode code) { return rows[static_cast<std::size_t>(code)].english; }

std::string fill(std::string_view form, const std::vector<std::string>& arguments) {
  std::string text;
  for (std::size_t at = 0; at < form.size(); ++at) {
    const std::string_view rest = form.substr(at);
    if (rest.size() >= 3 && rest[0] == '{' && rest[1] >= '0' && rest[1] <= '9' && rest[2] == '}') {
      const auto place = static_cast<std::size_t>(rest[1] - '0');
      if (place < arguments.size()) text += arguments[place];
      at += 2;
    } else {
      text += rest[0];
      if (rest.starts_with("{{")) ++at;
    }
  }
  return text;
}

std::string to_string(const Message& message) {
  return fill(english(message.code), message.arguments);
}

void stop_without_value(const Errors* errors) {
  const std::string text = errors == nullptr || errors->empty()
                               ? "no error in a Result with a value"
                               : to_string(errors->front());
  std::fprintf(stderr, "carom::Result: %s\n", text.c_str());
  std::abort();
}

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
  append(": ", to_string(error.problem));
  if (!error.expected.empty()) append("; ", "expected " + to_string(error.expected));
  return text;
}

}  // namespace carom
