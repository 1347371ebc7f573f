#pragma once

#include <array>
#include <charconv>
#include <cstdlib>
#include <locale.h>
#include <string>
#include <string_view>

namespace carom {

/// The number that a JSON number says, in any locale. -0 becomes 0, what is next to nothing too.
inline double read_number(std::string_view digits) {
  double number = 0;
#if defined(__cpp_lib_to_chars)
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
#else  // LLVM's library has from_chars for integers only, and its strtod goes by the locale.
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  number = strtod_l(std::string(digits).c_str(), nullptr, plain);
#endif
  return number + 0.0;
}

/// Appends a finite number in the shortest form that reads back to the same bits, in any locale;
/// -0.0 as 0.
template <class Number>
void append_number(std::string& out, Number number) {
  std::array<char, 32> digits;
  // Adding zero turns -0.0 into 0.0 and changes nothing else.
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number + Number{});
  out.append(digits.data(), end.ptr);
}

}  // namespace carom
