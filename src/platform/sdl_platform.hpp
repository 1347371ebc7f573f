#pragma once

#include <string>
#include <vector>

#include "app/level.hpp"
#include "app/store.hpp"
#include "app/text.hpp"

namespace platform {

/// Plays the game in a window until it is closed. Gives what went wrong when there is no display;
/// empty after a game.
std::string play_in_window(app::Language language, int width, int height, app::Store& store,
                           std::vector<app::Level> levels);

}  // namespace platform
