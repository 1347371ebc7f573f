#include "carom/display_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace carom {

namespace {

struct CodeRange {
  std::uint32_t first;
  std::uint32_t last;
};

// Unicode's controls, line and paragraph separators, and format characters; of the latter not the
// joiners U+200C and U+200D, which scripts and emoji need. Fillers that show nothing, too.
constexpr CodeRange not_shown[] = {
    {0x00, 0x1f},       {0x7f, 0x9f},     {0xad, 0xad},     {0x34f, 0x34f},   {0x61c, 0x61c},
    {0x115f, 0x1160},   {0x180e, 0x180e}, {0x3164, 0x3164}, {0xffa0, 0xffa0}, {0x200b, 0x200b},
    {0x200e, 0x200f},   {0x2028, 0x202e}, {0x2060, 0x206f}, {0xfeff, 0xfeff}, {0xfff9, 0xfffb},
    {0xe0000, 0xe007f}, {0xfdd0, 0xfdef}, {0xfffe, 0xffff},
};

struct Character {
  std::uint32_t code;
  std::size_t size;  // bytes; 0: no UTF-8
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return {lead, 0};
  std::uint32_t code = lead & (0xffU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return {lead, 0};
    code = code << 6 | (byte(i) & 0x3fU);
  }
  const bool overlong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (overlong || surrogate || code > 0x10ffff) return {lead, 0};
  return {code, size};
}

void append_code(std::string& out, char kind, std::uint32_t code) {
  std::array<char, 8> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), code, 16);
  out.append({'\\', kind, '{'}).append(digits.data(), end.ptr) += '}';
}

}  // namespace

bool is_shown(std::uint32_t code_point) {
  return std::none_of(std::begin(not_shown), std::end(not_shown), [=](const CodeRange& range) {
    return code_point >= range.first && code_point <= range.last;
  });
}

std::string display_text(std::string_view text, std::size_t most) {
  std::string out;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) return out + "…";
    const auto [code, size] = first_character(text);
    if (size == 0)
      append_code(out, 'x', code);
    else if (!is_shown(code))
      append_code(out, 'u', code);
    else
      out.append(text.substr(0, size));
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

}  // namespace carom
