#include "games/level_identity.hpp"

#include "carom/fnv1a.hpp"
#include "carom/scene_file.hpp"
#include "carom/trace.hpp"

namespace games::angry_balls {

std::string identity(carom::Scene level) {
  level.author.clear();
  level.licence.clear();
  level.description.clear();
  carom::Fnv1a hash;
  hash.add(carom::write_scene(level));
  return carom::hash_text(hash.hash());
}

}  // namespace games::angry_balls
