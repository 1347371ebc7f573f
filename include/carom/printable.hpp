#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace carom {

/// Foreign text made fit to show within a line: names, file names, keys, pieces of files. What is
/// not UTF-8 becomes U+FFFD; control characters and line breaks become blanks; characters that only
/// steer how others are shown (bidirectional overrides, joiners, marks of order, tags) are left
/// out. Of more than `most` code points the first are kept, and "…" stands for the others.
std::string printable(std::string_view text, std::size_t most = 1000);

}  // namespace carom
