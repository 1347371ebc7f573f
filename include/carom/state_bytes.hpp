#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "carom/fnv1a.hpp"
#include "carom/public.hpp"
#include "carom/result.hpp"
#include "carom/version.hpp"

/// States as bytes (docs/formats.md#states): numbers little-endian, doubles as their bits. For
/// those who keep more than a world in one.
namespace carom {
namespace CAROM_PUBLIC bytes {

class Writer {
 public:
  template <std::unsigned_integral Number>
  void number(Number number) {
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
      bytes_ += static_cast<char>(number >> (8 * byte) & 0xff);
  }
  void number(double number) { this->number(std::bit_cast<std::uint64_t>(number)); }
  /// Its length first.
  void text(std::string_view text) {
    number(std::uint64_t{text.size()});
    bytes_ += text;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what a Writer wrote. What is not there reads as zero, and whole() tells.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <std::unsigned_integral Number>
  Number number() {
    Number number = 0;
    if (left_.size() < sizeof(Number)) {
      missed_ = true;
      return number;
    }
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
      number = static_cast<Number>(
          number |
          static_cast<Number>(Number{static_cast<unsigned char>(left_[byte])} << 8 * byte));
    left_.remove_prefix(sizeof(Number));
    return number;
  }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  std::string_view text() {
    const auto size = number<std::uint64_t>();
    if (size > left_.size()) {
      missed_ = true;
      return {};
    }
    const std::string_view text = left_.substr(0, static_cast<std::size_t>(size));
    left_.remove_prefix(text.size());
    return text;
  }

  std::size_t left() const { return left_.size(); }
  /// Nothing was missed so far, and nothing is left.
  bool whole() const { return !missed_ && left_.empty(); }

 private:
  std::string_view left_;
  bool missed_ = false;
};

inline constexpr std::string_view magic = "CAROM";
inline constexpr std::uint8_t state_version = 1;

inline Error damaged(std::string problem) {
  return {.pointer = "bytes",
          .problem = {MessageCode::is_damaged, {std::move(problem)}},
          .expected = {MessageCode::text, {"the bytes of save_state(), unchanged"}}};
}

inline std::uint64_t checksum(std::string_view bytes) {
  Fnv1a hash;
  hash.add(bytes);
  return hash.hash();
}

/// A payload made a state: what it is of (`kind`), the versions of format, physics and rules before
/// it, a checksum of all behind it.
inline std::string seal(char kind, std::string_view payload) {
  Writer head;
  head.number(static_cast<std::uint8_t>(kind));
  head.number(state_version);
  head.number(std::uint32_t{physics_version});
  head.number(std::uint32_t{rules_version});
  std::string bytes = std::string(magic) + head.take() + std::string(payload);
  Writer tail;
  tail.number(checksum(bytes));
  return bytes + tail.take();
}

/// The payload again. Refuses other bytes, other kinds and versions, and wrong checksums.
inline Result<std::string_view> unseal(char kind, std::string_view bytes) {
  constexpr std::size_t head_bytes = magic.size() + 10;
  if (!bytes.starts_with(magic) || bytes.size() < head_bytes + 8) return damaged("it is no state");
  const std::string_view sealed = bytes.substr(0, bytes.size() - 8);
  // Fuzzers, which define this name of old, could never guess a right checksum.
#ifndef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  if (Reader(bytes.substr(sealed.size())).number<std::uint64_t>() != checksum(sealed))
    return damaged("its checksum is wrong");
#endif
  Reader head(sealed.substr(magic.size()));
  if (head.number<std::uint8_t>() != static_cast<std::uint8_t>(kind))
    return damaged("it is a state of something else");
  const auto fits = [&](std::uint64_t theirs, int ours) {
    return theirs == static_cast<std::uint64_t>(ours);
  };
  const auto made_by = [](std::string what, std::uint64_t theirs, int ours) {
    return Error{.pointer = "bytes",
                 .problem = {MessageCode::is_of_other_version,
                             {std::move(what), std::to_string(theirs), std::to_string(ours)}}};
  };
  if (const auto format = head.number<std::uint8_t>(); !fits(format, state_version))
    return made_by("format", format, state_version);
  if (const auto physics = head.number<std::uint32_t>(); !fits(physics, physics_version))
    return made_by("physics", physics, physics_version);
  if (const auto rules = head.number<std::uint32_t>(); kind != 'w' && !fits(rules, rules_version))
    return made_by("rules", rules, rules_version);
  return sealed.substr(head_bytes);
}

}  // namespace bytes
}  // namespace carom
