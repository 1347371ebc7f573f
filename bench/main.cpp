#include <CLI/CLI.hpp>
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "carom/fnv1a.hpp"
#include "golden.hpp"
#include "motion.hpp"
#include "results.hpp"
#include "scenes.hpp"
#include "simulator.hpp"

namespace bench {
namespace {

struct Contestant {
  std::string name;
  MakeSimulator* make;
  int most_balls = std::numeric_limits<int>::max();  ///< with more a run would take too long
  bool several_threads = false;                      ///< timed by the clock on the wall
  int least_balls = 0;
};

/// Everybody measured, one after the other in each workload. A way to run our engine (a number of
/// threads, a forced broad phase) is a line here with a name that begins with "carom-", and a
/// function in carom.cpp; all of them must reach the same hash.
const std::vector<Contestant>& contestants() {
  static const std::vector<Contestant> all = {
      {"carom", make_carom},  // as every user gets it
      {"carom-never-skip", make_carom_never_skip, 100},
      // report.py calls the faster of these two Chipmunk.
      {"carom-pairs", make_carom_pairs, 1000},
      {"carom-quadtree", make_carom_quadtree, 100},  // above it is what everybody gets
      {"carom-1-thread", make_carom_1_thread, std::numeric_limits<int>::max(), true, 100'000},
      {"carom-2-threads", make_carom_2_threads, std::numeric_limits<int>::max(), true, 100'000},
      {"carom-4-threads", make_carom_4_threads, std::numeric_limits<int>::max(), true, 100'000},
      {"chipmunk-tree", make_chipmunk_tree, 100'000},
      {"chipmunk-hash", make_chipmunk_hash},
      {"box2d", make_box2d, 100'000},
      {"streaming", make_streaming},  // no engine: the limit
  };
  return all;
}

bool takes_part(const Contestant& contestant, const Workload& load) {
  if (load.balls > contestant.most_balls || load.balls < contestant.least_balls) return false;
  const bool ours = contestant.name.starts_with("carom");
  if (load.ours_alone) return ours;
  return contestant.name != "streaming" || load.scene != "TABLE";
}

/// Of the processor, by all threads together: what else the machine does disturbs it less than the
/// time on the wall, which alone shows what several threads are good for.
double seconds(const Contestant& contestant) {
  timespec now{};
  clock_gettime(contestant.several_threads ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Longer than any shot: who needs more never comes to rest.
constexpr int most_steps_of_a_shot = 20'000;

void measure(benchmark::State& state, const Workload& load, const Contestant& contestant,
             Golden& golden) {
  const std::vector<carom::Scene> starts = load.starts();
  std::vector<std::unique_ptr<Simulator>> runs;
  const int limit = load.most_steps == 0 ? most_steps_of_a_shot : static_cast<int>(load.most_steps);
  double steps = 0;
  // Of the runs in a repetition the fastest counts: it was disturbed least by what else goes on.
  double fastest = std::numeric_limits<double>::infinity();
  for ([[maybe_unused]] const auto iteration : state) {
    runs.clear();
    for (const carom::Scene& start : starts) {
      runs.push_back(contestant.make(start, load));
      runs.back()->advance(load.warm_up);
    }
    steps = 0;
    int longest = 0;
    const double begin = seconds(contestant);
    for (const auto& run : runs) {
      if (load.is_shot()) {
        const int taken = run->run_until_rest(limit);
        steps += taken;
        longest = std::max(longest, taken);
      } else {
        run->advance(load.steps);
        steps += load.steps;
      }
    }
    const double time = seconds(contestant) - begin;
    state.SetIterationTime(time);
    fastest = std::min(fastest, time);

    if (load.most_steps == 0 && longest == limit) {
      state.SkipWithError("a shot never came to rest");
      return;
    }
    if (runs.front()->hash()) {
      carom::Fnv1a all;
      for (const auto& run : runs) all.add(*run->hash());
      if (const auto objection = golden.objection(load.name(), all.hash())) {
        state.SkipWithError(objection->c_str());
        return;
      }
    }
  }
  const Motion before = motion(starts.back().balls, starts.back());
  const Motion after = motion(runs.back()->balls(), starts.back());
  if (after.outside > 0) {
    state.SkipWithError((std::to_string(after.outside) + " balls are outside").c_str());
    return;
  }
  state.counters["seconds"] = fastest;
  state.counters["ball_steps"] = steps * load.balls;
  if (load.is_shot()) {
    state.counters["shots"] = static_cast<double>(runs.size());
  } else {
    state.counters["all_steps"] = load.warm_up + load.steps;
    state.counters["rms_speed_before"] = before.rms_speed;
    state.counters["rms_speed"] = after.rms_speed;
    state.counters["mean_height"] = after.mean_height;
    state.counters["deepest_overlap"] = after.deepest_overlap;
  }
}

struct Options {
  bool full = false;
  bool quick = false;
  bool update_golden = false;
  std::vector<std::string> scenes;
  std::vector<std::string> by;
  std::filesystem::path golden = BENCH_GOLDEN;
  std::filesystem::path json;
};

/// Nothing chosen is everything.
bool wanted(const std::vector<std::string>& choice, const std::string& name) {
  return choice.empty() || std::ranges::find(choice, name) != choice.end();
}

void add_benchmarks(const Options& options, Golden& golden) {
  std::set<std::string> seen;
  for (const Workload& load : workloads(BENCH_LEVELS)) {
    const bool first = seen.insert(load.scene).second;
    if (options.quick ? !first : load.big && !options.full) continue;
    if (!wanted(options.scenes, load.scene) && !wanted(options.scenes, load.name())) continue;
    for (const Contestant& contestant : contestants()) {
      if (!takes_part(contestant, load) || !wanted(options.by, contestant.name)) continue;
      const auto run = [load, &contestant, &golden](benchmark::State& state) {
        measure(state, load, contestant, golden);
      };
      const std::string name = load.name() + "/" + contestant.name;
      auto* const registered = benchmark::RegisterBenchmark(name.c_str(), run)->UseManualTime();
      // Of a repetition at least a tenth of a second is measured; of the slowest, one run.
      if (options.quick)
        registered->Iterations(1)->Repetitions(1);
      else
        registered->MinTime(0.1)->Repetitions(load.balls < 10'000    ? 5
                                              : load.balls < 100'000 ? 3
                                                                     : 2);
    }
  }
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app{"Measures our engine beside Chipmunk, Box2D and a plain pass over memory."};
  app.add_flag("--full", options.full, "all sizes, up to 1 000 000 balls");
  app.add_flag("--quick", options.quick,
               "each scene's smallest size, once: a test, no measurement");
  app.add_option("--scene", options.scenes, "only these: GAS, GAS/1000, …");
  app.add_option("--by", options.by, "only these: carom, chipmunk-tree, …");
  app.add_option("--json", options.json, "where to write the figures");
  app.add_option("--golden", options.golden, "file of the hashes that must come out");
  app.add_flag("--update-golden", options.update_golden, "add the hashes that it does not have");
  CLI11_PARSE(app, argc, argv);

  Golden golden(options.golden, options.update_golden);
  add_benchmarks(options, golden);
  int no_arguments = 1;
  benchmark::Initialize(&no_arguments, argv);
  Results results;
  if (benchmark::RunSpecifiedBenchmarks(&results) == 0) {
    std::fputs("nothing is called that\n", stderr);
    return 2;
  }
  if (!golden.save()) {
    std::fprintf(stderr, "cannot write %s\n", options.golden.c_str());
    return 1;
  }
  if (!options.json.empty() && !results.write(options.json)) {
    std::fprintf(stderr, "cannot write %s\n", options.json.c_str());
    return 1;
  }
  return results.failures() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  try {
    return bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
