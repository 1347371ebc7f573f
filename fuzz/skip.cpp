#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "carom/scene_file.hpp"
#include "carom/world.hpp"
#include "require.hpp"
#include "small_world.hpp"

// Steps that are passed over give the same bits as steps that are tested, one by one and at once.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  small_world::Bytes bytes(data, size);
  const unsigned steps = 1 + bytes.byte();
  const carom::Scene made = small_world::scene(bytes);
  auto world = carom::World::create(made);
  fuzz::require(world.ok(), "the world is sound");
  carom::World tests = std::move(world).value();
  carom::World skips = tests;
  carom::World runs = tests;
  tests.set_skipping(false);
  for (unsigned step = 0; step < steps; ++step) {
    const auto expected = tests.step();
    const bool same =
        std::ranges::equal(skips.step(), expected) && skips.state_hash() == tests.state_hash();
    if (!same) std::fputs(carom::write_scene(made).c_str(), stderr);
    fuzz::require(same, "a step that skips gives the same bits");
  }
  runs.run({}, steps);
  const bool same = runs.state_hash() == tests.state_hash();
  if (!same) std::fputs(carom::write_scene(made).c_str(), stderr);
  fuzz::require(same, "a run gives the same bits");
  return 0;
}
