#pragma once

#include <string>
#include <string_view>

#include "carom/result.hpp"
#include "games/launch.hpp"
#include "replay/replay.hpp"

namespace replay {

/// Drags and places that are multiples of this, in px, take two bytes or three in a text; any other
/// number takes eight.
inline constexpr double text_grid = games::grid;

/// Reads a replay from its text for links (docs/formats.md), which gives short hashes. Refuses a
/// text that was not taken whole, or changed, or unpacks to more than max_bytes, and whatever
/// check() finds wrong. Nothing is played.
carom::Result<Replay> read_text(std::string_view text);

/// Writes a sound replay as text: letters, digits, '-' and '_' only. read_text() gives the same
/// replay with short hashes. -0 is written as 0.
std::string write_text(const Replay& replay);

}  // namespace replay
