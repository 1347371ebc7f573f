// Keeps a game in the middle of a shot as bytes, in a file, and goes on from there twice:
// snapshot FILE
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "carom/trace.hpp"
#include "games/billiards.hpp"

namespace billiards = games::billiards;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  billiards::Game game;
  if (!game.apply(billiards::Shoot::at({1800, 10}))) return 1;
  for (int step = 0; step < 150; ++step) game.step();
  std::ofstream(argv[1], std::ios::binary) << game.save_state();

  std::ifstream file(argv[1], std::ios::binary);
  auto loaded = billiards::Game::load_state(std::string(std::istreambuf_iterator<char>(file), {}));
  if (!loaded) {
    std::puts(carom::to_string(loaded.errors().front()).c_str());
    return 1;
  }
  for (billiards::Game* one : {&game, &loaded.value()}) {
    while (one->phase() == billiards::Phase::roll) one->step();
    std::printf("player %d is on with %lld points after %llu steps, hash %s\n", one->player(),
                static_cast<long long>(one->score(one->player())),
                static_cast<unsigned long long>(one->world().steps()),
                carom::hash_text(one->world().state_hash()).c_str());
  }
}
