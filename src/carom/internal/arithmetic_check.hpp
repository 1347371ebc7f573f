#pragma once

#include <bit>
#include <cstdint>

namespace carom {

// `static`: each source that calls it tests what it was compiled with itself.

/// True if the options that this source was compiled with leave arithmetic as it is written: no
/// reordering, no quotients by reciprocals, no fused multiply-adds, no constants as floats, zeros
/// with their signs. What has a macro is refused at compile time (vec2.hpp); clang has none for
/// most.
[[maybe_unused]] static bool arithmetic_is_exact() {
  const auto is = [](double number, std::uint64_t bits) {
    return std::bit_cast<std::uint64_t>(number) == bits;
  };
  // The compiler does not know these.
  volatile double volatile_large = 0x1p53, volatile_one = 1, volatile_three = 3;
  volatile double volatile_small = 1 + 0x1p-30, volatile_zero = -0.0;
  const double large = volatile_large, one = volatile_one, three = volatile_three;
  const double small = volatile_small, zero = volatile_zero;
  // Added from the left each 1 is lost, added up first they are not.
  const double sum = large + one + one - large;
  // 5/3 and 7/3 are not the products with 1/3.
  const double five = 4 * one + one;
  const double seven = five + 2 * one;
  const double q = five / three, r = seven / three, s = one / three;
  // The exact square has a bit that rounding drops, and a fused subtraction keeps.
  // Volatile: by itself, not as a lane of a vector with the others, which would not be fused.
  const volatile double square = small * small - (1 + 0x1p-29);
  return is(sum, 0) && is(q, 0x3ffaaaaaaaaaaaab) && is(r, 0x4002aaaaaaaaaaab) &&
         is(s, 0x3fd5555555555555) && is(square, 0) && is(one * 0.1, 0x3fb999999999999a) &&
         is(zero + 0.0, 0);
}

/// The same for step.cpp.
bool step_arithmetic_is_exact();

}  // namespace carom
