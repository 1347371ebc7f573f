#pragma once

#include <cstdint>
#include <string>

namespace tool {

/// "1 ball", "2 balls".
inline std::string counted(std::uint64_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace tool
