#include "tool/check.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "carom/rollouts.hpp"
#include "carom/scene_file.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "games/angry_balls.hpp"
#include "games/level_check.hpp"
#include "search/proof_file.hpp"
#include "search/solver.hpp"
#include "tool/busy.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

/// The throws that win a level, the most robust that were found.
struct Winning {
  search::Throws throws{};  ///< empty: none were found
  std::vector<search::Margin> margins{};
  std::uint64_t simulations = 0;  ///< played to find them; 0: it was not tried
};

/// The outcome for one level.
struct Checked {
  carom::Errors errors{};
  carom::Errors warnings{};
  bool complete = true;  ///< all that the check tries was tried
  Winning winning{};
};

Winning find_winning(const games::angry_balls::Game& level) {
  // In ball-steps, as if every throw were watched to its end: some seconds at worst.
  constexpr std::uint64_t most_work = 30'000'000;
  constexpr std::uint64_t least = 20;  // simulations; fewer find nothing
  constexpr std::uint64_t most = 3'000;
  const std::uint64_t simulations =
      std::min(most, most_work / (level.world().size() * games::angry_balls::offer_steps));
  if (simulations < least) return {};
  constexpr search::Seed seed{1};
  carom::Rollouts rollouts(1);
  const search::Solved solved = search::solve(level, simulations, seed, rollouts);
  Winning winning{.simulations = solved.simulations};
  if (solved.found.empty()) return winning;
  winning.throws = search::most_robust(level, solved, seed, rollouts);
  for (std::size_t i = 0; i < winning.throws.size(); ++i)
    winning.margins.push_back(search::margin(level, winning.throws, i, rollouts));
  return winning;
}

Checked check(const std::string& path) {
  std::optional<Busy> busy("reading " + shown_name(path));
  const auto bytes = files::read_text(path);
  if (!bytes) return {.errors = bytes.errors()};
  const auto level = games::angry_balls::read_level(bytes.value());
  if (!level) return {.errors = level.errors()};
  busy.reset();
  busy.emplace("trying " + shown_name(path));
  games::angry_balls::LevelReport tried =
      games::angry_balls::level_report(level.value(), games::angry_balls::level_check_budget,
                                       [&busy](double part) { busy->set_part(part); });
  // First the warnings are to be seen to: what they tell of makes a search long, or useless.
  const bool sound = tried.complete && tried.warnings.empty();
  Checked checked{.warnings = carom::locate(bytes.value(), std::move(tried.warnings)),
                  .complete = tried.complete};
  if (!sound) return checked;
  busy.reset();
  busy.emplace("looking for winning throws of " + shown_name(path));
  if (const auto game = games::angry_balls::Game::create(level.value()))
    checked.winning = find_winning(game.value());
  return checked;
}

std::string decimal(int tenths) {
  const std::string digits = std::to_string(std::abs(tenths));
  return (tenths < 0 ? "-" : "") + (digits.size() < 2 ? "0" : digits.substr(0, digits.size() - 1)) +
         '.' + digits.back();
}

/// "won by 33.5°, 860 px/s (± 0.4°, ± 8 px/s)", a throw after the other.
std::string text_of(const Winning& winning) {
  if (winning.throws.empty())
    return "no winning throws found in " + std::to_string(winning.simulations) + " simulations";
  std::string text = "won by ";
  for (std::size_t i = 0; i < winning.throws.size(); ++i) {
    const search::Aim& aim = winning.throws[i];
    const search::Margin margin = std::max(winning.margins[i], 0);
    text += (i > 0 ? ", then " : "") + decimal(aim.tenths) + "°, " + std::to_string(aim.speed) +
            " px/s";
    text += margin == 0 ? " (exactly)"
                        : " (± " + decimal(margin) + "°, ± " +
                              std::to_string(margin * search::margin_speed) + " px/s)";
  }
  return text;
}

void print_text(const std::string& path, const Checked& checked) {
  report(checked.errors, path);
  for (carom::Error warning : checked.warnings) {
    warning.problem = {carom::MessageCode::warning, {carom::to_string(warning.problem)}};
    std::fprintf(stderr, "%s\n", carom::to_string(warning, shown_name(path)).c_str());
  }
  if (!checked.errors.empty()) return;
  std::printf("%s: ok\n", shown_name(path).c_str());
  if (checked.winning.simulations > 0)
    std::printf("%s: %s\n", shown_name(path).c_str(), text_of(checked.winning).c_str());
}

