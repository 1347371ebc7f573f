#include "tool/simulate.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>

#include "carom/trace.hpp"
#include "carom/world.hpp"
#include "cli/options.hpp"
#include "files/output.hpp"
#include "games/settling.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

struct SimulateOptions {
  std::string scene;
  std::optional<std::uint64_t> steps;
  bool until_rest = false;
  std::optional<std::pair<double, double>> launch;
  std::uint64_t max_steps = 1'000'000;
  std::string broad_phase;
  int threads = 1;
  bool no_skip = false;
  std::optional<std::string> trace;
  bool hash = false;
  bool quiet = false;
};

// One line on a terminal, redrawn ten times a second, from one second after the start on.
class Progress {
 public:
  explicit Progress(bool wanted) : wanted_(wanted && ::isatty(STDERR_FILENO)) {}
  ~Progress() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::uint64_t step, std::uint64_t goal, bool goal_is_limit) {
    if (!wanted_ || Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(100);
    shown_ = true;
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    if (goal_is_limit) {
      std::fprintf(stderr, "\r\x1b[Kstep %llu, waiting for rest (limit %llu)", number(step),
                   number(goal));
    } else {
      const int filled =
          static_cast<int>(30.0 * static_cast<double>(step) / static_cast<double>(goal));
      const std::string bar = std::string(static_cast<std::size_t>(filled), '#');
      std::fprintf(stderr, "\r\x1b[K[%-30s] step %llu of %llu", bar.c_str(), number(step),
                   number(goal));
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool wanted_;
  bool shown_ = false;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
};

void summarise(const carom::World& world, std::FILE* out) {
  const auto steps = static_cast<unsigned long long>(world.steps());
  std::fprintf(out, "steps       %llu\n", steps);
  std::fprintf(out, "time        %llu.%02llu s\n", steps / carom::steps_per_second,
               steps % carom::steps_per_second);
  std::fprintf(out, "balls left  %zu\n", world.balls_left());
  std::fprintf(out, "hash        %s\n", carom::hash_text(world.state_hash()).c_str());
}

// At rest means slow, which a ball at the top of its flight is, too, and one that rolls towards a
// hole. Says so when what is slow goes on to move.
void tell_unsettled(const carom::World& world) {
  constexpr std::uint64_t most_work = 3'000'000;  // ball-steps: a second at most
  const games::Settling settling = games::look_ahead(world, most_work);
  if (settling.falling)
    std::fprintf(stderr,
                 "slow, but not settled: ball %u is in the air; --steps N goes on from there\n",
                 *settling.falling);
  else if (!settling.restless.empty() && settling.restless.front().lost)
    std::fprintf(stderr, "slow, but not settled: ball %u is lost within the next 30 s\n",
                 settling.restless.front().ball);
  else if (!settling.restless.empty())
    std::fprintf(stderr, "slow, but not settled: ball %u moves by %.0f px within the next 30 s\n",
                 settling.restless.front().ball, settling.restless.front().distance);
}

int simulate(const SimulateOptions& options) {
  auto scene = read_scene_file(options.scene);
  if (!scene) return report(scene.errors(), options.scene);
  auto created = carom::World::create(std::move(scene).value());
  if (!created) return report(created.errors(), options.scene);
  carom::World& world = created.value();
  world.set_threads(options.threads);
  world.set_skipping(!options.no_skip);
  if (options.broad_phase == "pairs") world.set_broad_phase(carom::BroadPhase::pairs);
  if (options.broad_phase == "quadtree") world.set_broad_phase(carom::BroadPhase::quadtree);
  if (options.launch) {
    if (!world.has_lead())
      return report({{.problem = "has nothing to throw",
                      .expected = "a projectile or a cue ball as the first ball"}},
                    options.scene);
    const auto& [x, y] = *options.launch;
    if (const auto launched = world.set_velocity(0, {x, y}); !launched) {
      report(launched.errors(), "--throw");
      return wrong_usage;
    }
  }

  std::optional<files::Output> trace;
  if (options.trace) {
    const std::array inputs{options.scene};
    trace.emplace(*options.trace, inputs);
    if (const carom::Status opened = trace->opened(); !opened)
      return report_output(opened.errors(), *options.trace);
  }
  std::string line;
  const auto trace_step = [&](std::span<const carom::Event> events) {
    if (!trace) return;
    line.clear();
    carom::append_trace_line(line, world, events);
    trace->write(line);
  };

  const bool until_rest = !options.steps;
  const std::uint64_t goal = options.steps.value_or(options.max_steps);
  trace_step({});
  {
    Progress progress(!options.quiet);
    // Many steps at a time, yet few enough that the progress is seen; a trace needs each.
    constexpr std::uint64_t at_a_time = 1000;
    while (world.steps() < goal && !(until_rest && world.at_rest()) &&
           !(trace && trace->failed())) {
      if (trace)
        trace_step(world.step());
      else
        world.run({.rest = until_rest}, std::min(at_a_time, goal - world.steps()));
      progress.show(world.steps(), goal, until_rest);
    }
  }

  if (trace)
    if (const carom::Status written = trace->commit(); !written)
      return report_output(written.errors(), *options.trace);

  // A trace on standard output stays pure; the rest then goes to standard error.
  std::FILE* out = trace && trace->is_standard_output() ? stderr : stdout;
  if (options.hash)
    std::fprintf(out, "%s\n", carom::hash_text(world.state_hash()).c_str());
  else if (!options.quiet)
    summarise(world, out);
  if (until_rest && world.at_rest() && !options.hash && !options.quiet) tell_unsettled(world);
  if (until_rest && !world.at_rest())
    std::fprintf(stderr, "not at rest after %llu steps, the limit: --max-steps N sets another\n",
                 static_cast<unsigned long long>(goal));
  return done;
}

}  // namespace

void add_simulate(CLI::App& carom, int& status) {
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = carom.add_subcommand("simulate", "Run a scene and tell how it ended.");
  command->add_option("scene", options->scene, "Scene or level file (JSON); - is standard input")
      ->required()
      ->check(cli::file_name())
      ->option_text("SCENE");
  CLI::Option* steps =
      cli::add_whole(*command, "--steps", options->steps, "Run exactly N steps of 0.01 s")
          ->option_text("N");
  CLI::Option* until_rest =
      command
          ->add_flag("--until-rest", options->until_rest,
                     "Run until every ball is slower than 30 px/s and none is being pulled by a "
                     "hole (the default)")
          ->option_text(" ")
          ->excludes(steps);
  cli::add_whole(*command, "--max-steps", options->max_steps,
                 "With --until-rest: stop after N steps at the latest, and say so")
      ->option_text("N [1000000]")
      ->excludes(steps);
  cli::add_vector(*command, "--throw", options->launch,
                  "First give the projectile, or cue ball, this velocity in px/s")
      ->option_text("VX,VY");
  command
      ->add_option("--broad-phase", options->broad_phase,
                   "How colliding balls are found: by testing all pairs, or by the quadtree. It "
                   "changes the speed only; without it what is quicker is taken")
      ->check(CLI::IsMember({"pairs", "quadtree"}))
      ->option_text("pairs|quadtree");
  cli::add_whole(*command, "--threads", options->threads,
                 "How many threads a step may use, from 20000 balls on (default 1). It changes the "
                 "speed only",
                 1, carom::max_threads)
      ->option_text("N");
  command->add_flag("--no-skip", options->no_skip,
                    "Test every step for what may meet, even where it is known that nothing can. "
                    "It changes the speed only");
  command
      ->add_option("--trace", options->trace,
                   "Write every step's balls and events as JSON Lines; - is standard output")
      ->check(cli::file_name())
      ->option_text("FILE");
  command->add_flag("--hash", options->hash, "Print only the final state hash");
  command->add_flag("--quiet", options->quiet, "Print no summary and no progress");
  steps->excludes(until_rest);
  command->footer(
      "Prints the number of steps, the simulated time, the balls left and the state hash.\n"
      "Exit status: 0 done; 1 the scene is wrong, or a file cannot be read or written; 2 wrong "
      "usage.\n\n"
      "Examples:\n"
      "  carom simulate scenes/break.json\n"
      "  carom simulate scenes/hole.json --steps 200 --trace hole.jsonl\n"
      "  carom simulate levels/01-first-steps.json --throw 775,-70\n"
      "  carom simulate scenes/break.json --until-rest --trace - --quiet | tail -n 1\n"
      "  carom simulate - --hash < scenes/three-balls.json");
  command->callback([options, &status] { status = simulate(*options); });
}

}  // namespace tool
