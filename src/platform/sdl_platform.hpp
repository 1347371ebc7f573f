#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/level.hpp"
#include "app/store.hpp"
#include "app/text.hpp"
#include "replay/replay.hpp"

namespace platform {

/// Plays the game in a window until it is closed; first `replay` is shown, if there is one. Gives
/// what went wrong when there is no display; empty after a game.
std::string play_in_window(app::StartLanguage language, int width, int height, app::Store& store,
                           std::vector<app::Level> levels, std::optional<replay::Replay> replay);

}  // namespace platform
