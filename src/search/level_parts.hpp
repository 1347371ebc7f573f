#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "carom/scene.hpp"
#include "games/random.hpp"

namespace search {

/// What generated levels are put together from, left to right on the floor.
enum class Part : std::uint8_t {
  ball,      ///< an enemy on the floor
  sentinel,  ///< an enemy on an obstacle
  tower,     ///< balls on each other, an enemy on top
  pyramid,   ///< three balls, two on them, an enemy on top
  pit,       ///< enemies between two obstacles
  wall,      ///< an obstacle, an enemy behind it
  chain,     ///< balls in a row that pass a shock on to an enemy
  room,      ///< the right side and the top are solid; an enemy far up
};
inline constexpr std::array<std::string_view, 8> part_names{"ball", "sentinel", "tower", "pyramid",
                                                            "pit",  "wall",     "chain", "room"};

/// A level of so many parts, the first of which is `first`: sound, but not always one that stays as
/// it is, or that can be won.
carom::Scene assemble(Part first, std::size_t parts, games::Random& random);

}  // namespace search
