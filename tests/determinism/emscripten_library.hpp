#pragma once

// What Debian's Emscripten lacks of the C++20 library and the engine and the rules use. Included
// before everything else when we compile to WebAssembly.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>

namespace std {

#if !defined(__cpp_lib_bit_cast)
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

#if !defined(__cpp_lib_to_chars)
/// The shortest text of a finite number that reads back to the same bits: plain or with an
/// exponent, whichever is shorter; plain if equal. The same bytes as other libraries give, but for
/// some powers of two a digit longer.
inline to_chars_result to_chars(char* first, char* last, double number) {
  constexpr int most_digits = 17;
  array<char, 400> scientific{};
  int digits = 1;
  for (; digits <= most_digits; ++digits) {
    snprintf(scientific.data(), scientific.size(), "%.*e", digits - 1, number);
    if (strtod(scientific.data(), nullptr) == number) break;
  }
  const int exponent = atoi(strchr(scientific.data(), 'e') + 1);
  const int decimals = digits - 1 - exponent;
  array<char, 400> plain{};  // the longest has 309 digits before the point, or some 340 behind it
  snprintf(plain.data(), plain.size(), "%.*f", decimals > 0 ? decimals : 0, number);
  const char* text =
      strlen(plain.data()) <= strlen(scientific.data()) ? plain.data() : scientific.data();
  const size_t size = strlen(text);
  if (size > static_cast<size_t>(last - first)) return {last, errc::value_too_large};
  memcpy(first, text, size);
  return {first + size, errc{}};
}
#endif

#if !defined(__cpp_lib_ranges)
namespace ranges {

template <class Range, class T, class Projection = identity>
auto count(const Range& range, const T& value, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), [&](const auto& element) {
    return std::invoke(projection, element) == value;
  });
}

template <class Range, class Predicate>
bool none_of(const Range& range, Predicate predicate) {
  return std::none_of(std::begin(range), std::end(range), predicate);
}

}  // namespace ranges
#endif

}  // namespace std
