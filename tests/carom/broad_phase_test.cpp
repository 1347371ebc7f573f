#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>
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
#ifdef NDEBUG
constexpr std::uint64_t worlds_each = 12'500;
#else
constexpr std::uint64_t worlds_each = 1'250;  // the others take ten times as long
#endif

class BroadPhases : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BroadPhases, GiveTheSameBits) {
  for (std::uint64_t k = 0; k < worlds_each; ++k) {
    const std::uint64_t seed = GetParam() * worlds_each + k;
    const std::size_t most = k % 100 == 0 ? 400 : k % 10 == 0 ? 60 : 20;
    ASSERT_EQ(difference(random_worlds::scene(seed, most), 3), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(RandomWorlds, BroadPhases, testing::Range<std::uint64_t>(0, 8));

/// Balls that overlap several others each, sinking into each other.
carom::Scene heap(std::uint64_t seed) {
  random_worlds::Numbers n(seed);
  carom::Scene scene;
  scene.gravity = n.one_in(4) ? 0 : n.uniform(100, 2000);
  scene.edges.top = carom::Edge::open;
  const std::size_t count = 20 + n.below(n.one_in(10) ? 400 : 100);
  const bool equal = n.one_in(2);
  const double side = std::sqrt(static_cast<double>(count)) * n.uniform(7, 16);
  scene.width = side + 60;
  scene.height = side + 60;
  while (scene.balls.size() < count)
    scene.balls.push_back(
        {.position = {n.uniform(30, 30 + side), n.uniform(30, 30 + side)},
         .velocity = {n.uniform(-200, 200), n.uniform(-200, 200)},
         .radius = equal ? 10 : n.uniform(3, 25),
         .solidity = n.one_in(3) ? n.uniform(0, 4000) : carom::infinite_solidity});
  return scene;
}

TEST(BroadPhase, GivesTheSameBitsInHeaps) {
  for (std::uint64_t seed = 0; seed < worlds_each / 10; ++seed)
    ASSERT_EQ(difference(heap(seed), 4), "") << "seed " << seed;
}

// What a world's steps keep from call to call belongs to the state it had: an assignment must not
// leave it to another state.
TEST(BroadPhase, AnAssignedWorldGoesOnAsTheOriginal) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    carom::Scene first = random_worlds::scene(seed, 30);
    carom::Scene second = random_worlds::scene(seed + 1'000'000, 30);
    const std::size_t count = std::min(first.balls.size(), second.balls.size());
    first.balls.resize(count);
    second.balls.resize(count);
    World original = worlds::make(second);
    World assigned = worlds::make(first);
    assigned.step();
    assigned = original;
    for (int step = 1; step <= 3; ++step) {
      ASSERT_TRUE(std::ranges::equal(assigned.step(), original.step())) << "seed " << seed;
      ASSERT_EQ(assigned.state_hash(), original.state_hash()) << "seed " << seed;
    }
  }
}

// Enough balls that threads are used, crowded, with all that a world can have, of about one size
// and of many.
carom::Scene many_balls(double smallest, double largest) {
  random_worlds::Numbers n(7);
  carom::Scene scene;
  scene.width = 5000;
  scene.height = 5000;
  scene.gravity = 300;
  scene.edges.left = carom::Edge::open;
  scene.holes = {{{1000, 1000}, 200}, {{3000, 2500}, 300}};
  scene.obstacles = {{2000, 2500, 60}, {4000, 1200, 100}};
  const carom::Scene empty = scene;
  while (scene.balls.size() < 24'000) {
    carom::Ball ball;
    ball.position = {n.uniform(100, 4900), n.uniform(100, 4900)};
    ball.velocity = {n.uniform(-800, 800), n.uniform(-800, 800)};
    ball.radius = n.one_in(50) ? n.uniform(smallest, largest) : n.uniform(smallest, 2 * smallest);
    if (n.one_in(4)) ball.solidity = n.uniform(0, 20'000);
    carom::Scene alone = empty;
    alone.balls = {ball};
    if (carom::check(alone).empty()) scene.balls.push_back(ball);
  }
  return scene;
}

TEST(Threads, GiveTheSameBits) {
  for (const double largest : {18.0, 150.0}) {
    const carom::Scene scene = many_balls(9, largest);
    World one = worlds::make(scene);
    std::vector<World> several;
    for (const int threads : {2, 3, 4, 64}) {
      several.push_back(one);
      several.back().set_threads(threads);
    }
    for (int step = 1; step <= 4; ++step) {
      const auto expected = one.step();
      ASSERT_GT(expected.size(), 1000U);
      for (World& world : several) {
        ASSERT_TRUE(std::ranges::equal(world.step(), expected)) << step;
        ASSERT_EQ(world.state_hash(), one.state_hash()) << step;
      }
    }
  }
}

// Threads belong to one world each, whatever becomes of it.
TEST(Threads, AreNotShared) {
  World world = worlds::make(many_balls(9, 18));
  world.set_threads(2);
  world.step();
  World copy = world;
  World moved = std::move(world);
  moved.step();
  copy.step();
  EXPECT_EQ(copy.state_hash(), moved.state_hash());
  copy = moved;
  moved.set_threads(1);
  moved.step();
  copy.step();
  EXPECT_EQ(copy.state_hash(), moved.state_hash());
}

}  // namespace
