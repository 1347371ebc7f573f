#include "app/play/hint.hpp"

#include <utility>

#include "app/play/computer_turn.hpp"
#include "app/play/preview.hpp"

namespace app {
namespace {

constexpr std::uint64_t tried = 800;    // simulations
constexpr std::uint64_t fresh = 1'000;  // for the odds that are told

}  // namespace

std::optional<Hint> Hint::begin(search::Game game, double error) {
  const search::Seed seed = search::world_of(game).state_hash();
  auto search = search::Search::create(
      std::move(game),
      {.hand = {error}, .budget = {.simulations = tried, .fresh = fresh}, .seed = seed});
  if (!search) return std::nullopt;
  return Hint(std::move(search).value(), error);
}

void Hint::advance(nanoseconds elapsed, carom::Rollouts& rollouts) {
  if (!searching()) return;
  const carom::World& world = search::world_of(search_.game());
  search_.advance(simulations_of_frame(world, elapsed), rollouts);
  if (searching()) return;
  shot_ = search_.answer().ranked.front();
  const Preview preview =
      look_ahead(world, search::drag(shot_->shot.aim), PreviewLength::contact, full_steps);
  if (preview.ghost) ball_ = preview.target_ball;
}

void Hint::more() {
  if (!searching() && step_ != Step::aim) step_ = static_cast<Step>(static_cast<int>(step_) + 1);
}

Aim Hint::aim() const {
  Aim aim;
  aim.set(search::drag(shot_->shot.aim));
  return aim;
}

}  // namespace app
