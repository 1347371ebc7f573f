#pragma once

// Parts of the C++20 library that Debian's Emscripten lacks and we use. Included
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
#include <limits>
#include <string>

namespace std {

#if !defined(__cpp_lib_bit_cast)
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

// Later versions of LLVM's library have to_chars, but not from_chars, and leave this undefined,
// too.
#if !defined(__cpp_lib_to_chars) && defined(__EMSCRIPTEN__)
/// The shortest text of a finite number that reads back to the same bits: plain or with an
/// exponent, whichever is shorter; plain if equal. The same bytes as other libraries give.
inline to_chars_result to_chars(char* first, char* last, double number) {
  constexpr int most_digits = 17;
  const auto reads_back = [number](const char* text) { return strtod(text, nullptr) == number; };
  array<char, 32> scientific{};
  int digits = 1;
  for (; digits <= most_digits; ++digits) {
    snprintf(scientific.data(), scientific.size(), "%.*e", digits - 1, number);
    if (reads_back(scientific.data())) break;
    // Above a power of two more reads back than below it: the next number of as many digits may,
    // where the nearest does not. One that carries over has fewer digits and was tried before.
    char* const end = strchr(scientific.data(), 'e');
    if (end[-1] == '9') continue;
    ++end[-1];
    if (reads_back(scientific.data())) break;
  }
  const char* const e = strchr(scientific.data(), 'e');
  const int exponent = atoi(e + 1);
  array<char, 400> plain{};  // the longest has 309 digits before the point, or some 340 behind it
  if (const int decimals = digits - 1 - exponent; decimals <= 0) {
    snprintf(plain.data(), plain.size(), "%.0f", number);
  } else {
    char* out = plain.data();
    const char* digit = scientific.data();
    if (*digit == '-') *out++ = *digit++;
    if (exponent < 0) {
      *out++ = '0';
      *out++ = '.';
      for (int zeros = exponent + 1; zeros < 0; ++zeros) *out++ = '0';
    }
    for (int place = exponent; digit != e; ++digit) {
      if (*digit == '.') continue;
      *out++ = *digit;
      if (place-- == 0) *out++ = '.';
    }
  }
  const char* text =
      strlen(plain.data()) <= strlen(scientific.data()) ? plain.data() : scientific.data();
  const size_t size = strlen(text);
  if (size > static_cast<size_t>(last - first)) return {last, errc::value_too_large};
  memcpy(first, text, size);
  return {first + size, errc{}};
}

/// Only the fixed form: digits, and a point among them or beside them; the sign goes before.
inline from_chars_result from_chars(const char* first, const char* last, double& number,
                                    chars_format) {
  const bool negative = first != last && *first == '-';
  string digits;  // strtod takes more forms, and reads on to a zero
  const char* at = first + (negative ? 1 : 0);
  int points = 0;
  bool any = false;
  for (; at != last; ++at) {
    const bool digit = *at >= '0' && *at <= '9';
    if (!digit && (*at != '.' || points++ > 0)) break;
    any = any || digit;
    digits += *at;
  }
  if (!any) return {first, errc::invalid_argument};
  const double value = strtod(digits.c_str(), nullptr);
  if (value > numeric_limits<double>::max()) return {at, errc::result_out_of_range};
  number = negative ? -value : value;
  return {at, errc{}};
}

/// Only the general form, of a finite number.
inline to_chars_result to_chars(char* first, char* last, double number, chars_format,
                                int precision) {
  array<char, 400> text{};
  const int size = snprintf(text.data(), text.size(), "%.*g", precision, number);
  if (size > last - first) return {last, errc::value_too_large};
  memcpy(first, text.data(), static_cast<size_t>(size));
  return {first + size, errc{}};
}
#endif

#if !defined(__cpp_lib_ranges)
namespace ranges {

template <class Range, class T, class Projection = identity>
auto find(Range&& range, const T& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), [&](const auto& element) {
    return std::invoke(projection, element) == value;
  });
}

template <class Range, class Predicate>
auto count_if(const Range& range, Predicate predicate) {
  return std::count_if(std::begin(range), std::end(range), predicate);
}

template <class Range, class T, class Projection = identity>
auto count(const Range& range, const T& value, Projection projection = {}) {
  return ranges::count_if(
      range, [&](const auto& element) { return std::invoke(projection, element) == value; });
}

template <class Range, class Predicate, class Projection = identity>
bool any_of(const Range& range, Predicate predicate, Projection projection = {}) {
  return std::any_of(std::begin(range), std::end(range), [&](const auto& element) {
    return std::invoke(predicate, std::invoke(projection, element));
  });
}

template <class Range, class Predicate, class Projection = identity>
bool all_of(const Range& range, Predicate predicate, Projection projection = {}) {
  return std::all_of(std::begin(range), std::end(range), [&](const auto& element) {
    return std::invoke(predicate, std::invoke(projection, element));
  });
}

template <class Range, class Predicate, class Projection = identity>
bool none_of(const Range& range, Predicate predicate, Projection projection = {}) {
  return std::none_of(std::begin(range), std::end(range), [&](const auto& element) {
    return std::invoke(predicate, std::invoke(projection, element));
  });
}

template <class Range, class Less = std::less<>, class Projection = identity>
auto min_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::min_element(
      std::begin(range), std::end(range), [&](const auto& left, const auto& right) {
        return less(std::invoke(projection, left), std::invoke(projection, right));
      });
}

template <class Range, class Less = std::less<>, class Projection = identity>
auto max_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::max_element(
      std::begin(range), std::end(range), [&](const auto& left, const auto& right) {
        return less(std::invoke(projection, left), std::invoke(projection, right));
      });
}

template <class Range, class T, class Less = std::less<>, class Projection = identity>
auto upper_bound(Range&& range, const T& value, Less less = {}, Projection projection = {}) {
  return std::upper_bound(
      std::begin(range), std::end(range), value,
      [&](const T& left, const auto& right) { return less(left, std::invoke(projection, right)); });
}

template <class Range, class Less = std::less<>, class Projection = identity>
void sort(Range&& range, Less less = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), [&](const auto& left, const auto& right) {
    return less(std::invoke(projection, left), std::invoke(projection, right));
  });
}

template <class Range, class Less = std::less<>, class Projection = identity>
void stable_sort(Range&& range, Less less = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), [&](const auto& left, const auto& right) {
    return less(std::invoke(projection, left), std::invoke(projection, right));
  });
}

template <class Range>
void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}

template <class Range, class T>
void replace(Range&& range, const T& what, const T& by) {
  std::replace(std::begin(range), std::end(range), what, by);
}

template <class Range, class Iterator>
void move(Range&& range, Iterator to) {
  std::move(std::begin(range), std::end(range), to);
}

}  // namespace ranges
#endif

}  // namespace std
