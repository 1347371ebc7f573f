#pragma once

#include <array>
#include <charconv>
#include <string>

namespace carom {

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
