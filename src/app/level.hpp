#pragma once

#include <string>
#include <vector>

#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace app {

/// A level of Angry Balls on offer; also one that cannot be played, and why.
struct Level {
  std::string name;                   ///< its own, or its file's if it has none
  carom::Result<carom::Scene> scene;  ///< a sound level
  std::string problem;                ///< the first error, with its place; empty if sound
  /// 16 hexadecimal digits that change with anything in the level; empty if it is not sound.
  std::string identity;
};

/// `file`: its name, for messages; `bytes`: what is in it, or why it could not be read.
Level read_level(const std::string& file, const carom::Result<std::string>& bytes);

/// A sound level that is no file, such as that of a game kept.
Level level_of(const carom::Scene& scene);

/// The levels that are part of the program, in order.
std::vector<Level> shipped_levels();

}  // namespace app
