#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "carom/message.hpp"
#include "carom/vec2.hpp"
#include "replay/replay.hpp"

namespace replay {

// Shared by both written forms of a replay.

/// True: a wrong checksum is refused. Fuzzers, which define this name of old, could never guess a
/// right one and would see nothing of what comes behind.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr bool checksums_count = false;
#else
inline constexpr bool checksums_count = true;
#endif

/// Says of a version that it is not this program's `own`: "made by physics 2, this is physics 1".
inline carom::Message made_by(std::string_view what, std::uint64_t version, int own) {
  return {carom::MessageCode::is_of_other_version,
          {std::string(what), std::to_string(version), std::to_string(own)}};
}

struct CommandName {
  std::string_view name;  ///< in a file
  Kind kind;
  bool moves;  ///< the world moves after it
  Command command;
};

/// In the order of the alternatives of Command.
inline constexpr CommandName command_names[] = {
    {"shoot", Kind::billiards, true, games::billiards::Shoot{}},
    {"place", Kind::billiards, false, games::billiards::Place{}},
    {"throw", Kind::angry_balls, true, games::angry_balls::Throw{}},
    {"next", Kind::angry_balls, false, games::angry_balls::Next{}},
};

inline std::string expected_commands(Kind kind) {
  return kind == Kind::billiards ? R"("shoot" or "place" in billiards)"
                                 : R"("throw" or "next" in Angry Balls)";
}

/// The drag or place of a command, px; null for Next, which has none.
inline carom::Vec2* vector_of(Command& command) {
  if (auto* shoot = std::get_if<games::billiards::Shoot>(&command)) return &shoot->drag;
  if (auto* place = std::get_if<games::billiards::Place>(&command)) return &place->position;
  if (auto* thrown = std::get_if<games::angry_balls::Throw>(&command)) return &thrown->drag;
  return nullptr;
}
inline const carom::Vec2* vector_of(const Command& command) {
  return vector_of(const_cast<Command&>(command));  // which the other one does not change
}

}  // namespace replay
