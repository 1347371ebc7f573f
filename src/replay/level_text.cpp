#include "replay/level_text.hpp"

#include "carom/scene_file.hpp"
#include "games/angry_balls.hpp"
#include "replay/packed_text.hpp"

namespace replay {

namespace {

// Far from the versions of a replay's text, so that neither is taken for the other.
constexpr char format_version = 65;
constexpr std::string_view what = "a level";

}  // namespace

std::string write_level_text(const carom::Scene& level) {
  return pack(format_version, carom::write_scene(level));
}

carom::Result<carom::Scene> read_level_text(std::string_view text) {
  const auto payload = unpack(text, format_version, what);
  if (!payload) return payload.errors();
  auto level = games::angry_balls::read_level(payload.value());
  if (level && carom::write_scene(level.value()) != payload.value())
    return damaged_text("it is not written as it should be", what);
  return level;
}

}  // namespace replay
