#include "tool/advise.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "carom/rollouts.hpp"
#include "carom/scene_file.hpp"
#include "cli/options.hpp"
#include "files/files.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"
#include "search/search.hpp"
#include "tool/counted.hpp"
#include "tool/exit_status.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

struct AdviseOptions {
  std::string file;
  double hand = 0;
  std::uint64_t simulations = 1000;
  std::uint64_t fresh = 400;
  std::uint64_t shots = 5;
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<std::uint64_t> turn;
  bool json = false;
};

constexpr std::uint64_t most_simulations = 1'000'000;

bool is_replay(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos &&
         (bytes[first] != '{' || bytes.find("\"angry-balls-replay\"") != std::string_view::npos);
}

/// Goes on until the player is to do something, or the game is over.
void let_roll(replay::AnyGame& game) {
  if (auto* level = std::get_if<games::angry_balls::Game>(&game)) {
    while (level->phase() == games::angry_balls::Phase::fly)
      level->run(games::angry_balls::offer_steps);
    if (level->phase() == games::angry_balls::Phase::offer)
      (void)level->apply(games::angry_balls::Next{});
    return;
  }
  auto& table = std::get<games::billiards::Game>(game);
  while (table.phase() == games::billiards::Phase::roll)
    table.run(games::billiards::max_turn_steps);
}

carom::Result<search::Game> game_of_replay(std::string_view bytes,
                                           std::optional<std::uint64_t> turn) {
  auto read = replay::read_replay(bytes);
  if (!read) return read.errors();
  auto verified = replay::verify(std::move(read).value());
  if (!verified) return verified.errors();
  replay::Player& player = verified.value();
  const std::size_t turns = player.turns().size();
  if (player.divergence())
    return carom::Error{.problem = replay::to_string(*player.divergence(), turns)};
  if (turn && *turn > turns)
    return carom::Error{.problem = "has " + counted(turns, "turn"),
                        .expected = "--turn from 1 to that"};
  player.seek(turn ? static_cast<std::size_t>(*turn - 1) : turns);
  replay::AnyGame game = player.game();
  let_roll(game);
  return game;
}

carom::Result<search::Game> game_of_scene(std::string_view bytes) {
  auto scene = carom::read_scene(bytes);
  if (!scene) return scene.errors();
  const auto& balls = scene.value().balls;
  if (balls.empty() || !carom::is_lead(balls[0].role))
    return carom::Error{.problem = "has nothing to launch",
                        .expected = "a projectile or a cue ball as the first ball"};
  if (balls[0].role == carom::Role::cue) {
    auto table = games::billiards::Game::create(std::move(scene).value());
    if (!table) return table.errors();
    return search::Game(std::move(table).value());
  }
  auto level = games::angry_balls::Game::create(std::move(scene).value());
  if (!level) return level.errors();
  return search::Game(std::move(level).value());
}

/// The outcome of an exact hand is certain, however often it is played.
nlohmann::ordered_json interval(const AdviseOptions& options, const search::Estimate& estimate) {
  const bool certain = options.hand <= 0;
  return {{"mean", estimate.mean},
          {"low", certain ? estimate.mean : estimate.low},
          {"high", certain ? estimate.mean : estimate.high}};
}

void print_json(const AdviseOptions& options, const search::Answer& answer, bool level) {
  nlohmann::ordered_json shots = nlohmann::ordered_json::array();
  for (const search::Ranked& ranked : answer.ranked) {
    nlohmann::ordered_json shot = {{"angle", ranked.shot.aim.tenths / 10.0},
                                   {"speed", ranked.shot.aim.speed}};
    if (ranked.shot.place) shot["place"] = {ranked.shot.place->x, ranked.shot.place->y};
    const carom::Vec2 drag = search::drag(ranked.shot.aim);
    shot["drag"] = {drag.x, drag.y};
    shot["simulations"] = ranked.fresh.n;
    shot["points"] = interval(options, ranked.fresh.points_estimate());
    shot["scores"] = interval(options, ranked.fresh.scored_estimate());
    if (level) {
      shot["clears"] = interval(options, ranked.fresh.cleared_estimate());
      shot["enemies_out"] = interval(options, ranked.fresh.enemies_estimate());
    } else {
      shot["fouls"] = interval(options, ranked.fresh.foul_estimate());
    }
    shots.push_back(std::move(shot));
  }
  const nlohmann::ordered_json all = {{"game", level ? "angry-balls" : "billiards"},
                                      {"hand", options.hand},
                                      {"seed", options.seed},
                                      {"simulations", answer.simulations},
                                      {"shots", std::move(shots)}};
  std::printf("%s\n", all.dump().c_str());
}

