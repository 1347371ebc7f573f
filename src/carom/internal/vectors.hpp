#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace carom {

// Some numbers at a time, on every processor: the compiler's own vectors. Each lane is rounded as a
// single number is, so doubles give the same bits either way. Floats only ever choose what is then
// tested in doubles.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

using Double2 = double __attribute__((vector_size(16)));
using Long2 = std::int64_t __attribute__((vector_size(16)));

template <class Numbers>
Numbers load(const double* from) {
  Numbers numbers;
  std::memcpy(&numbers, from, sizeof numbers);
  return numbers;
}

template <class Numbers>
Numbers all_lanes(double number) {
  if constexpr (std::is_same_v<Numbers, double>)
    return number;
  else
    return Numbers{number, number};
}

template <class Numbers>
void store(double* to, Numbers numbers) {
  std::memcpy(to, &numbers, sizeof numbers);
}

inline Float4 load4(const float* from) {
  Float4 four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

inline Int4 load4(const std::uint32_t* from) {
  Int4 four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

inline Int4 splat(std::uint32_t value) {
  const auto v = static_cast<std::int32_t>(value);
  return Int4{v, v, v, v};
}

using Short8 = std::int16_t __attribute__((vector_size(16)));

inline Short8 load8(const std::int16_t* from) {
  Short8 eight;
  std::memcpy(&eight, from, sizeof eight);
  return eight;
}

inline Short8 splat8(std::int16_t v) { return Short8{v, v, v, v, v, v, v, v}; }

inline Float4 splat(float value) { return Float4{value, value, value, value}; }

inline Double2 min2(Double2 a, Double2 b) {
#ifdef __SSE2__
  return _mm_min_pd(a, b);
#else
  return a < b ? a : b;
#endif
}

inline Double2 max2(Double2 a, Double2 b) {
#ifdef __SSE2__
  return _mm_max_pd(a, b);
#else
  return a > b ? a : b;
#endif
}

inline Double2 absolute2(Double2 a) {
  return std::bit_cast<Double2>(std::bit_cast<Long2>(a) & 0x7fffffffffffffff);
}

/// The lower 32 bits of each lane times a factor.
inline Long2 multiply_low(Long2 lanes, std::uint32_t factor) {
#ifdef __SSE2__
  return std::bit_cast<Long2>(
      _mm_mul_epu32(std::bit_cast<__m128i>(lanes), _mm_set1_epi64x(std::int64_t{factor})));
#else
  return (lanes & 0xffffffff) * std::int64_t{factor};
#endif
}

/// The lanes of a comparison's result as bits, the first lowest.
inline unsigned bits(Int4 lanes) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(lanes)));
#else
  return static_cast<unsigned>((lanes[0] & 1) | (lanes[1] & 2) | (lanes[2] & 4) | (lanes[3] & 8));
#endif
}

inline unsigned bits(Long2 lanes) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<__m128d>(lanes)));
#else
  return static_cast<unsigned>((lanes[0] & 1) | (lanes[1] & 2));
#endif
}

inline unsigned bits(Short8 lanes) {
#ifdef __SSE2__
  const auto wide = std::bit_cast<__m128i>(lanes);
  return static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(wide, wide))) & 0xffU;
#else
  unsigned all = 0;
  for (unsigned lane = 0; lane < 8; ++lane) all |= lanes[lane] != 0 ? 1U << lane : 0;
  return all;
#endif
}

/// True if every lane of a comparison's result is true.
inline bool all(Int4 lanes) { return bits(lanes) == 0xfU; }

/// Calls visit(place) for the places of the bits that are set, in order.
template <class Visit>
void for_each_bit(unsigned bits, Visit visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

}  // namespace carom
