// One workload on whatever commit of the engine this is compiled with; a line of JSON comes out.
//
//   shots LEVELS WORKLOAD HOW SECONDS [PASSES]
//
// HOW: run (quickest way to the end), never-skip (the same, every step tested), step (one by one),
// copy (assignment of the start alone). Passes are made until SECONDS are over, or as many as said;
// each plays all the workload's starts, and the fastest counts.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "../scenes.hpp"
#include "carom/fnv1a.hpp"
#include "carom/world.hpp"

namespace {

// Of this thread: what else the machine does disturbs it less than the time on the wall.
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

// Templates, so that what an older engine does not have is not looked for there.
template <class World>
constexpr bool can_run = requires(World world) {
  world.set_skipping(true);
};

template <class World>
void never_skip(World& world) {
  if constexpr (can_run<World>) world.set_skipping(false);
}

template <class World>
void play(World& world, bool singly, std::uint64_t limit) {
  if constexpr (can_run<World>) {
    if (!singly) {
      world.run({.rest = true}, limit);
      return;
    }
  }
  for (std::uint64_t n = 0; n < limit && !world.at_rest(); ++n) world.step();
}

int measure(const bench::Workload& load, std::string_view how, double seconds, int passes) {
  std::vector<carom::World> starts;
  for (const carom::Scene& scene : load.starts()) {
    auto world = carom::World::create(scene);
    if (!world) return 1;
    starts.push_back(std::move(world).value());
    if (how == "never-skip") never_skip(starts.back());
  }
  const std::uint64_t limit = load.most_steps == 0 ? 20'000 : load.most_steps;
  // One world for all, as in a search: what it keeps for the next run is paid for once.
  carom::World world = starts.front();
  double fastest = std::numeric_limits<double>::infinity();
  double slowest = 0;
  const bool copy = how == "copy";
  const int copies = copy ? 1000 : 1;
  int made = 0;
  for (const double begin = now(); passes > 0 ? made < passes : now() - begin < seconds; ++made) {
    const double pass = now();
    for (int k = 0; k < copies; ++k)
      for (const carom::World& start : starts) {
        world = start;
        if (!copy) play(world, how == "step", limit);
      }
    const double time = now() - pass;
    fastest = std::min(fastest, time);
    slowest = std::max(slowest, time);
  }
  carom::Fnv1a hash;
  std::uint64_t steps = 0;
  for (const carom::World& start : starts) {
    world = start;
    if (!copy && passes == 0) play(world, how == "step", limit);
    hash.add(world.state_hash());
    steps += world.steps();
  }
  const auto shots = static_cast<double>(starts.size()) * copies;
  std::printf(
      "{\"shots\": %.0f, \"steps\": %llu, \"passes\": %d, \"seconds\": %.9g, "
      "\"slowest\": %.9g, \"hash\": \"%016llx\"}\n",
      shots, static_cast<unsigned long long>(steps), made, fastest, slowest,
      static_cast<unsigned long long>(hash.hash()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fputs("usage: shots LEVELS WORKLOAD HOW SECONDS [PASSES]\n", stderr);
    return 2;
  }
  for (const bench::Workload& load : bench::workloads(argv[1]))
    if (load.name() == argv[2] || load.scene == argv[2])
      return measure(load, argv[3], std::atof(argv[4]), argc > 5 ? std::atoi(argv[5]) : 0);
  std::fprintf(stderr, "there is no workload %s\n", argv[2]);
  return 2;
}
