#include "carom/rollouts.hpp"

#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "carom/scene.hpp"
#include "carom/world.hpp"

namespace {

carom::World table() {
  carom::Scene scene;
  scene.friction = 0.98;
  scene.holes = {{.position = {10, 10}}, {.position = {790, 390}}};
  scene.balls = {{.role = carom::Role::cue, .position = {200, 200}, .radius = 8}};
  for (int n = 0; n < 8; ++n)
    scene.balls.push_back({.position = {400.0 + 20.5 * n, 200.0 + 3 * n}});
  return carom::World::create(scene).value();
}

struct Played {
  std::size_t k = 0;
  std::uint64_t steps = 0;
  std::uint64_t hash = 0;
  friend bool operator==(const Played&, const Played&) = default;
};

Played play(carom::World& world, std::size_t k) {
  const auto n = static_cast<double>(k);
  EXPECT_TRUE(world.set_velocity(0, {300 + 7 * n, 5 * n - 400}));
  world.run({.rest = true}, 5000);
  return {.k = k, .steps = world.steps(), .hash = world.state_hash()};
}

std::vector<Played> alone(std::size_t count) {
  const carom::World start = table();
  std::vector<Played> results(count);
  for (std::size_t k = 0; k < count; ++k) {
    carom::World world = start;
    results[k] = play(world, k);
  }
  return results;
}

TEST(Rollouts, GiveTheSameResultsInOrderForEveryNumberOfThreads) {
  const std::vector<Played> expected = alone(150);
  for (const int threads : {-1, 1, 2, 3, 4}) {
    carom::Rollouts rollouts(threads);
    std::vector<Played> results(expected.size());
    rollouts.run(table(), std::span<Played>(results), play);
    EXPECT_EQ(results, expected) << threads << " threads";
  }
}

TEST(Rollouts, OneObjectServesManyStartsAndCounts) {
  carom::Rollouts rollouts(3);
  for (const std::size_t count : {0U, 1U, 2U, 17U}) {
    std::vector<Played> results(count);
    rollouts.run(table(), std::span<Played>(results), play);
    EXPECT_EQ(results, alone(count)) << count;
  }
  // A start of another size, and one that is no longer at its beginning.
  carom::Scene scene;
  scene.balls = {{.position = {100, 100}}};
  carom::World small = carom::World::create(scene).value();
  small.step();
  std::vector<std::uint64_t> hashes(5);
  rollouts.run(small, std::span<std::uint64_t>(hashes),
               [](carom::World& world, std::size_t) { return world.state_hash() + world.steps(); });
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, small.state_hash() + 1);
}

TEST(Rollouts, SettingsOfTheStartAreKept) {
  carom::World start = table();
  start.set_broad_phase(carom::BroadPhase::pairs);
  start.set_skipping(false);
  carom::Rollouts rollouts(2);
  std::vector<Played> results(20);
  rollouts.run(start, std::span<Played>(results), play);
  EXPECT_EQ(results, alone(20));
}

}  // namespace
