#pragma once

namespace tool {

// Exit statuses of every command.
inline constexpr int done = 0;
inline constexpr int wrong_input = 1;  ///< a file is wrong, or cannot be read or written
inline constexpr int wrong_usage = 2;

}  // namespace tool
