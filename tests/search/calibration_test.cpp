#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <vector>

#include "search/match.hpp"
#include "search/search.hpp"

namespace {

struct Hinted {
  double predicted = 0;  ///< probability to score
  int scored = 0;        ///< of shots_each
};

constexpr int hints = 1000;
constexpr int shots_each = 10;

/// Hints at the tables of a game between middling players, each for a hand of 0.5 to 15 px, and
/// shots played by them.
std::vector<Hinted> play_hints() {
  using games::billiards::Phase;
  carom::Rollouts rollouts(1);
  std::vector<Hinted> all;
  games::billiards::Game game;
  for (std::uint64_t i = 0; i < hints; ++i) {
    if (game.phase() == Phase::over) game = games::billiards::Game();
    const search::Hand hand{.error = 0.5 * static_cast<double>(i % 30 + 1)};
    search::Search search =
        search::Search::create(
            game, {.hand = hand, .budget = {.simulations = 60, .fresh = 1000}, .seed = i})
            .value();
    while (!search.done()) search.advance(1000, rollouts);
    const search::Ranked hint = search.answer().ranked.front();
    Hinted hinted{.predicted = hint.fresh.scored_estimate().mean};
    games::Random random(1'000'000 + i);  // none of the search's
    carom::Vec2 drag{};
    for (int shot = 0; shot < shots_each; ++shot) {
      carom::World world = game.world();
      drag = search::launched(search::drag(hint.shot.aim), hand, random);
      hinted.scored += search::simulate(world, hint.shot.place, drag).points > 0 ? 1 : 0;
    }
    all.push_back(hinted);
    if (hint.shot.place) (void)game.apply(games::billiards::Place{*hint.shot.place});
    (void)game.apply(games::billiards::Shoot{drag});
    while (game.phase() == Phase::roll) game.step();
  }
  return all;
}

TEST(CalibrationSlow, OfTenThousandHintedShots_ScoreAsOftenAsPredictedInEveryDecile) {
  std::vector<Hinted> all = play_hints();
  std::ranges::stable_sort(all, {}, &Hinted::predicted);
  std::puts("decile  predicted  scored");
  constexpr std::size_t deciles = 10;
  constexpr std::size_t each = hints / deciles;
  for (std::size_t decile = 0; decile < deciles; ++decile) {
    double predicted = 0;
    double scored = 0;
    double variance = 0;
    for (std::size_t i = decile * each; i < (decile + 1) * each; ++i) {
      predicted += all[i].predicted / each;
      scored += static_cast<double>(all[i].scored) / (shots_each * each);
      variance += all[i].predicted * (1 - all[i].predicted) / (shots_each * each * each);
    }
    std::printf("%6zu  %8.1f %%  %5.1f %%\n", decile + 1, 100 * predicted, 100 * scored);
    EXPECT_NEAR(scored, predicted, std::max(0.03, 3 * std::sqrt(variance))) << decile + 1;
  }
}

}  // namespace
