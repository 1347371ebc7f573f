#include "app/storage/level.hpp"

#include "app/base/embedded.hpp"
#include "carom/scene_file.hpp"
#include "games/angry_balls.hpp"
#include "games/level_identity.hpp"
#include "search/proof_file.hpp"

namespace app {
namespace {

/// More would not be played at full speed anywhere.
constexpr std::size_t most_balls = 20'000;
/// As written, bytes: a replay of the level, of whatever moves, then is within replay::max_bytes.
constexpr std::size_t most_bytes = 5 << 19;

carom::Result<carom::Scene> sound_level(const carom::Result<std::string>& bytes) {
  if (!bytes) return bytes.errors();
  auto level = games::angry_balls::read_level(bytes.value());
  if (level && level.value().balls.size() > most_balls)
    return carom::Error{
        .pointer = "/balls",
        .problem = {carom::MessageCode::has_elements, {std::to_string(level.value().balls.size())}},
        .expected = {carom::MessageCode::at_most, {std::to_string(most_balls)}}};
  if (level && carom::write_scene(level.value()).size() > most_bytes)
    return carom::Error{
        .problem = {carom::MessageCode::is_larger_than_bytes, {std::to_string(most_bytes)}}};
  return level;
}

/// "a" for "a.json".
std::string stem(const std::string& file) { return file.substr(0, file.rfind('.')); }

}  // namespace

Level read_level(const std::string& file, const carom::Result<std::string>& bytes) {
  Level level{stem(file), sound_level(bytes), {}, {}, file};
  if (!level.scene) {
    level.problem = carom::to_string(level.scene.errors().front(), file);
    return level;
  }
  const carom::Scene& scene = level.scene.value();
  level.identity = games::angry_balls::identity(scene);
  // A file that open_file() has kept has the identity for its name, which tells the player nothing.
  if (!scene.name.empty() || level.name == level.identity) level.name = scene.name;
  return level;
}

Level level_of(const carom::Scene& scene) {
  return {scene.name, scene, {}, games::angry_balls::identity(scene), {}};
}

std::string shown_name(const Words& words, const Level& level) {
  if (level.origin == Origin::shipped) return words.level_name(level.name);
  return words(level.origin == Origin::own ? Text::own_level : Text::unknown_level,
               {words.foreign_name(level.name)});
}

std::vector<Level> shipped_levels() {
  std::vector<Level> levels;
  for (const Embedded& file : shipped_files) {
    levels.push_back(
        read_level(std::string(file.name), std::string(file.bytes.begin(), file.bytes.end())));
    levels.back().origin = Origin::shipped;
  }
  return levels;
}

std::vector<Level> kept_levels(Store& store) {
  std::vector<Level> levels;
  for (const std::string& name : store.list(own_levels)) {
    if (search::lies_beside_levels(name)) continue;
    const auto text = store.load(name);
    const carom::Error gone{.pointer = {}, .problem = carom::MessageCode::is_gone};
    const std::string file = name.substr(own_levels.size());
    levels.push_back(!text ? read_level(file, text.errors())
                           : read_level(file, text.value() ? carom::Result(*text.value()) : gone));
  }
  return levels;
}

}  // namespace app
