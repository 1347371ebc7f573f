// Draws a shot space as a PNG: each pixel is a launch in a level, its direction to the right, its
// speed upwards; the brighter, the more points: heat_map LEVEL PICTURE
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "carom/rollouts.hpp"
#include "games/angry_balls.hpp"
#include "games/play_out.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream file(argv[1]);
  auto level =
      games::angry_balls::read_level(std::string(std::istreambuf_iterator<char>(file), {}));
  if (!level) {
    std::fputs((carom::to_string(level.errors().front(), argv[1]) + '\n').c_str(), stderr);
    return 1;
  }
  const auto world = carom::World::create(level.value());
  if (!world) return 1;

  constexpr int width = 96;
  constexpr int height = 48;
  std::vector<games::Outcome> outcomes(width * height);
  carom::Rollouts(2).run(
      world.value(), std::span(outcomes), [](carom::World& start, std::size_t k) {
        const double angle = (static_cast<double>(k % width) / width - 0.5) * std::numbers::pi;
        const double speed = 2000.0 * static_cast<double>(height - k / width) / height;
        auto outcome = games::play_out(start, {speed * std::cos(angle), speed * std::sin(angle)});
        return outcome ? outcome.value() : games::Outcome{};
      });

  std::vector<std::uint8_t> pixels;
  int winners = 0;
  for (const games::Outcome& outcome : outcomes) {
    const auto heat = static_cast<int>(std::min<std::int64_t>(outcome.points / 2, 255));
    winners += outcome.points > 0 ? 1 : 0;
    for (const int part : {heat, heat / 2, 64 - heat / 4})
      pixels.push_back(static_cast<std::uint8_t>(part));
  }
  if (stbi_write_png(argv[2], width, height, 3, pixels.data(), 3 * width) == 0) return 1;
  std::printf("%d of %d launches make points\n", winners, width * height);
}
