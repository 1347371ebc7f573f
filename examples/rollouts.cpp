// Plays random breaks on all cores and tells the best: rollouts [COUNT]
#include "carom/rollouts.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "games/billiards.hpp"
#include "games/play_out.hpp"

namespace {

// A number from 0 to 1 for each k, without a state that threads would share.
double random(std::uint64_t k) {
  k = (k ^ (k >> 30)) * 0xbf58476d1ce4e5b9;
  k = (k ^ (k >> 27)) * 0x94d049bb133111eb;
  return static_cast<double>((k ^ (k >> 31)) >> 11) / 0x1p53;
}

carom::Vec2 shot(std::uint64_t k) {
  return {1000 + 1000 * random(3 * k + 1), 300 * random(3 * k + 2) - 150};
}

}  // namespace

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::atoi(argv[1]) : 2000);
  const games::billiards::Game table;
  std::vector<games::Outcome> outcomes(count);
  carom::Rollouts rollouts(static_cast<int>(std::thread::hardware_concurrency()));
  // The results are the same for every number of threads.
  rollouts.run(table.world(), std::span(outcomes), [](carom::World& world, std::size_t k) {
    auto outcome = games::play_out(world, shot(k));
    return outcome ? outcome.value() : games::Outcome{};
  });

  const auto best =
      std::max_element(outcomes.begin(), outcomes.end(), [](const auto& a, const auto& b) {
        return (a.foul ? 0 : a.points) < (b.foul ? 0 : b.points);
      });
  if (best == outcomes.end()) return 1;
  const carom::Vec2 velocity = shot(static_cast<std::uint64_t>(best - outcomes.begin()));
  std::printf("best of %zu: %.3f, %.3f px/s for %lld points, %u balls, %llu steps\n", count,
              velocity.x, velocity.y, static_cast<long long>(best->points), best->balls_out,
              static_cast<unsigned long long>(best->steps));
}
