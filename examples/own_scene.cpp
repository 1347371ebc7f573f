// Makes a scene in the program, changes it while it moves, and writes it as a file: own_scene FILE
#include <cstdio>
#include <fstream>

#include "carom/scene_file.hpp"
#include "carom/world.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  carom::Scene scene;
  scene.name = "A funnel";
  scene.gravity = 500;
  scene.holes = {{.position = {400, 20}, .radius = 30}};
  scene.obstacles = {{.x = 300, .height = 150, .radius = 20},
                     {.x = 500, .height = 150, .radius = 20}};
  for (int i = 0; i < 10; ++i)
    scene.balls.push_back({.position = {310.0 + 20 * i, 350}, .radius = 8});
  for (const carom::Error& error : carom::check(scene)) std::puts(to_string(error).c_str());
  auto created = carom::World::create(scene);
  if (!created) return 1;
  std::ofstream(argv[1]) << carom::write_scene(scene);

  carom::World& world = created.value();
  for (int second = 1; second <= 4; ++second) {
    int fallen = 0;
    world.run({}, carom::steps_per_second, [&](auto, std::span<const carom::Event> events) {
      for (const carom::Event& event : events) fallen += event.hole() ? 1 : 0;
    });
    std::printf("second %d: %d fell, %zu are left\n", second, fallen, world.balls_left());
    // A heavy shower: one ball more, somewhere above the funnel.
    if (!world.add({.position = {350.0 + 20 * second, 380}, .radius = 10})) return 1;
  }
}
