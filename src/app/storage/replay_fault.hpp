#pragma once

#include <cstdint>

#include "app/text/text.hpp"
#include "carom/result.hpp"

namespace app {

/// Why something is not taken for a replay, as reported to the player.
enum class ReplayFault : std::uint8_t {
  unreadable,     ///< there, and not to be read
  damaged,        ///< cut off, changed, or never was one
  other_version,  ///< made by another version of the game
  diverged,       ///< whole, but the game does not go that way
  finished,       ///< a game that is over cannot be continued
};

/// `errors`: of replay::read_replay().
ReplayFault fault_of(const carom::Errors& errors);
Text text_of(ReplayFault fault);

}  // namespace app
