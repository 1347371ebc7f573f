#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "carom/event.hpp"
#include "carom/world.hpp"
#include "random_worlds.hpp"
#include "worlds.hpp"

namespace {

using carom::BroadPhase;
using carom::Event;
using carom::World;

/// Steps the same world with each broad phase; what differs first, in words, or nothing.
std::string difference(const carom::Scene& scene, int steps) {
  World pairs = worlds::make(scene);
  World tree = pairs;
  World automatic = pairs;
  pairs.set_broad_phase(BroadPhase::pairs);
  tree.set_broad_phase(BroadPhase::quadtree);
  for (int step = 1; step <= steps; ++step) {
    const auto expected = pairs.step();
    for (World* world : {&tree, &automatic}) {
      const std::string name = world == &tree ? "quadtree" : "automatic";
      const auto events = world->step();
      if (!std::ranges::equal(events, expected))
        return name + ": other events in step " + std::to_string(step);
      if (world->state_hash() != pairs.state_hash())
        return name + ": another state after step " + std::to_string(step);
    }
  }
  return {};
}

// Spec §6: whatever finds the pairs, the bits are the same. Many small worlds, and some larger.
class BroadPhases : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BroadPhases, GiveTheSameBits) {
  for (std::uint64_t k = 0; k < 12'500; ++k) {
    const std::uint64_t seed = GetParam() * 12'500 + k;
    const std::size_t most = k % 100 == 0 ? 400 : k % 10 == 0 ? 60 : 20;
    ASSERT_EQ(difference(random_worlds::scene(seed, most), 3), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(HundredThousand, BroadPhases, testing::Range<std::uint64_t>(0, 8));

}  // namespace
