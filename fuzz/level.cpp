#include <cstddef>
#include <cstdint>
#include <utility>

#include "games/angry_balls.hpp"
#include "require.hpp"

namespace angry_balls = games::angry_balls;

// A level that is read can be played: thrown, stepped, ended, started again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto level = angry_balls::read_level({reinterpret_cast<const char*>(data), size});
  if (!level) return 0;
  auto created = angry_balls::Game::create(std::move(level).value());
  fuzz::require(created.ok(), "a level that is read can be played");
  angry_balls::Game& game = created.value();
  if (game.world().size() > 100) return 0;
  const auto start = game.world().state_hash();
  fuzz::require(game.apply(angry_balls::Throw{{100, 50}}).ok(), "the projectile can be thrown");
  for (int step = 0; step < 50; ++step) {
    game.step();
    if (game.phase() == angry_balls::Phase::offer)
      fuzz::require(game.apply(angry_balls::Next{}).ok(), "the next throw can be taken");
    if (game.phase() == angry_balls::Phase::aim)
      fuzz::require(game.apply(angry_balls::Throw{{-10, 500}}).ok(), "and thrown");
  }
  fuzz::require(game.apply(angry_balls::Restart{}).ok(), "a level can be started again");
  fuzz::require(game.world().state_hash() == start, "and is as it was");
  return 0;
}
