#include "search/review.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "carom/arithmetic.hpp"

namespace search {

namespace {

/// The game's own word on whether the turn can be played.
carom::Status check_turn(Game game, const PlayedTurn& turn) {
  if (auto* table = std::get_if<games::billiards::Game>(&game)) {
    if (turn.place)
      if (carom::Status placed = table->apply(games::billiards::Place{*turn.place}); !placed)
        return placed;
    return table->apply(games::billiards::Shoot{turn.drag});
  }
  return std::get<games::angry_balls::Game>(game).apply(games::angry_balls::Throw{turn.drag});
}

}  // namespace

double TurnReview::decision() const { return std::max(0.0, best_value.mean - played_value.mean); }

double TurnReview::luck() const { return static_cast<double>(made) - played_value.mean; }

carom::Result<Reviewing> Reviewing::create(Game before, const PlayedTurn& turn,
                                           const Question& question) {
  if (question.budget.fresh == 0)
    return carom::Error{
        .pointer = "budget", .problem = "is wrong", .expected = "at least 1 fresh simulation"};
  if (const carom::Status taken = check_turn(before, turn); !taken) return taken.errors();
  carom::World world = world_of(before);
  const Trial made = simulate(world, turn.place, turn.drag);
  auto search = Search::create(std::move(before), question);
  if (!search) return search.errors();
  return Reviewing(std::move(search).value(), turn, question, made);
}

Reviewing::Reviewing(Search search, const PlayedTurn& turn, const Question& question, Trial made)
    : search_(std::move(search)), turn_(turn), question_(question), made_(made) {
  if (!question.hand.exact()) due_ = question.budget.fresh;
}

void Reviewing::advance(std::uint64_t simulations, carom::Rollouts& rollouts) {
  const carom::ExactArithmetic exact;
  const std::uint64_t before = search_.simulated();
  search_.advance(simulations, rollouts);
  simulations -= search_.simulated() - before;
  while (simulations > 0 && !done()) {
    const std::uint64_t now = std::min({simulations, due_ - played_.n, most_at_once});
    trials_.resize(static_cast<std::size_t>(now));
    rollouts.run(
        world_of(search_.game()), std::span(trials_), [this](carom::World& world, std::size_t k) {
          games::Random random = random_of(question_.seed, Use::played, 0, played_.n + k);
          return simulate(world, turn_.place, launched(turn_.drag, question_.hand, random));
        });
    for (const Trial& trial : trials_) played_.add(trial);
    simulations -= now;
  }
}

Estimate Reviewing::value(const Record& record) const {
  return std::holds_alternative<games::billiards::Game>(search_.game()) ? record.points_estimate()
                                                                        : record.enemies_estimate();
}

TurnReview Reviewing::review() const {
  const Ranked best = search_.answer().ranked.front();
  const bool table = std::holds_alternative<games::billiards::Game>(search_.game());
  return {.best = best.shot,
          .best_value = value(best.fresh),
          .played_value = value(played_),
          .made = table ? made_.points : std::int64_t{made_.enemies_out}};
}

}  // namespace search
