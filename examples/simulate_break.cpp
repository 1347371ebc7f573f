#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "carom/scene_file.hpp"
#include "carom/world.hpp"

int main(int argc, char** argv) {
  std::ifstream file(argc > 1 ? argv[1] : "scenes/break.json");
  const std::string json(std::istreambuf_iterator<char>(file), {});
  auto scene = carom::read_scene(json);
  if (!scene) {
    for (const carom::Error& error : scene.errors()) std::puts(carom::to_string(error).c_str());
    return 1;
  }
  carom::World world = carom::World::create(scene.value()).value();
  while (!world.at_rest())
    for (const carom::Event& event : world.step())
      if (event.kind == carom::EventKind::pocketed)
        std::printf("step %d: ball %u falls\n", static_cast<int>(world.steps()), event.ball);
}
