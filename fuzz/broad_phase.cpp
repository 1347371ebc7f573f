#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "carom/scene_file.hpp"
#include "carom/world.hpp"
#include "require.hpp"
#include "small_world.hpp"

// Whatever finds the pairs, the bits are the same (docs/physics.md#finding-the-pairs).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  small_world::Bytes bytes(data, size);
  const unsigned steps = 1 + bytes.byte() % 4;
  const carom::Scene made = small_world::scene(bytes);
  auto world = carom::World::create(made);
  fuzz::require(world.ok(), "the world is sound");
  carom::World pairs = std::move(world).value();
  carom::World tree = pairs;
  carom::World automatic = pairs;
  pairs.set_broad_phase(carom::BroadPhase::pairs);
  tree.set_broad_phase(carom::BroadPhase::quadtree);
  for (unsigned step = 0; step < steps; ++step) {
    const auto expected = pairs.step();
    for (carom::World* other : {&tree, &automatic}) {
      const bool same =
          std::ranges::equal(other->step(), expected) && other->state_hash() == pairs.state_hash();
      if (!same) std::fputs(carom::write_scene(made).c_str(), stderr);
      fuzz::require(same, other == &tree ? "the quadtree gives the same bits"
                                         : "automatic gives the same bits");
    }
  }
  return 0;
}
