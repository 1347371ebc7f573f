#include "search/generator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "carom/arithmetic.hpp"
#include "carom/world.hpp"
#include "games/angry_balls.hpp"
#include "games/launch.hpp"
#include "games/level_check.hpp"
#include "games/play_out.hpp"
#include "games/settling.hpp"
#include "search/level_games.hpp"
#include "search/solver.hpp"

namespace search {

namespace {

using LevelGame = games::angry_balls::Game;

constexpr double nearest = 0.04;  // to the difficulty wanted, as measured
constexpr std::uint64_t settling_work = 200'000;
constexpr std::uint64_t solving = 20'000;  // simulations
/// Games that the difficulty is measured by: a candidate goes on as long as it may be right.
constexpr std::array<std::uint64_t, 5> rated_games{4, 12, 30, 100, 400};
/// A level that is too easy or too hard has the solidities of its enemies changed, so often at
/// most; at first by this factor, after each change of direction by its root.
constexpr int tunings = 4;
constexpr double first_factor = 1.5;
constexpr double softest = 500;
constexpr double hardest = 9000;
/// A player waits for the end of a throw, and so does whoever rates the level.
constexpr std::uint64_t throws_timed = 40;
constexpr std::uint64_t longest_throw = 500;  // steps, the mean
constexpr std::uint64_t random_games_played = 100;
constexpr double most_by_chance = 0.25;

bool settled(const carom::Scene& level) {
  carom::Scene others = level;
  others.balls.erase(others.balls.begin());  // the projectile hangs until it is thrown
  auto world = carom::World::create(std::move(others));
  if (!world) return false;
  const games::Settling settling = games::look_ahead(std::move(world).value(), settling_work);
  return settling.complete && settling.restless.empty();
}

bool ends_soon(const LevelGame& level, Seed seed) {
  games::Random random = random_of(seed, Use::generating);
  std::uint64_t steps = 0;
  for (std::uint64_t i = 0; i < throws_timed; ++i) {
    carom::World world = level.world();
    const auto played = games::play_out(world, games::launch_velocity(random_drag(random)));
    if (played) steps += played.value().steps;
  }
  return steps <= longest_throw * throws_timed;
}

/// The difficulty of a level, measured as long as it may be the one that is wanted.
Estimate rate(const LevelGame& level, double wanted, Seed seed, carom::Rollouts& rollouts) {
  std::uint64_t played = 0;
  std::uint64_t lost = 0;
  Estimate difficulty;
  for (const std::uint64_t games : rated_games) {
    const LevelGames more =
        play_level(level, reference_player, games - played, seed + played, rollouts);
    played = games;
    lost += more.games - more.won();
    difficulty = estimate_rate(played, lost);
    if (wanted < difficulty.low || wanted > difficulty.high) break;
  }
  return difficulty;
}

/// Is true for a level of the difficulty wanted that is fit to be played.
bool fit(const LevelGame& level, const Estimate& difficulty, double wanted, Seed seed,
         carom::Rollouts& rollouts) {
  if (difficulty.n < rated_games.back() || std::abs(difficulty.mean - wanted) > nearest)
    return false;
  if (wanted > 0.1 &&
      play_level(level, {}, random_games_played, seed, rollouts).rate().mean > most_by_chance)
    return false;
  return !solve(level, solving, seed, rollouts).found.empty() &&
         games::angry_balls::level_warnings(level.level()).empty();
}

/// Changes the solidities of the enemies, to whole tens.
void toughen(carom::Scene& level, double factor) {
  for (carom::Ball& ball : level.balls)
    if (ball.role == carom::Role::enemy)
      ball.solidity = std::clamp(10 * std::round(ball.solidity * factor / 10), softest, hardest);
}

/// Makes `level` as hard as it is wanted, if that can be done.
std::optional<Estimate> tuned(carom::Scene& level, double wanted, Seed seed,
                              carom::Rollouts& rollouts) {
  if (!settled(level)) return std::nullopt;
  if (const auto game = LevelGame::create(level); !game || !ends_soon(game.value(), seed))
    return std::nullopt;
  double factor = first_factor;
  std::optional<bool> was_harder;
  for (int i = 0; i < tunings; ++i) {
    const LevelGame game = LevelGame::create(level).value();
    const Estimate difficulty = rate(game, wanted, seed, rollouts);
    if (fit(game, difficulty, wanted, seed, rollouts)) return difficulty;
    const bool harder = difficulty.mean < wanted;
    if (was_harder && *was_harder != harder) factor = std::sqrt(factor);
    was_harder = harder;
    toughen(level, harder ? factor : 1 / factor);
  }
  return std::nullopt;
}

}  // namespace

carom::Result<Generated> generate(const Order& order, carom::Rollouts& rollouts) {
  const carom::ExactArithmetic exact;
  if (!(order.difficulty >= 0 && order.difficulty <= 1))
    return carom::Error{
        .pointer = "difficulty", .problem = "is out of range", .expected = "a number from 0 to 1"};
  for (std::uint64_t n = 0; n < order.candidates; ++n) {
    games::Random random = random_of(order.seed, Use::generating, n);
    const Part first = order.first.value_or(static_cast<Part>(random.below(part_names.size())));
    // More parts are harder, on the whole.
    const auto usual = static_cast<std::size_t>(std::lround(3 * order.difficulty));
    carom::Scene level =
        assemble(first, 1 + usual + static_cast<std::size_t>(random.below(2)), random);
    const auto difficulty = tuned(level, order.difficulty, random.next(), rollouts);
    if (!difficulty) continue;
    const std::string_view about = part_names[static_cast<std::size_t>(first)];
    level.name = std::string(1, static_cast<char>(about[0] - 'a' + 'A')) +
                 std::string(about.substr(1)) + ' ' + std::to_string(order.seed);
    return Generated{.level = std::move(level), .difficulty = *difficulty, .candidates = n + 1};
  }
  return carom::Error{.problem = "none of " + std::to_string(order.candidates) +
                                 " candidates has the difficulty wanted"};
}

}  // namespace search
