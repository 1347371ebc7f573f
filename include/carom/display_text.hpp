#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "carom/public.hpp"

namespace CAROM_PUBLIC carom {

/// Text of unknown origin (names, file names, keys of a file) fit to show on one line of a terminal
/// or a window, in UTF-8. What would move the cursor, end the line, turn the direction of writing
/// or cannot be seen is written out, \u{202e}; bytes that are no UTF-8 as \x{ff}.
/// Of more than `most` characters the first are kept, and "…" stands for the others.
std::string display_text(std::string_view text, std::size_t most = 1'000'000);

/// Is true for the code points that display_text() shows as they are.
bool is_shown(std::uint32_t code_point);

}  // namespace carom
