#include "app/level.hpp"

#include <filesystem>

#include "app/embedded.hpp"
#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "games/angry_balls.hpp"

namespace app {
namespace {

std::uint64_t fnv_1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes)
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x00000100000001b3;
  return hash;
}

carom::Result<carom::Scene> sound_level(const carom::Result<std::string>& bytes) {
  if (!bytes) return bytes.errors();
  auto scene = carom::read_scene(bytes.value());
  if (!scene) return scene;
  carom::Errors errors = games::angry_balls::check_level(scene.value());
  if (!errors.empty()) return carom::locate(bytes.value(), std::move(errors));
  return scene;
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
  level.identity = carom::hash_text(fnv_1a(carom::write_scene(scene)));
  return level;
}

std::vector<Level> shipped_levels() {
  std::vector<Level> levels;
  for (const Embedded& file : shipped_files)
    levels.push_back(
        read_level(std::string(file.name), std::string(file.bytes.begin(), file.bytes.end())));
  return levels;
}

}  // namespace app
