// Writes where a thrown ball is after each step, as CSV: trajectory LEVEL VX VY
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "carom/scene_file.hpp"
#include "carom/world.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::ifstream file(argv[1]);
  auto scene = carom::read_scene(std::string(std::istreambuf_iterator<char>(file), {}));
  if (!scene) {
    std::fputs((carom::to_string(scene.errors().front(), argv[1]) + '\n').c_str(), stderr);
    return 1;
  }
  auto created = carom::World::create(scene.value());
  if (!created) return 1;
  carom::World& world = created.value();
  if (!world.set_velocity(0, {std::atof(argv[2]), std::atof(argv[3])})) return 1;

  std::puts("time_s,x_px,y_px,speed_px_s");
  while (!world.at_rest() && world.in_play(0) && world.steps() < 1000) {
    world.step();
    const carom::Ball ball = world.ball(0);
    std::printf("%.2f,%.3f,%.3f,%.3f\n",
                static_cast<double>(world.steps()) / carom::steps_per_second, ball.position.x,
                ball.position.y, length(ball.velocity));
  }
}
