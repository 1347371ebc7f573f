#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "carom/display_text.hpp"
#include "cli/number.hpp"

namespace cli {

/// Makes what CLI11 says of a wrong command line fit to show: it repeats arguments as they are.
inline void show_failures(CLI::App& app) {
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return carom::display_text(error.what()) + "\nRun with --help for more information.\n";
  });
}

/// Message of a numeric option whose text is not `expected`; ends the parsing.
[[noreturn]] inline void refuse(const std::string& option, const std::string& text,
                                const std::string& expected) {
  throw CLI::ValidationError(option,
                             "is \"" + carom::display_text(text) + "\"; expected " + expected);
}

/// Refuses an empty text where a file is to be named: what a script's unset variable gives.
inline CLI::Validator file_name() {
  return {[](const std::string& name) {
            return name.empty() ? std::string("is empty; expected the name of a file")
                                : std::string();
          },
          {}};
}

/// Adds an option that takes a whole number from `least` to `most`, by read_whole() and not as
/// CLI11 reads numbers: it takes octal, hexadecimal, empty and negative ones. `Number` may be an
/// integer or an optional of one.
template <class Number>
CLI::Option* add_whole(CLI::App& app, const std::string& name, Number& number,
                       const std::string& description, std::uint64_t least = 0,
                       std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  return app.add_option_function<std::string>(
      name,
      [&number, name, least, most](const std::string& text) {
        const auto read = read_whole(text);
        if (!read || *read < least || *read > most)
          refuse(name, text,
                 "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        if constexpr (std::integral<Number>)
          number = static_cast<Number>(*read);
        else
          number = static_cast<typename Number::value_type>(*read);
      },
      description);
}

/// Adds an option that takes two numbers and a comma between, by read_number().
inline CLI::Option* add_vector(CLI::App& app, const std::string& name,
                               std::optional<std::pair<double, double>>& vector,
                               const std::string& description) {
  return app.add_option_function<std::string>(
      name,
      [&vector, name](const std::string& text) {
        const std::size_t comma = text.find(',');
        const auto x = read_number(std::string_view(text).substr(0, comma));
        const auto y = comma == std::string::npos
                           ? std::nullopt
                           : read_number(std::string_view(text).substr(comma + 1));
        if (!x || !y) refuse(name, text, "two numbers with a comma between, such as 775,-70");
        vector.emplace(*x, *y);
      },
      description);
}

}  // namespace cli
