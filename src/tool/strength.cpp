#include "tool/strength.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "carom/rollouts.hpp"
#include "carom/trace.hpp"
#include "cli/number.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "replay/replay.hpp"
#include "search/match.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

struct StrengthOptions {
  std::uint64_t games = 200;
  std::pair<std::uint64_t, std::uint64_t> shard{1, 1};
  std::vector<std::string> played;
};

constexpr std::string_view strength_columns =
    "versions,level_a,level_b,game,points_a,points_b,fouls_a,fouls_b,turns_a,turns_b,simulations_a,"
    "simulations_b,hash,seconds";

/// A game of the plan: levels from 0, a above b. In game 2k a breaks, in 2k + 1, which mirrors it,
/// b.
struct Planned {
  std::size_t a = 0;
  std::size_t b = 0;
  std::uint64_t game = 0;
};

/// All neighbours play `games`, levels two apart a tenth of it; pair by pair, so that what is done
/// when it is stopped is even.
std::vector<Planned> plan(std::uint64_t games) {
  std::vector<Planned> all;
  for (std::uint64_t game = 0; game < games; game += 2)
    for (std::size_t apart = 1; apart <= 2; ++apart)
      for (std::size_t b = 0; b + apart < search::levels.size(); ++b)
        for (const std::uint64_t mirrored : {0U, 1U})
          if (apart == 1 || game % 20 == 0) all.push_back({b + apart, b, game + mirrored});
  return all;
}

/// The first columns of a game's row: they say which one it is.
std::string key(const Planned& planned) {
  return std::to_string(replay::physics_version) + '.' + std::to_string(replay::rules_version) +
         '.' + std::to_string(search::version) + ',' + std::to_string(planned.a + 1) + ',' +
         std::to_string(planned.b + 1) + ',' + std::to_string(planned.game);
}

/// The part of a row before its `columns`-th comma.
std::string_view front(std::string_view row, int columns) {
  std::size_t end = 0;
  for (; columns > 0 && end != std::string_view::npos; --columns)
    end = row.find(',', end == 0 ? 0 : end + 1);
  return row.substr(0, end);
}

std::string row_of(const Planned& planned, carom::Rollouts& rollouts) {
  const std::clock_t start = std::clock();
  const search::Seed seed =
      (planned.game / 2 * search::levels.size() + planned.a) * search::levels.size() + planned.b;
  const search::GameResult result =
      search::play_game({search::levels[planned.a], search::levels[planned.b]},
                        static_cast<int>(planned.game % 2), seed, rollouts);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::string row = key(planned);
  const auto add = [&row](const auto& by_side) {
    for (const auto number : by_side) row += ',' + std::to_string(number);
  };
  add(result.points);
  add(result.fouls);
  add(result.turns);
  add(result.simulations);
  row += ',' + carom::hash_text(result.hash) + ',';
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", seconds);
  return row + text.data();
}

int strength(const StrengthOptions& options) {
  std::set<std::string, std::less<>> played;
  for (const std::string& path : options.played) {
    const auto bytes = files::read_text(path);
    if (!bytes) return report(bytes.errors(), path);
    std::string_view rest = bytes.value();
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size() - 1);
      played.emplace(front(rest.substr(0, end), 4));
      rest.remove_prefix(end + 1);
    }
  }
  carom::Rollouts rollouts(1);
  std::printf("%s\n", std::string(strength_columns).c_str());
  std::uint64_t number = 0;
  for (const Planned& planned : plan(options.games)) {
    if (number++ % options.shard.second != options.shard.first - 1) continue;
    if (played.contains(key(planned))) continue;
    std::printf("%s\n", row_of(planned, rollouts).c_str());
    // A row is a game that need not be played again.
    std::fflush(stdout);
  }
  return done;
}

}  // namespace

void add_strength(CLI::App& carom, int& status) {
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<StrengthOptions>();
  CLI::App* command =
      carom.add_subcommand("strength", "Play the computer's levels against each other.");
  cli::add_whole(*command, "--games", options->games, "Games of each pair of neighbours", 1,
                 1'000'000)
      ->option_text("N [200]");
  command
      ->add_option_function<std::string>(
          "--shard",
          [options](const std::string& text) {
            const std::size_t slash = text.find('/');
            const auto i = cli::read_whole(std::string_view(text).substr(0, slash));
            const auto n = slash == std::string::npos
                               ? std::nullopt
                               : cli::read_whole(std::string_view(text).substr(slash + 1));
            if (!i || !n || *i < 1 || *i > *n || *n > 1'000'000)
              cli::refuse("--shard", text, "a part of all, such as 2/4");
            options->shard = {*i, *n};
          },
          "Only every N-th game, from the I-th")
      ->option_text("I/N [1/1]");
  command->add_option("--played", options->played, "Leave out the games that this log has")
      ->check(cli::file_name())
      ->option_text("FILE");
  command->footer(
      "Prints a line a game; levels count from 1, the seconds are of the processor. ./run "
      "strength\n"
      "plays on from its log and makes docs/strength.md of it.\n"
      "Exit status: 0 done; 1 a log cannot be read; 2 wrong usage.\n\n"
      "Example:\n"
      "  carom strength --games 200 --shard 1/4 --played bench/strength/log.csv >> log.csv");
  command->callback([options, &status] { status = strength(*options); });
}

}  // namespace tool
