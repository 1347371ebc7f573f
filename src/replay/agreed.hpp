#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "replay/replay.hpp"

namespace replay {

/// Something that version 2 of both written forms can say of a game, as a whole number.
struct Agreed {
  std::string_view key;       ///< in a file
  bool truth;                 ///< in a file it is true (1) or false (0)
  std::uint64_t usual;        ///< in version 1, and where it is left out of a file
  std::string_view expected;  ///< for messages
  std::uint64_t (*get)(const Replay&);
  /// Returns false, and changes nothing, if the number is none that can be.
  bool (*set)(Replay&, std::uint64_t);
};

/// In the order in which they are written.
std::span<const Agreed> agreed();

/// The version of both forms that a replay is written in: 1 if all is as usual, otherwise 2.
int form_version(const Replay& replay);

}  // namespace replay
