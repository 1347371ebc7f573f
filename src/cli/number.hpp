#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

/// Shared by the command lines of both programs.
namespace cli {

/// Reads a whole number: decimal digits and nothing else, so "010" is 10. None for anything else
/// and for what is beyond 64 bits.
std::optional<std::uint64_t> read_whole(std::string_view text);

/// Reads a number: decimal digits with an optional minus before, a point within and an exponent, in
/// any locale. None for anything else, infinity and what is beyond binary64 included.
std::optional<double> read_number(std::string_view text);

}  // namespace cli
