#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace carom {

// Some numbers at a time, on every processor: the compiler's own vectors. Each lane is rounded as a
// single number is, so doubles give the same bits either way. Floats only ever choose what is then
// tested in doubles.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

using Double2 = double __attribute__((vector_size(16)));
using Long2 = std::int64_t __attribute__((vector_size(16)));

inline Double2 load2(const double* from) {
  Double2 two;
  std::memcpy(&two, from, sizeof two);
  return two;
}

inline Float4 load4(const float* from) {
  Float4 four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

using Short8 = std::int16_t __attribute__((vector_size(16)));

inline Short8 load8(const std::int16_t* from) {
  Short8 eight;
  std::memcpy(&eight, from, sizeof eight);
  return eight;
}

inline Short8 splat8(std::int16_t v) { return Short8{v, v, v, v, v, v, v, v}; }

inline Float4 splat(float value) { return Float4{value, value, value, value}; }

/// Calls visit(lane) for the lanes of a comparison's result that are false, in order.
template <class Visit>
void for_each_false(Short8 lanes, Visit visit) {
  using Byte8 = std::int8_t __attribute__((vector_size(8)));
  const Byte8 bytes = __builtin_convertvector(lanes, Byte8);
  std::uint64_t left;
  std::memcpy(&left, &bytes, sizeof left);
  for (left = ~left; left != 0;) {
    const auto lane = static_cast<unsigned>(std::countr_zero(left)) / 8;
    left &= ~(std::uint64_t{0xff} << (8 * lane));
    visit(std::endian::native == std::endian::little ? lane : 7 - lane);
  }
}

/// For comparing: four slots from this one on.
inline Int4 slots4(std::uint32_t first) {
  const auto n = static_cast<std::int32_t>(first);
  return Int4{n, n + 1, n + 2, n + 3};
}

/// Whether every lane of a comparison's result is true.
template <class Lanes>
bool all(Lanes lanes) {
  Long2 halves;
  std::memcpy(&halves, &lanes, sizeof halves);
  return (halves[0] & halves[1]) == -1;
}

}  // namespace carom
