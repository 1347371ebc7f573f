#include "tool/shots.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "carom/fnv1a.hpp"
#include "carom/rollouts.hpp"
#include "carom/trace.hpp"
#include "carom/world.hpp"
#include "cli/options.hpp"
#include "files/output.hpp"
#include "games/play_out.hpp"
#include "games/random.hpp"
#include "json/number_text.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

struct ShotsOptions {
  std::string scene;
  std::uint64_t count = 1000;
  std::uint64_t seed = 1;
  int threads = 1;
  bool no_skip = false;
  std::optional<std::string> csv;
  bool json = false;
};

constexpr std::uint64_t most_launches = 1'000'000'000;
constexpr double slowest = 200;  // px/s
constexpr double fastest = 2000;

/// Any direction, without functions whose last bits differ between libraries.
carom::Vec2 random_velocity(games::Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double square = x * x + y * y;
    if (square < 0.01 || square > 1) continue;
    return carom::Vec2{x, y} * (random.uniform(slowest, fastest) / std::sqrt(square));
  }
}

/// The count of each value.
class Distribution {
 public:
  void add(std::uint64_t value) {
    ++times_[value];
    ++count_;
    sum_ += static_cast<double>(value);
  }
  /// The value that a part of them, 0 to 1, does not exceed.
  std::uint64_t quantile(double part) const {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(count_)));
    std::uint64_t passed = 0;
    for (const auto& [value, times] : times_)
      if ((passed += times) >= wanted) return value;
    return 0;
  }
  double mean() const { return sum_ / static_cast<double>(count_); }
  const std::map<std::uint64_t, std::uint64_t>& times() const { return times_; }

 private:
  std::map<std::uint64_t, std::uint64_t> times_;
  std::uint64_t count_ = 0;
  double sum_ = 0;
};

struct Summary {
  Distribution points, balls_out, steps;
  std::uint64_t fouls = 0;
  double seconds = 0;  ///< of playing alone
  carom::Fnv1a hash;
};

/// Launches whose ends are kept side by side, to be hashed when the clock stands.
class Block {
 public:
  Block(std::size_t launches, std::size_t balls)
      : balls_(balls), ends_(launches), numbers_(launches * balls * 4), ids_(launches * balls) {}

  std::size_t size() const { return ends_.size(); }

  struct End {
    games::Outcome outcome;
    std::size_t balls_left = 0;
  };

  /// Plays on all threads; returns the seconds that it took.
  double play(carom::Rollouts& rollouts, const carom::World& start,
              const std::vector<carom::Vec2>& velocities) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    rollouts.run(start, std::span(ends_).first(velocities.size()),
                 [&](carom::World& world, std::size_t k) {
                   // The start has a lead, and no velocity is too fast.
                   const games::Outcome outcome = games::play_out(world, velocities[k]).value();
                   return keep(world, outcome, k);
                 });
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  const games::Outcome& outcome(std::size_t k) const { return ends_[k].outcome; }

  /// Of the outcome, and of every ball left, its place and its velocity.
  std::uint64_t hash(std::size_t k) const {
    const End& end = ends_[k];
    carom::Fnv1a hash;
    hash.add(static_cast<std::uint64_t>(end.outcome.points));
    hash.add(end.outcome.balls_out);
    hash.add(static_cast<std::uint8_t>(end.outcome.foul));
    hash.add(end.outcome.steps);
    for (std::size_t i = 0; i < end.balls_left; ++i) hash.add(ids_[k * balls_ + i]);
    for (std::size_t i = 0; i < end.balls_left * 4; ++i) hash.add(numbers_[k * balls_ * 4 + i]);
    return hash.hash();
  }

 private:
  End keep(const carom::World& world, const games::Outcome& outcome, std::size_t k) {
    const carom::BallsView balls = world.balls();
    const std::ptrdiff_t first = world.in_play(0) ? 0 : 1;
    double* to = &numbers_[k * balls_ * 4];
    for (const std::span<const double> numbers : {balls.x, balls.y, balls.vx, balls.vy})
      to = std::copy(numbers.begin() + first, numbers.end(), to);
    std::copy(balls.id.begin() + first, balls.id.end(), &ids_[k * balls_]);
    return {.outcome = outcome, .balls_left = world.balls_left()};
  }

