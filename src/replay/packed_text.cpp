#include "replay/packed_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <zlib.h>

#include "replay/replay.hpp"
#include "replay/written_forms.hpp"

namespace replay {

namespace {

constexpr std::size_t header_bytes = 5;  // the version and a CRC-32
constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr std::size_t max_text = max_bytes / 3 * 4 + 4;

// What mail programs, messengers and pages put within a text: blanks, also those that have no width
// or do not break, and byte order marks.
constexpr std::array<std::string_view, 12> blanks{" ",      "\t",     "\v",     "\f",
                                                  "\u00a0", "\u00ad", "\u200b", "\u2028",
                                                  "\u2029", "\u202f", "\u2060", "\ufeff"};
// Signs around one in a sentence.
constexpr std::array<std::string_view, 24> around{
    "<", ">", "(", ")", "[", "]", "{",      "}",      "\"",     "'",      "`",      ".",
    ",", ";", ":", "!", "?", "*", "\u201c", "\u201d", "\u2018", "\u2019", "\u00ab", "\u00bb"};

// Without blanks, line ends and what stands around a text at its ends.
std::string_view trimmed(std::string_view text) {
  for (bool again = true; again;) {
    again = false;
    const auto cut = [&](std::string_view sign) {
      if (text.starts_with(sign)) {
        text.remove_prefix(sign.size());
        again = true;
      } else if (text.ends_with(sign)) {
        text.remove_suffix(sign.size());
        again = true;
      }
    };
    for (const std::string_view sign : blanks) cut(sign);
    for (const std::string_view sign : around) cut(sign);
    cut("\r");
    cut("\n");
  }
  return text;
}

// base64url (RFC 4648, section 5) without padding.
std::string to_base64url(std::string_view bytes) {
  std::string text;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char byte : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(byte);
    for (count += 8; count >= 6; count -= 6) text += digits[bits >> (count - 6) & 63];
  }
  if (count > 0) text += digits[bits << (6 - count) & 63];
  return text;
}

// Refuses what to_base64url() does not write, spare bits that are not zero included.
std::optional<std::string> from_base64url(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  if (count >= 6 || (bits & ((1U << count) - 1)) != 0) return std::nullopt;
  return bytes;
}

// zlib's raw deflate. What it gives may change with zlib's version; what inflate makes of it may
// not.
std::string deflated(std::string payload) {
  z_stream stream{};
  // Only a lack of memory could make these fail.
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL,
               Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, static_cast<uLong>(payload.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(payload.data());
  stream.avail_in = static_cast<uInt>(payload.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

// None unless the bytes are one whole stream of at most max_bytes. Never holds more than that.
std::optional<std::string> inflated(std::string packed) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string payload;
  std::array<Bytef, 1 << 14> buffer;
  int state = Z_OK;
  while (state == Z_OK && payload.size() <= max_bytes) {
    stream.next_out = buffer.data();
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = inflate(&stream, Z_NO_FLUSH);
    payload.append(reinterpret_cast<const char*>(buffer.data()), buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || stream.avail_in > 0 || payload.size() > max_bytes)
    return std::nullopt;
  return payload;
}

std::uint32_t checksum(std::string_view version, std::string_view packed) {
  uLong crc = crc32(0, nullptr, 0);
  for (const std::string_view part : {version, packed})
    crc = crc32(crc, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(part.size()));
  return static_cast<std::uint32_t>(crc);
}

}  // namespace

carom::Error damaged_text(std::string problem, std::string_view what) {
  return {.problem = {carom::MessageCode::is_damaged, {std::move(problem)}},
          .expected = {carom::MessageCode::text_of_whole, {std::string(what)}}};
}

std::string pasted_text(std::string_view pasted) {
  for (const std::string_view key : {"#replay=", "#level="})
    if (const std::size_t at = pasted.find(key); at != std::string_view::npos)
      pasted.remove_prefix(at + key.size());
  pasted = trimmed(pasted);
  std::string text;
  bool line_begins = true;
  for (std::size_t i = 0; i < pasted.size(); ++i) {
    const char c = pasted[i];
    const auto starts = [rest = pasted.substr(i)](std::string_view blank) {
      return rest.starts_with(blank);
    };
    if (const auto* const blank = std::find_if(blanks.begin(), blanks.end(), starts);
        blank != blanks.end()) {
      i += blank->size() - 1;
      continue;
    }
    const bool line_ends =
        i + 1 < pasted.size() && (pasted[i + 1] == '\r' || pasted[i + 1] == '\n');
    if (c == '\r' || c == '\n') {
      line_begins = true;
    } else if ((c == '>' && (line_begins || i + 1 == pasted.size())) || (c == '=' && line_ends)) {
      // No part of it.
    } else {
      text += c;
      line_begins = false;
    }
  }
  return text;
}

char packed_version(std::string_view pasted) {
  const auto bytes = from_base64url(pasted_text(pasted).substr(0, 4));  // three bytes
  return bytes && !bytes->empty() ? bytes->front() : char{0};
}

std::string pack(char version, std::string payload) {
  std::string bytes(1, version);
  const std::string packed = deflated(std::move(payload));
  const std::uint32_t crc = checksum(bytes, packed);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(crc >> shift);
  return to_base64url(bytes + packed);
}

carom::Result<std::string> unpack(std::string_view pasted, char version, std::string_view what) {
  // A much longer text, even folded, is not looked at.
  const std::string text = pasted.size() > 2 * max_text ? std::string() : pasted_text(pasted);
  using Code = carom::MessageCode;
  if (pasted.size() > 2 * max_text || text.size() > max_text)
    return carom::Error{.problem = {Code::is_longer_than, {std::to_string(max_text)}},
                        .expected = {Code::text_of, {std::string(what)}}};
  const std::size_t foreign = text.find_first_not_of(digits);
  if (foreign != std::string_view::npos)
    return carom::Error{
        .problem = {Code::has_foreign_character, {std::string(what), std::to_string(foreign + 1)}},
        .expected = Code::text_characters};
  auto bytes = from_base64url(text);
  if (!bytes || bytes->size() < header_bytes) return damaged_text("it is not whole", what);
  const auto number = [](char byte) { return std::to_string(static_cast<unsigned char>(byte)); };
  if (bytes->front() != version)
    return carom::Error{
        .problem = {Code::is_version_of, {number(bytes->front()), std::string(what)}},
        .expected = {Code::version, {number(version)}}};
  std::uint32_t crc = 0;
  for (std::size_t byte = 0; byte < 4; ++byte)
    crc |= static_cast<std::uint32_t>(static_cast<unsigned char>((*bytes)[1 + byte])) << 8 * byte;
  std::string packed = bytes->substr(header_bytes);
  if (checksums_count && checksum(bytes->substr(0, 1), packed) != crc)
    return damaged_text("its checksum is wrong", what);
  auto payload = inflated(std::move(packed));
  if (!payload)
    return damaged_text(
        "it cannot be unpacked, or not into " + std::to_string(max_bytes) + " bytes", what);
  return std::move(*payload);
}

}  // namespace replay
