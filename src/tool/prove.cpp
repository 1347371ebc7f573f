#include "tool/prove.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "carom/rollouts.hpp"
#include "carom/scene_file.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "games/angry_balls.hpp"
#include "replay/replay_text.hpp"
#include "search/proof.hpp"
#include "search/proof_file.hpp"
#include "tool/busy.hpp"
#include "tool/counted.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

namespace fs = std::filesystem;

struct ProveOptions {
  std::vector<std::string> levels;
  std::string coverage;
  search::ProofPlan plan;
  int threads = 1;
  bool first = false;
};

carom::Result<games::angry_balls::Game> read_game(const std::string& path) {
  const auto bytes = files::read_text(path, files::max_small_file);
  if (!bytes) return bytes.errors();
  auto level = games::angry_balls::read_level(bytes.value());
  if (!level) return level.errors();
  return games::angry_balls::Game::create(std::move(level).value());
}

void print_first(const std::string& path, const search::Throws& throws,
                 const games::angry_balls::Game& level, std::uint64_t simulations) {
  std::printf("%s: won in %s, found in %s: %s\n", shown_name(path).c_str(),
              counted(throws.size(), "throw").c_str(), counted(simulations, "simulation").c_str(),
              replay::write_text(search::replay_of(level, throws)).c_str());
}

void print_proof(const std::string& path, const search::Proof& proof) {
  search::Margin margin = search::widest_margin;
  for (const search::ProvenThrow& one : proof.throws) margin = std::min(margin, one.margin);
  const search::Estimate difficulty = proof.difficulty();
  std::printf(
      "%s: won in %s, each ± %.1f° and ± %d px/s; difficulty %.2f (%.2f to %.2f), par %d, "
      "gold %lld\n",
      shown_name(path).c_str(), counted(proof.throws.size(), "throw").c_str(), margin / 10.0,
      margin * search::margin_speed, difficulty.mean, difficulty.low, difficulty.high,
      proof.stars.par, static_cast<long long>(proof.stars.gold));
  std::fflush(stdout);
}

int prove(const std::string& path, const ProveOptions& options, carom::Rollouts& rollouts) {
  if (search::lies_beside_levels(path)) return done;
  if (path == "-" && !options.first)
    return report(
        {{.problem = "has no place for a proof beside it", .expected = "a file, or --first"}},
        path);
  const auto level = read_game(path);
  if (!level) return report(level.errors(), path);
  std::optional<Busy> busy("proving " + shown_name(path));
  if (options.first) {
    const search::Solved solved =
        search::solve(level.value(), options.plan.simulations, options.plan.seed, rollouts);
    busy.reset();
    if (solved.found.empty()) return report(search::not_found(solved), path);
    print_first(path, solved.found.front(), level.value(), solved.simulations);
    return done;
  }
  const auto proof = search::prove(level.value(), options.plan, rollouts);
  busy.reset();
  if (!proof) return report(proof.errors(), path);
  if (const carom::Status written =
          files::write(search::proof_name(path), search::write_proof(proof.value()));
      !written)
    return report_output(written.errors(), search::proof_name(path));
  print_proof(path, proof.value());
  return done;
}

/// The proof of a level, read and tried: by what it says of its throws, or by all that it says.
carom::Status try_proof(const std::string& level_path, bool all, carom::Rollouts& rollouts) {
  const auto level = read_game(level_path);
  if (!level) return level.errors();
  const auto bytes = files::read_text(search::proof_name(level_path), files::max_small_file);
  if (!bytes) return bytes.errors();
  const auto proof = search::read_proof(bytes.value());
  if (!proof) return carom::locate(bytes.value(), proof.errors());
  const carom::Status sound = all ? search::verify_proof(level.value(), proof.value(), rollouts)
                                  : search::check_proof(level.value(), proof.value(), rollouts);
  if (!sound) return carom::locate(bytes.value(), sound.errors());
  return carom::Done{};
}

/// The levels in a folder and its subfolders, by name.
carom::Result<std::vector<std::string>> levels_below(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> levels;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    const fs::path ending = entry->path().extension();
    if ((ending == ".json" || ending == ".angry-level") && entry->is_regular_file(ignored) &&
        !search::lies_beside_levels(entry->path().string()))
      levels.push_back(entry->path().string());
  }
  if (error)
    return carom::Error{.problem = {carom::MessageCode::cannot_be_opened, {error.message()}}};
  std::sort(levels.begin(), levels.end());
  return levels;
}