void print_text(const AdviseOptions& options, const search::Answer& answer, bool level) {
  std::printf("%llu simulations, hand %g px, seed %llu\n",
              static_cast<unsigned long long>(answer.simulations), options.hand,
              static_cast<unsigned long long>(options.seed));
  const bool placed = !answer.ranked.empty() && answer.ranked[0].shot.place.has_value();
  std::printf("   %sangle  speed   points  95 %%              %s\n",
              placed ? "      place       " : "", level ? "clears  95 %" : "fouls  95 %");
  int number = 0;
  for (const search::Ranked& ranked : answer.ranked) {
    std::printf("%2d ", ++number);
    if (ranked.shot.place) std::printf("%8.2f,%7.2f  ", ranked.shot.place->x, ranked.shot.place->y);
    const search::Estimate points = ranked.fresh.points_estimate();
    const search::Estimate rate =
        level ? ranked.fresh.cleared_estimate() : ranked.fresh.foul_estimate();
    std::printf("%6.1f %6d %8.1f  %7.1f to %7.1f %5.1f %%", ranked.shot.aim.tenths / 10.0,
                ranked.shot.aim.speed, points.mean, points.low, points.high, 100 * rate.mean);
    // One exact shot is no sample.
    if (options.hand > 0) std::printf("  %.1f to %.1f", 100 * rate.low, 100 * rate.high);
    std::printf("\n");
  }
}

int advise(const AdviseOptions& options) {
  const auto bytes = files::read_text(options.file);
  if (!bytes) return report(bytes.errors(), options.file);
  if (options.turn && !is_replay(bytes.value()))
    return report({{.problem = "has no turns", .expected = "a replay, with --turn"}}, options.file);
  auto game = is_replay(bytes.value()) ? game_of_replay(bytes.value(), options.turn)
                                       : game_of_scene(bytes.value());
  if (!game) return report(game.errors(), options.file);
  const bool level = std::holds_alternative<games::angry_balls::Game>(game.value());
  auto search = search::Search::create(
      std::move(game).value(), {.hand = {.error = options.hand},
                                .budget = {.simulations = options.simulations,
                                           .fresh = options.fresh,
                                           .shown = static_cast<std::size_t>(options.shots)},
                                .seed = options.seed});
  if (!search) return report(search.errors(), options.file);
  carom::Rollouts rollouts(options.threads);
  while (!search.value().done()) search.value().advance(most_simulations, rollouts);
  const search::Answer answer = search.value().answer();
  if (options.json)
    print_json(options, answer, level);
  else
    print_text(options, answer, level);
  return done;
}

}  // namespace

void add_advise(CLI::App& carom, int& status) {
  // Shared with the callback, which runs after this function has returned.
  const auto options = std::make_shared<AdviseOptions>();
  CLI::App* command = carom.add_subcommand("advise", "Tell good shots, found by simulation.");
  command
      ->add_option("file", options->file,
                   "Scene, level or replay (at its end); - is standard input")
      ->required()
      ->option_text("SCENE|LEVEL|REPLAY");
  command
      ->add_option_function<std::string>(
          "--hand",
          [options](const std::string& text) {
            const auto read = cli::read_number(text);
            if (!read || *read < 0 || *read > 1000)
              cli::refuse("--hand", text, "a number from 0 to 1000");
            options->hand = *read;
          },
          "Error of the hand that shoots, in px of drag, along and across; 1 px is 5 px/s. 0 is "
          "exact")
      ->option_text("PX [0]");
  cli::add_whole(*command, "--simulations", options->simulations, "How many find the shots", 1,
                 most_simulations)
      ->option_text("N [1000]");
  cli::add_whole(*command, "--fresh", options->fresh,
                 "How many more tell what each shot is worth with that hand", 1, most_simulations)
      ->option_text("N [400]");
  cli::add_whole(*command, "--shots", options->shots, "How many shots are told, at most", 1, 100)
      ->option_text("K [5]");
  cli::add_whole(*command, "--turn", options->turn,
                 "Of a replay, before its turn T instead of at its end", 1)
      ->option_text("T");
  cli::add_whole(*command, "--seed", options->seed, "Chooses what is tried")->option_text("S [1]");
  cli::add_whole(*command, "--threads", options->threads,
                 "How many threads play. It changes the speed only", 1, carom::max_threads)
      ->option_text("T [1]");
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(
      "The best shot is first: on a table by its expected points, in a level by the enemies it "
      "takes\n"
      "out. Angles are in degrees, counterclockwise from the right, speeds in px/s: type them in "
      "the\n"
      "game. Estimates are of simulations that did not choose the shot. What is printed is the "
      "same\n"
      "on every machine and for every number of threads (docs/search.md).\n"
      "Exit status: 0 done; 1 the file is wrong or cannot be read, or nobody is to shoot there;\n"
      "2 wrong usage.\n\n"
      "Examples:\n"
      "  carom advise scenes/break.json --hand 3\n"
      "  carom advise levels/05-over-the-wall.json --json\n"
      "  carom advise tests/replays/billiards-left-in-the-middle.json --turn 2");
  command->callback([options, &status] { status = advise(*options); });
}

}  // namespace tool