nlohmann::ordered_json json_of(const carom::Errors& errors) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const carom::Error& error : errors) {
    nlohmann::ordered_json one = nlohmann::ordered_json::object();
    if (error.line != 0) one["line"] = error.line;
    if (error.column != 0) one["column"] = error.column;
    one["pointer"] = error.pointer;
    one["code"] = carom::name(error.problem.code);
    one["problem"] = carom::to_string(error.problem);
    if (!error.expected.empty()) one["expected"] = carom::to_string(error.expected);
    all.push_back(std::move(one));
  }
  return all;
}

nlohmann::ordered_json json_of(const Winning& winning) {
  nlohmann::ordered_json throws = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < winning.throws.size(); ++i) {
    const search::Margin margin = std::max(winning.margins[i], 0);
    throws.push_back({{"angle", winning.throws[i].tenths / 10.0},
                      {"speed", winning.throws[i].speed},
                      {"margin-degrees", margin / 10.0},
                      {"margin-speed", margin * search::margin_speed}});
  }
  return {{"throws", std::move(throws)}, {"simulations", winning.simulations}};
}

nlohmann::ordered_json json_of(const std::string& path, const Checked& checked) {
  return {{"level", shown_name(path)},         {"ok", checked.errors.empty()},
          {"errors", json_of(checked.errors)}, {"warnings", json_of(checked.warnings)},
          {"complete", checked.complete},      {"won-by", json_of(checked.winning)}};
}

int check_all(const std::vector<std::string>& levels, bool json) {
  int status = done;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const std::string& level : levels) {
    const Checked checked = check(level);
    if (!checked.errors.empty()) status = wrong_input;
    if (json)
      all.push_back(json_of(level, checked));
    else
      print_text(level, checked);
  }
  if (json) std::printf("%s\n", nlohmann::ordered_json{{"levels", all}}.dump(2).c_str());
  return status;
}

// A change of a file: its time and size, as far as they can be known.
using Stamp = std::pair<std::filesystem::file_time_type, std::uintmax_t>;

Stamp stamp(const std::string& path) {
  std::error_code none;
  const auto time = std::filesystem::last_write_time(path, none);
  if (none) return {};
  return {time, std::filesystem::file_size(path, none)};
}

// Checks each level again whenever its file has changed, until the program is ended.
[[noreturn]] void watch(const std::vector<std::string>& levels, bool json) {
  std::vector<std::optional<Stamp>> seen(levels.size());
  while (true) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const Stamp now = stamp(levels[i]);
      if (seen[i] == now) continue;
      seen[i] = now;
      const Checked checked = check(levels[i]);
      if (json)
        std::printf("%s\n", json_of(levels[i], checked).dump().c_str());
      else
        print_text(levels[i], checked);
      std::fflush(stdout);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

}  // namespace

void add_check(CLI::App& carom, int& status) {
  struct Options {
    std::vector<std::string> levels;
    bool json = false;
    bool watch = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = carom.add_subcommand("check", "Say what is wrong with a level.");
  command->add_option("level", options->levels, "Level files (JSON); - is standard input")
      ->required()
      ->check(cli::file_name())
      ->option_text("LEVEL...");
  command->add_flag("--json", options->json, "Print one JSON object with errors and warnings");
  command->add_flag(
      "--watch", options->watch,
      "Check again whenever a file changes, until Ctrl-C; with --json, a line per check");
  command->footer(
      "Says \"ok\", or every error with line, column, pointer and what was expected. Warns of "
      "what\n"
      "a player would hold against a sound level: balls that do not stay where they were put or\n"
      "never come to rest, enemies that no throw can harm, lengths in metres. Of a level without "
      "warnings it names throws "
      "that\n"
      "win, the most robust it finds, with how much all of an aim may be off. Large levels are "
      "not\n"
      "tried in full, and it says so.\n"
      "Exit status: 0 all levels are sound, warnings or not; 1 some are not, or cannot be read; 2\n"
      "wrong usage.\n\n"
      "Examples:\n"
      "  carom check levels/01-first-steps.json\n"
      "  carom check levels/*.json\n"
      "  carom check --json levels/01-first-steps.json");
  command->callback([options, &status] {
    std::erase_if(options->levels,
                  [](const std::string& path) { return search::lies_beside_levels(path); });
    if (options->watch) watch(options->levels, options->json);
    status = check_all(options->levels, options->json);
  });
}

}  // namespace tool
