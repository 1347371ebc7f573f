#include "search/level_games.hpp"

#include <algorithm>

#include "carom/arithmetic.hpp"
#include "games/launch.hpp"
#include "search/opponent.hpp"

namespace search {

namespace {

using LevelGame = games::angry_balls::Game;
using games::angry_balls::Phase;

carom::Vec2 found_drag(const LevelGame& game, const LevelPlayer& player, Seed seed,
                       std::uint64_t turn, carom::Rollouts& rollouts) {
  // The game waits for a throw, and the player's numbers are sound.
  Opponent opponent =
      Opponent::create(game, {"", player.hand, player.simulations}, seed, turn).value();
  while (!opponent.done()) opponent.advance(player.simulations, rollouts);
  return opponent.decision().drag;
}

}  // namespace

carom::Vec2 random_drag(games::Random& random) {
  const carom::ExactArithmetic exact;
  constexpr double longest = games::max_launch_speed / games::launch_factor;
  for (;;) {
    const double x = random.uniform(-longest, longest);
    const double y = random.uniform(-longest, longest);
    const carom::Vec2 drag = games::on_grid({x, y});
    if (drag != carom::Vec2{} && carom::length(drag) <= longest) return drag;
  }
}

LevelGames play_level(const LevelGame& level, const std::optional<LevelPlayer>& player,
                      std::uint64_t count, Seed seed, carom::Rollouts& rollouts) {
  LevelGames result{
      .games = count,
      .won_in = std::vector<std::uint64_t>(static_cast<std::size_t>(level.level().throws))};
  for (std::uint64_t number = 0; number < count; ++number) {
    games::Random random = random_of(seed, Use::match, number);
    const Seed game_seed = random.next();
    LevelGame game = level;
    std::uint64_t turn = 0;
    while (game.phase() == Phase::aim) {
      const carom::Vec2 drag =
          player ? found_drag(game, *player, game_seed, turn, rollouts) : random_drag(random);
      if (!game.apply(games::angry_balls::Throw{drag})) break;
      while (game.phase() == Phase::fly) game.run(games::angry_balls::offer_steps);
      if (game.phase() == Phase::won) {
        ++result.won_in[static_cast<std::size_t>(turn)];
        result.scores.push_back(game.score());
      } else if (!game.apply(games::angry_balls::Next{})) {
        break;
      }
      ++turn;
    }
  }
  std::sort(result.scores.begin(), result.scores.end());
  return result;
}

}  // namespace search