  std::size_t balls_;
  std::vector<End> ends_;
  std::vector<double> numbers_;
  std::vector<std::uint32_t> ids_;
};

/// As many launches as fit into some megabytes.
std::size_t block_size(std::uint64_t count, std::size_t balls) {
  constexpr std::size_t most_balls = std::size_t{1} << 19;
  const std::uint64_t most = std::clamp<std::size_t>(most_balls / balls, 1, 4096);
  return static_cast<std::size_t>(std::min(count, most));
}

std::string csv_line(std::uint64_t launch, carom::Vec2 velocity, const games::Outcome& outcome,
                     std::uint64_t hash) {
  std::string line = std::to_string(launch) + ',';
  carom::append_number(line, velocity.x);
  line += ',';
  carom::append_number(line, velocity.y);
  line += ',' + std::to_string(outcome.points) + ',' + std::to_string(outcome.balls_out) + ',' +
          (outcome.foul ? '1' : '0') + ',' + std::to_string(outcome.steps) + ',' +
          carom::hash_text(hash) + '\n';
  return line;
}

Summary play_all(const ShotsOptions& options, const carom::World& start, files::Output* csv) {
  Summary summary;
  carom::Rollouts rollouts(options.threads);
  games::Random random(options.seed);
  Block block(block_size(options.count, start.size()), start.size());
  std::vector<carom::Vec2> velocities;
  if (csv != nullptr) csv->write("launch,vx,vy,points,balls_out,foul,steps,hash\n");
  for (std::uint64_t done = 0; done < options.count && !(csv != nullptr && csv->failed());
       done += velocities.size()) {
    velocities.clear();
    while (velocities.size() < std::min<std::uint64_t>(block.size(), options.count - done))
      velocities.push_back(random_velocity(random));
    summary.seconds += block.play(rollouts, start, velocities);
    for (std::size_t k = 0; k < velocities.size(); ++k) {
      const games::Outcome& outcome = block.outcome(k);
      summary.points.add(static_cast<std::uint64_t>(outcome.points));
      summary.balls_out.add(outcome.balls_out);
      summary.steps.add(outcome.steps);
      summary.fouls += outcome.foul ? 1 : 0;
      const std::uint64_t hash = block.hash(k);
      summary.hash.add(hash);
      if (csv != nullptr) csv->write(csv_line(done + k, velocities[k], outcome, hash));
    }
  }
  return summary;
}

void print_text(const ShotsOptions& options, const Summary& summary, std::FILE* out) {
  using Number = unsigned long long;
  const auto count = static_cast<double>(options.count);
  std::fprintf(out, "launches    %llu, seed %llu\n", static_cast<Number>(options.count),
               static_cast<Number>(options.seed));
  std::fprintf(out, "shots/s     %.0f, %d thread%s\n", count / summary.seconds, options.threads,
               options.threads == 1 ? "" : "s");
  std::fprintf(out, "            %8s %8s %8s %8s %10s\n", "least", "median", "90 %", "most",
               "mean");
  const auto row = [out](const char* name, const Distribution& values) {
    std::fprintf(out, "%-11s %8llu %8llu %8llu %8llu %10.2f\n", name,
                 static_cast<Number>(values.quantile(0)), static_cast<Number>(values.quantile(0.5)),
                 static_cast<Number>(values.quantile(0.9)), static_cast<Number>(values.quantile(1)),
                 values.mean());
  };
  row("points", summary.points);
  row("balls out", summary.balls_out);
  row("steps", summary.steps);
  std::fprintf(out, "fouls       %llu\n", static_cast<Number>(summary.fouls));
  std::fprintf(out, "hash        %s\n", carom::hash_text(summary.hash.hash()).c_str());
}