int coverage(const std::string& folder, carom::Rollouts& rollouts) {
  const auto levels = levels_below(folder);
  if (!levels) return report(levels.errors(), folder);
  std::size_t proven = 0;
  for (const std::string& level : levels.value()) {
    const carom::Status sound = try_proof(level, false, rollouts);
    if (sound)
      ++proven;
    else
      report(sound.errors(), search::proof_name(level));
  }
  std::printf("%zu of %s with a valid proof\n", proven,
              counted(levels.value().size(), "level").c_str());
  return proven == levels.value().size() ? done : wrong_input;
}

int verify(const std::string& level, carom::Rollouts& rollouts) {
  std::optional<Busy> busy("verifying " + shown_name(search::proof_name(level)));
  const carom::Status sound = try_proof(level, true, rollouts);
  busy.reset();
  if (!sound) return report(sound.errors(), search::proof_name(level));
  std::printf("%s: ok\n", shown_name(search::proof_name(level)).c_str());
  return done;
}

void add_threads(CLI::App& command, int& threads) {
  cli::add_whole(command, "--threads", threads, "How many threads play. It changes the speed only",
                 1, carom::max_threads)
      ->option_text("T [1]");
}

void add_verify(CLI::App& carom, int& status) {
  struct Options {
    std::vector<std::string> levels;
    int threads = 1;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = carom.add_subcommand("verify", "Play what the proofs of levels state.");
  command->add_option("level", options->levels, "Level files, or the proofs that lie beside them")
      ->required()
      ->check(cli::file_name())
      ->option_text("LEVEL...");
  add_threads(*command, options->threads);
  command->footer(
      "Plays the replay, the margins of its throws and every game of the players, and says the\n"
      "first place of a proof that is not what playing gives.\n"
      "Exit status: 0 all proofs hold; 1 some do not, or cannot be read; 2 wrong usage.\n\n"
      "Example:\n"
      "  carom verify levels/02-two-towers.json");
  command->callback([options, &status] {
    carom::Rollouts rollouts(options->threads);
    std::set<std::string> proofs;  // done: *.json names levels and proofs
    for (const std::string& path : options->levels) {
      const std::string level = search::level_name(path);
      if (search::lies_beside_levels(level) || !proofs.insert(search::proof_name(level)).second)
        continue;
      if (verify(level, rollouts) != done) status = wrong_input;
    }
  });
}

}  // namespace

void add_prove(CLI::App& carom, int& status) {
  add_verify(carom, status);
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<ProveOptions>();
  CLI::App* command =
      carom.add_subcommand("prove", "Find how levels are won, and measure how hard they are.");
  command->add_option("level", options->levels, "Level files")
      ->check(cli::file_name())
      ->option_text("LEVEL...");
  command
      ->add_option("--coverage", options->coverage,
                   "Try the proofs of all levels in a folder and those below it instead")
      ->check(cli::file_name())
      ->option_text("DIR");
  command->add_flag("--first", options->first,
                    "Print the first game found that is won, as the text of a replay, and write "
                    "nothing");
  cli::add_whole(*command, "--simulations", options->plan.simulations,
                 "How many throws are tried to find winning ones, at most", 1, 100'000'000)
      ->option_text("N [100000]");
  cli::add_whole(*command, "--games", options->plan.games,
                 "How many games measure what each hand wins", 1, search::most_proof_games)
      ->option_text("N [200]");
  cli::add_whole(*command, "--seed", options->plan.seed, "Chooses what is tried and played")
      ->option_text("S [1]");
  add_threads(*command, options->threads);
  command->footer(
      "Writes LEVEL.proof.json beside each LEVEL.json: a game that is won, how far its throws may\n"
      "be off, what players with hands of 0 to 8 px win, the difficulty and what the stars are\n"
      "given for (docs/formats.md). The same level and options give the same bytes on every\n"
      "machine. A level without winning throws found may have some all the same.\n"
      "Exit status: 0 all are proven; 1 a level is wrong, none of its throws found wins, or (with\n"
      "--coverage) a level has no valid proof; 2 wrong usage.\n\n"
      "Examples:\n"
      "  carom prove my-level.json\n"
      "  carom prove --first levels/10-the-fortress.json\n"
      "  carom prove --coverage levels");
  command->callback([options, &status] {
    if (options->levels.empty() == options->coverage.empty())
      throw CLI::ValidationError("level", "expected levels or --coverage, one of both");
    carom::Rollouts rollouts(options->threads);
    if (!options->coverage.empty()) status = coverage(options->coverage, rollouts);
    for (const std::string& level : options->levels)
      if (prove(level, *options, rollouts) != done) status = wrong_input;
  });
}

}  // namespace tool
