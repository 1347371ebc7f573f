#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "carom/rollouts.hpp"
#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "carom/version.hpp"
#include "carom/world.hpp"
#include "games/billiards.hpp"

// Plays the scene of a file to rest and prints the hash of the end; then a break by the rules.
int main(int, char** argv) {
  if (std::string(CAROM_VERSION) != carom::library_version()) return 1;
  std::ifstream file(argv[1]);
  auto world = carom::World::create(
      carom::read_scene(std::string(std::istreambuf_iterator<char>(file), {})).value());
  if (!world) return 1;
  world.value().run({.rest = true}, 100'000);
  std::printf("%s\n", carom::hash_text(world.value().state_hash()).c_str());

  games::billiards::Game game;
  if (!game.apply(games::billiards::Shoot{{400, 1}})) return 1;
  while (game.phase() == games::billiards::Phase::roll) game.step();
  std::printf("%s\n", carom::hash_text(game.world().state_hash()).c_str());
}