void print_json(const ShotsOptions& options, const Summary& summary, std::FILE* out) {
  const auto distribution = [](const Distribution& values) {
    return nlohmann::ordered_json{{"least", values.quantile(0)},
                                  {"median", values.quantile(0.5)},
                                  {"p90", values.quantile(0.9)},
                                  {"most", values.quantile(1)},
                                  {"mean", values.mean()}};
  };
  nlohmann::ordered_json balls_out = distribution(summary.balls_out);
  for (const auto& [balls, times] : summary.balls_out.times())
    balls_out["launches"][std::to_string(balls)] = times;
  const nlohmann::ordered_json all = {
      {"launches", options.count},
      {"seed", options.seed},
      {"threads", options.threads},
      {"skipping", !options.no_skip},
      {"seconds", summary.seconds},
      {"shots_per_second", static_cast<double>(options.count) / summary.seconds},
      {"points", distribution(summary.points)},
      {"balls_out", balls_out},
      {"steps", distribution(summary.steps)},
      {"fouls", summary.fouls},
      {"hash", carom::hash_text(summary.hash.hash())}};
  std::fprintf(out, "%s\n", all.dump().c_str());
}

int shots(const ShotsOptions& options) {
  auto scene = read_scene_file(options.scene);
  if (!scene) return report(scene.errors(), options.scene);
  auto created = carom::World::create(std::move(scene).value());
  if (!created) return report(created.errors(), options.scene);
  carom::World& start = created.value();
  if (!start.has_lead())
    return report({{.problem = "has nothing to launch",
                    .expected = "a projectile or a cue ball as the first ball"}},
                  options.scene);
  start.set_skipping(!options.no_skip);

  std::optional<files::Output> csv;
  if (options.csv) {
    const std::array inputs{options.scene};
    csv.emplace(*options.csv, inputs);
    if (const carom::Status opened = csv->opened(); !opened)
      return report_output(opened.errors(), *options.csv);
  }
  const Summary summary = play_all(options, start, csv ? &*csv : nullptr);
  if (csv)
    if (const carom::Status written = csv->commit(); !written)
      return report_output(written.errors(), *options.csv);
  // A table on standard output stays pure; the rest then goes to standard error.
  std::FILE* out = csv && csv->is_standard_output() ? stderr : stdout;
  if (options.json)
    print_json(options, summary, out);
  else
    print_text(options, summary, out);
  return done;
}

}  // namespace

void add_shots(CLI::App& carom, int& status) {
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<ShotsOptions>();
  CLI::App* command =
      carom.add_subcommand("shots", "Play random launches and tell what they came to.");
  command->add_option("scene", options->scene, "Scene or level file (JSON); - is standard input")
      ->required()
      ->check(cli::file_name())
      ->option_text("SCENE");
  cli::add_whole(*command, "--count", options->count, "How many launches", 1, most_launches)
      ->option_text("N [1000]");
  cli::add_whole(*command, "--seed", options->seed,
                 "Chooses them; with the same seed, fewer are the first of more")
      ->option_text("S [1]");
  cli::add_whole(*command, "--threads", options->threads,
                 "How many threads play. It changes the speed only", 1, carom::max_threads)
      ->option_text("T [1]");
  command->add_flag("--no-skip", options->no_skip,
                    "Test every step, also where surely nothing meets. It changes the speed only");
  command
      ->add_option("--csv", options->csv,
                   "Write a line a launch: its velocity in px/s and what it came to; - is "
                   "standard output")
      ->check(cli::file_name())
      ->option_text("FILE");
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(
      "Each launch starts from the scene's state, with the projectile or cue ball at 200 to 2000\n"
      "px/s in any direction, and ends by the rules: at rest, with the cue ball or all others out\n"
      "of play, when the next throw is offered, when the level is won. The hash is of all ends, "
      "in\n"
      "the order of the launches: no number of threads and no skipping changes it.\n"
      "Exit status: 0 done; 1 the scene is wrong or has nothing to launch, or a file cannot be\n"
      "read or written; 2 wrong usage.\n\n"
      "Examples:\n"
      "  carom shots scenes/break.json --count 10000\n"
      "  carom shots levels/05-over-the-wall.json --seed 7 --threads 2 --json\n"
      "  carom shots scenes/break.json --count 100 --csv - | head -n 3");
  command->callback([options, &status] { status = shots(*options); });
}

}  // namespace tool
