#include <cstddef>
#include <cstdint>
#include <string>

#include "carom/world.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "require.hpp"
#include "small_world.hpp"

namespace {

using carom::World;
namespace ab = games::angry_balls;
namespace bi = games::billiards;

// Whatever is loaded can be played, and saved again as the same bytes.
template <class State, class Play>
void load(const std::string& bytes, Play play) {
  auto loaded = State::load_state(bytes);
  if (!loaded) {
    fuzz::require(!loaded.errors().empty(), "a refusal has a reason");
    return;
  }
  State state = std::move(loaded).value();
  const std::string saved = state.save_state();
  auto again = State::load_state(saved);
  fuzz::require(again.ok(), "what was loaded can be loaded again");
  fuzz::require(again.value().save_state() == saved, "and is the same then");
  for (int step = 0; step < 20; ++step) play(state);
}

carom::Scene level() {
  carom::Scene scene;
  scene.gravity = 500;
  scene.balls = {{.role = carom::Role::projectile, .position = {50, 50}},
                 {.role = carom::Role::enemy, .position = {80, 50}, .solidity = 100}};
  return scene;
}

std::string start(unsigned which) {
  if (which == 1) {
    bi::Game game;
    (void)game.apply(bi::Shoot{{100, 3}}).ok();
    return game.save_state();
  }
  if (which == 2) return ab::Game::create(level()).value().save_state();
  World world = World::create(level()).value();
  world.run({}, 9);
  return world.save_state();
}

}  // namespace

// The input changes bytes of a state: from the end, where the numbers are. Checksums do not count.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  small_world::Bytes input(data, size);
  const unsigned which = input.byte() % 4;
  if (which == 3) {  // bytes as they are
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    load<World>(bytes, [](World& world) { world.step(); });
    return 0;
  }
  std::string bytes = start(which);
  while (!input.over()) {
    const auto back = static_cast<std::size_t>(input.word());
    const char value = static_cast<char>(input.byte());
    bytes[bytes.size() - 1 - back % bytes.size()] = value;
  }
  if (which == 0) load<World>(bytes, [](World& world) { world.step(); });
  if (which == 1) load<bi::Game>(bytes, [](bi::Game& game) { game.step(); });
  if (which == 2) load<ab::Game>(bytes, [](ab::Game& game) { game.step(); });
  return 0;
}
