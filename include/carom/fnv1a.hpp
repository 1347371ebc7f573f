#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "carom/public.hpp"

namespace CAROM_PUBLIC carom {

/// The 64-bit hash FNV-1a, fed piece by piece; numbers count as their bytes, little-endian.
class Fnv1a {
 public:
  template <std::unsigned_integral Number>
  void add(Number number) {
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte) {
      hash_ ^= static_cast<std::uint64_t>(number >> (8 * byte)) & 0xff;
      hash_ *= 0x100000001b3;
    }
  }
  /// Adding 0.0 turns -0.0, whose sign says nothing, into 0.0 and changes no other number.
  void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }
  void add(std::string_view bytes) {
    for (const char byte : bytes) add(static_cast<std::uint8_t>(byte));
  }

  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace carom
