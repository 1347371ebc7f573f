#pragma once

#include <string>

#include "app/storage/level.hpp"
#include "app/text/text.hpp"

namespace app {

/// Why a level cannot be played, with file and place, as Level::problem; in French as far as the
/// error is one of the frequent ones. Empty if the level is sound.
std::string problem_of(const Words& words, const Level& level);

}  // namespace app
