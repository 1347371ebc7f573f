#pragma once

#include <string>
#include <string_view>
#include <zlib.h>

namespace recorded {

/// The text of a replay with any packed payload, right or wrong.
inline std::string text_of_packed(const std::string& packed, char version = 1) {
  std::string checked = version + packed;
  const auto crc =
      crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  for (std::size_t byte = 0; byte < 4; ++byte)
    checked.insert(1 + byte, 1, static_cast<char>(crc >> 8 * byte));
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  std::string text;
  for (std::size_t bit = 0; bit < checked.size() * 8; bit += 6) {
    unsigned digit = 0;
    for (std::size_t b = bit; b < bit + 6; ++b)
      digit = digit << 1 | (b / 8 < checked.size()
                                ? static_cast<unsigned char>(checked[b / 8]) >> (7 - b % 8) & 1U
                                : 0U);
    text += digits[digit];
  }
  return text;
}

/// The same of a payload that is not packed yet; docs/formats.md says what belongs in it.
inline std::string text_of(std::string payload, char version = 1) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
  std::string packed(payload.size() + 1000, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(payload.data());
  stream.avail_in = static_cast<uInt>(payload.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return text_of_packed(packed, version);
}

}  // namespace recorded
