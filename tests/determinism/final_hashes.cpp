#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>

#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "carom/world.hpp"

/// Reads a scene from standard input and prints its state hash after each of as many steps as the
/// argument says.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string json(std::istreambuf_iterator<char>(std::cin), {});
  auto scene = carom::read_scene(json);
  if (!scene) return 1;
  auto world = carom::World::create(std::move(scene).value());
  if (!world) return 1;
  for (long steps = std::strtol(argv[1], nullptr, 10); steps > 0; --steps) {
    world.value().step();
    std::puts(carom::hash_text(world.value().state_hash()).c_str());
  }
}
