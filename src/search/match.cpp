#include "search/match.hpp"

#include "carom/fnv1a.hpp"
#include "games/billiards.hpp"

namespace search {

GameResult play_game(const std::array<Level, 2>& sides, int breaker, Seed seed,
                     carom::Rollouts& rollouts) {
  using namespace games::billiards;
  // Player 0 breaks.
  const auto side_of = [breaker](int player) { return static_cast<std::size_t>(player ^ breaker); };
  games::billiards::Game game;
  GameResult result;
  carom::Fnv1a hash;
  for (int turn = 0; turn < most_turns && game.phase() != games::billiards::Phase::over; ++turn) {
    const std::size_t side = side_of(game.player());
    // The game waits for this player, and the table has room.
    Opponent opponent = Opponent::create(game, sides[side], player_seed(seed, game.player()),
                                         static_cast<std::uint64_t>(turn))
                            .value();
    while (!opponent.done()) opponent.advance(1U << 20U, rollouts);
    const Decision decision = opponent.decision();
    if (decision.meant.place) {
      if (!game.apply(Place{*decision.meant.place})) break;
      hash.add(decision.meant.place->x);
      hash.add(decision.meant.place->y);
    }
    if (!game.apply(Shoot{decision.drag})) break;
    while (game.phase() == games::billiards::Phase::roll)
      game.run(games::billiards::max_turn_steps);
    hash.add(decision.drag.x);
    hash.add(decision.drag.y);
    for (const int each : {0, 1}) hash.add(static_cast<std::uint64_t>(game.score(each)));
    ++result.turns[side];
    result.simulations[side] += opponent.simulated();
  }
  for (const int player : {0, 1}) {
    const std::size_t side = side_of(player);
    result.points[side] = game.score(player);
    result.fouls[side] = game.tally(player).fouls;
  }
  if (result.points[0] != result.points[1])
    result.winner = result.points[0] > result.points[1] ? 0 : 1;
  result.hash = hash.hash();
  return result;
}

}  // namespace search
