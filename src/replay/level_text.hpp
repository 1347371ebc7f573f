#pragma once

#include <string>
#include <string_view>

#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace replay {

/// Reads a level from its text for links (docs/formats.md). Refuses whatever write_level_text()
/// does not give, and texts that are not a sound level.
carom::Result<carom::Scene> read_level_text(std::string_view text);

/// Writes a sound level as text: letters, digits, '-' and '_' only. One whose file is larger than
/// max_bytes cannot be read back.
std::string write_level_text(const carom::Scene& level);

}  // namespace replay
