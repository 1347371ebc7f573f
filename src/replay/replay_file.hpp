#pragma once

#include <string>
#include <string_view>

#include "carom/result.hpp"
#include "replay/replay.hpp"

namespace replay {

/// Reads a replay in either form, told apart by the first character. A text may be
/// a whole link, or folded by a mail program (pasted_text()).
carom::Result<Replay> read_replay(std::string_view bytes);

/// Reads a replay from JSON (docs/formats.md). Refuses whatever is not exactly that, and whatever
/// check() finds wrong, with line, column and pointer of the first error (of all errors within the
/// level). Nothing is half-read, and nothing is played.
carom::Result<Replay> read_json(std::string_view json);

/// Writes a sound replay with full hashes so that read_json() gives it back, bit by bit; same
/// replay, same bytes. -0 is written as 0. A level whose text is larger than max_bytes cannot be
/// read back.
std::string write_json(const Replay& replay);

}  // namespace replay
