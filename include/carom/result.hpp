#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace carom {

/// One thing wrong with what the library was given. The library collects errors and never prints.
struct Error {
  /// Where: a JSON pointer into the scene ("/balls/3/radius"; "" is the whole), or the name of the
  /// parameter that a function refused ("velocity").
  std::string pointer{};
  /// What is wrong: "is -8", "is missing", "is an unknown key".
  std::string problem{};
  /// What would have been right: "a number greater than 0 and at most 1000000000 (px)".
  std::string expected{};
  /// Position in the bytes parsed, both from 1, the column counted in bytes; 0 when there are none.
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Never empty inside a failed Result.
using Errors = std::vector<Error>;

/// "file:line:column: /pointer: problem; expected …", parts that are unknown left out. One line,
/// whatever the file and its name contain: control characters and the like are written out.
std::string to_string(const Error& error, std::string_view file = {});

struct Done {};

/// Either a value or the reasons why there is none. After a failure nothing has changed.
template <class T = Done>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Errors errors) : state_(std::in_place_index<1>, std::move(errors)) {}
  Result(Error error) : state_(std::in_place_index<1>, Errors{std::move(error)}) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value; only when ok().
  T& value() & { return *std::get_if<0>(&state_); }
  const T& value() const& { return *std::get_if<0>(&state_); }
  T&& value() && { return std::move(*std::get_if<0>(&state_)); }

  /// The errors; only when not ok().
  const Errors& errors() const { return *std::get_if<1>(&state_); }

 private:
  std::variant<T, Errors> state_;
};

using Status = Result<Done>;

}  // namespace carom
