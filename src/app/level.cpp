#include "app/level.hpp"

#include <filesystem>

#include "app/embedded.hpp"
#include "carom/fnv1a.hpp"
#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "games/angry_balls.hpp"

namespace app {
namespace {

carom::Result<carom::Scene> sound_level(const carom::Result<std::string>& bytes) {
  if (!bytes) return bytes.errors();
  return games::angry_balls::read_level(bytes.value());
}

std::string identity_of(const carom::Scene& scene) {
  carom::Fnv1a hash;
  hash.add(carom::write_scene(scene));
  return carom::hash_text(hash.hash());
}

}  // namespace

Level read_level(const std::string& file, const carom::Result<std::string>& bytes) {
  Level level{std::filesystem::path(file).stem().string(), sound_level(bytes), {}, {}};
  if (!level.scene) {
    level.problem = carom::to_string(level.scene.errors().front(), file);
    return level;
  }
  const carom::Scene& scene = level.scene.value();
  if (!scene.name.empty()) level.name = scene.name;
  level.identity = identity_of(scene);
  return level;
}

Level level_of(const carom::Scene& scene) { return {scene.name, scene, {}, identity_of(scene)}; }

std::vector<Level> shipped_levels() {
  std::vector<Level> levels;
  for (const Embedded& file : shipped_files)
    levels.push_back(
        read_level(std::string(file.name), std::string(file.bytes.begin(), file.bytes.end())));
  return levels;
}

}  // namespace app
