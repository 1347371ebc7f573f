#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/storage/store.hpp"
#include "app/text/text.hpp"
#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace app {

/// Where a level comes from. Known from the level's contents, never from its name.
enum class Origin : std::uint8_t {
  shipped,  ///< part of the program
  own,      ///< a file of the player's
  unknown,  ///< came with a link or a replay
};

/// A level of Angry Balls on offer; also one that cannot be played, and why.
struct Level {
  std::string name;                   ///< its own, or its file's; may be empty (Words::level_name)
  carom::Result<carom::Scene> scene;  ///< a sound level
  std::string problem;                ///< the first error, with its place; empty if sound
  /// 16 hexadecimal digits that change with anything in the level; empty if it is not sound.
  std::string identity;
  std::string file{};  ///< its name, for messages
  Origin origin = Origin::unknown;
};

/// `file`: its name, for messages; `bytes`: what is in it, or why it could not be read.
Level read_level(const std::string& file, const carom::Result<std::string>& bytes);

/// A sound level without a file, such as that of a saved game.
Level level_of(const carom::Scene& scene);

/// Name of a level among other words: of a shipped one its own, of others in quotes, with
/// where they come from.
std::string shown_name(const Words& words, const Level& level);

/// The levels that are part of the program, in order.
std::vector<Level> shipped_levels();

/// The folder of the store with the player's own levels.
inline const std::string own_levels = "levels/";

/// The player's own levels, by name. What cannot be read is a level that cannot be played.
std::vector<Level> kept_levels(Store& store);

}  // namespace app
