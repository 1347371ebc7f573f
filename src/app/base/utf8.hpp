#pragma once

#include <cstddef>
#include <string_view>
#include <utf8cpp/utf8/unchecked.h>

namespace app {

struct CodePoint {
  char32_t code = 0;
  std::size_t size = 0;  ///< bytes; 0: the text is empty or does not begin with valid UTF-8
};

inline CodePoint first_code_point(std::string_view text) {
  const std::string_view window = text.substr(0, 4);
  const auto* at = window.data();
  if (utf8::find_invalid(at, at + window.size()) == at) return {};
  const char32_t code = utf8::unchecked::next(at);
  return {code, static_cast<std::size_t>(at - window.data())};
}

/// Takes the first code point off a text that is not empty; a byte that is not UTF-8 is U+FFFD.
inline char32_t take_code_point(std::string_view& text) {
  constexpr char32_t replacement = 0xfffd;
  const CodePoint first = first_code_point(text);
  text.remove_prefix(first.size == 0 ? 1 : first.size);
  return first.size == 0 ? replacement : first.code;
}

/// The text without its last code point; an empty one stays empty.
inline std::string_view without_last_code_point(std::string_view text) {
  const auto continues = [&] { return (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80; };
  while (text.size() > 1 && continues()) text.remove_suffix(1);
  return text.substr(0, text.size() - (text.empty() ? 0 : 1));
}

}  // namespace app
