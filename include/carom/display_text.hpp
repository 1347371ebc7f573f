#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace carom {

/// Text of unknown origin (names, file names, keys of a file) fit to show on one line of a terminal
/// or a window, in UTF-8. What would move the cursor, end the line, turn the direction of writing
/// or cannot be seen is written out, \u{202e}; bytes that are no UTF-8 as \x{ff}.
/// Of more than `most` characters the first are kept, and "…" stands for the others.
std::string display_text(std::string_view text, std::size_t most = 1'000'000);

}  // namespace carom
