#pragma once

#include <string>

#include "carom/scene.hpp"

namespace games::angry_balls {

/// The identity of a sound level: 16 hexadecimal digits that change with anything in it but author,
/// licence and description (docs/formats.md).
std::string identity(carom::Scene level);

}  // namespace games::angry_balls
