#include "search/opponent.hpp"

#include <algorithm>
#include <utility>

namespace search {

Seed player_seed(Seed game, int player) {
  games::Random seeds = random_of(game, Use::match);
  const Seed first = seeds.next();
  return player == 0 ? first : seeds.next();
}

carom::Result<Opponent> Opponent::create(Game game, const Level& level, Seed seed,
                                         std::uint64_t turn) {
  const Seed turn_seed = random_of(seed, Use::turn, turn).next();
  auto search = Search::create(
      std::move(game),
      {.hand = level.hand, .budget = {.simulations = level.simulations}, .seed = turn_seed});
  if (!search) return search.errors();
  return Opponent(std::move(search).value(), level, turn_seed);
}

double Opponent::progress() const {
  if (done()) return 1;
  return std::min(1.0, static_cast<double>(simulated()) / static_cast<double>(level_.simulations));
}

Decision Opponent::decision() const {
  const Shot meant = search_.answer().ranked.front().shot;
  games::Random random = random_of(seed_, Use::hand);
  return {.meant = meant, .drag = launched(drag(meant.aim), level_.hand, random)};
}

}  // namespace search
