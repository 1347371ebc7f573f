#include "tool/soak.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/options.hpp"
#include "replay/replay_text.hpp"
#include "soak/random_game.hpp"
#include "tool/exit_status.hpp"

namespace tool {

namespace {

struct SoakOptions {
  std::uint64_t games = 100;
  std::uint64_t seed = 1;
  std::string kind = "both";
};

using Number = unsigned long long;

int soak(const SoakOptions& options) {
  std::uint64_t turns = 0;
  std::uint64_t steps = 0;
  std::uint64_t longest_turn = 0;
  std::size_t biggest_text = 0;
  for (std::uint64_t n = 0; n < options.games; ++n) {
    const std::uint64_t seed = options.seed + n;
    const bool billiards = options.kind == "both" ? seed % 2 == 1 : options.kind == "billiards";
    const auto kind = billiards ? replay::Kind::billiards : replay::Kind::angry_balls;
    const ::soak::PlayedGame game = ::soak::play_random_game(seed, kind);
    if (!game.failure.empty()) {
      std::fprintf(stderr, "%s game of seed %llu: %s\nIts replay up to there:\n",
                   billiards ? "billiards" : "Angry Balls", static_cast<Number>(seed),
                   game.failure.c_str());
      std::printf("%s\n", replay::write_text(game.replay).c_str());
      return wrong_input;
    }
    turns += game.turns;
    steps += game.steps;
    longest_turn = std::max(longest_turn, game.longest_turn);
    biggest_text = std::max(biggest_text, game.text_size);
  }
  std::printf(
      "%llu games sound and verified: %llu turns, %llu steps, longest turn %llu steps, biggest "
      "text %zu characters\n",
      static_cast<Number>(options.games), static_cast<Number>(turns), static_cast<Number>(steps),
      static_cast<Number>(longest_turn), biggest_text);
  return done;
}

}  // namespace

void add_soak(CLI::App& carom, int& status) {
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<SoakOptions>();
  CLI::App* command =
      carom.add_subcommand("soak", "Play random games and check whatever must always hold.");
  cli::add_whole(*command, "--games", options->games, "How many")->option_text("N [100]");
  cli::add_whole(*command, "--seed", options->seed,
                 "The first game's; each further one has the next. The same seed gives the same "
                 "game")
      ->option_text("S [1]");
  command
      ->add_option("--kind", options->kind,
                   "billiards, angry-balls, or both: billiards for odd seeds")
      ->check(CLI::IsMember({"billiards", "angry-balls", "both"}))
      ->option_text("KIND [both]");
  command->footer(
      "After every step: all numbers are finite, no ball sticks out of a solid edge, none "
      "appears,\n"
      "energy comes from gravity and holes only, and the quadtree and testing all pairs agree. "
      "After\n"
      "every game: its replay, written and read in both forms, is the same and verifies. On a\n"
      "failure: the seed, what went wrong, and on standard output the replay as text.\n"
      "Exit status: 0 all held; 1 something did not; 2 wrong usage.\n\n"
      "Examples:\n"
      "  carom soak --games 20\n"
      "  carom soak --games 1 --seed 7 --kind angry-balls");
  command->callback([options, &status] { status = soak(*options); });
}

}  // namespace tool
