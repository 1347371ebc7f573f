#include "tool/generate.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "carom/rollouts.hpp"
#include "carom/scene_file.hpp"
#include "cli/number.hpp"
#include "cli/options.hpp"
#include "games/angry_balls.hpp"
#include "search/generator.hpp"
#include "search/level_games.hpp"
#include "tool/busy.hpp"
#include "tool/exit_status.hpp"

namespace tool {

namespace {

struct GenerateOptions {
  search::Order order;
  int threads = 1;
  std::uint64_t trials = 0;
};

std::string problem(const carom::Errors& errors) { return carom::to_string(errors.front()); }

int generate(const GenerateOptions& options) {
  carom::Rollouts rollouts(options.threads);
  std::optional<Busy> busy("generating");
  const auto made = search::generate(options.order, rollouts);
  busy.reset();
  if (!made) {
    std::fprintf(stderr, "%s\n", problem(made.errors()).c_str());
    return wrong_input;
  }
  std::fprintf(stderr, "difficulty %.2f (%.2f to %.2f), candidate %llu\n",
               made.value().difficulty.mean, made.value().difficulty.low,
               made.value().difficulty.high,
               static_cast<unsigned long long>(made.value().candidates));
  std::fputs(carom::write_scene(made.value().level).c_str(), stdout);
  return done;
}

/// Orders with difficulties from 0.05 to 0.95 and seeds one after the other, and what fresh games
/// say of what was made.
int try_orders(GenerateOptions options) {
  carom::Rollouts rollouts(options.threads);
  std::uint64_t near = 0;
  std::printf("seed  wanted  made  fresh  candidates\n");
  for (std::uint64_t i = 0; i < options.trials; ++i, ++options.order.seed) {
    options.order.difficulty = 0.05 + 0.1 * static_cast<double>(i % 10);
    const auto made = search::generate(options.order, rollouts);
    const auto seed = static_cast<unsigned long long>(options.order.seed);
    if (!made) {
      std::printf("%4llu  %6.2f  %s\n", seed, options.order.difficulty,
                  problem(made.errors()).c_str());
      continue;
    }
    const auto game = games::angry_balls::Game::create(made.value().level).value();
    const double fresh =
        1 - search::play_level(game, search::reference_player, 400, ~options.order.seed, rollouts)
                .rate()
                .mean;
    near += std::abs(fresh - options.order.difficulty) <= 0.1 ? 1 : 0;
    std::printf("%4llu  %6.2f  %4.2f  %5.2f  %10llu\n", seed, options.order.difficulty,
                made.value().difficulty.mean, fresh,
                static_cast<unsigned long long>(made.value().candidates));
    std::fflush(stdout);
  }
  std::printf("%llu of %llu within 0.1\n", static_cast<unsigned long long>(near),
              static_cast<unsigned long long>(options.trials));
  return done;
}

}  // namespace

void add_generate(CLI::App& carom, int& status) {
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = carom.add_subcommand("generate", "Make a level as hard as it is wanted.");
  command
      ->add_option_function<std::string>(
          "--difficulty",
          [options](const std::string& text) {
            const auto read = cli::read_number(text);
            if (!read || *read < 0 || *read > 1)
              cli::refuse("--difficulty", text, "a number from 0 to 1");
            options->order.difficulty = *read;
          },
          "1 less the part of its games that the reference player wins (docs/levels.md)")
      ->option_text("D [0.5]");
  cli::add_whole(*command, "--seed", options->order.seed, "Chooses the level")
      ->option_text("S [1]");
  command
      ->add_option_function<std::string>(
          "--template",
          [options](const std::string& text) {
            const auto found = std::ranges::find(search::part_names, text);
            if (found == search::part_names.end()) {
              std::string names;
              for (const std::string_view name : search::part_names)
                names += (names.empty() ? "" : ", ") + std::string(name);
              cli::refuse("--template", text, "one of " + names);
            }
            options->order.first = static_cast<search::Part>(found - search::part_names.begin());
          },
          "What the level is about: ball, sentinel, tower, pyramid, pit, wall, chain or room; "
          "else any")
      ->option_text("T");
  cli::add_whole(*command, "--candidates", options->order.candidates,
                 "How many levels are put together, at most", 1, 1'000'000)
      ->option_text("N [100]");
  cli::add_whole(*command, "--trials", options->trials,
                 "Instead: so many orders, and how far fresh games are from what was wanted", 1,
                 1'000'000)
      ->option_text("N");
  cli::add_whole(*command, "--threads", options->threads,
                 "How many threads play. It changes the speed only", 1, carom::max_threads)
      ->option_text("T [1]");
  command->footer(
      "Puts levels together from parts until one stays as it is, can be won, is not won by chance\n"
      "and is as hard as it is wanted; prints it, and on standard error its difficulty. The same\n"
      "order gives the same bytes on every machine. Hard levels take a minute or more\n"
      "(docs/search.md).\n"
      "Exit status: 0 done; 1 no candidate is right; 2 wrong usage.\n\n"
      "Examples:\n"
      "  carom generate --difficulty 0.6 --seed 7 > my-level.json\n"
      "  carom generate --difficulty 0.3 --template tower\n"
      "  carom generate --trials 20");
  command->callback([options, &status] {
    status = options->trials > 0 ? try_orders(*options) : generate(*options);
  });
}

}  // namespace tool
