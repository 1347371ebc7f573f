#include "app/play/game_review.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/play/computer_turn.hpp"

namespace app {
namespace {

// Simulations.
constexpr std::uint64_t tried = 300;
constexpr std::uint64_t fresh = 300;

}  // namespace

std::optional<GameReview> GameReview::begin(replay::Replay replay, double error) {
  if (replay.level) return std::nullopt;
  auto player = replay::Player::create(std::move(replay));
  if (!player) return std::nullopt;
  return GameReview(std::move(player).value(), error);
}

void GameReview::advance(nanoseconds elapsed, std::uint64_t steps, carom::Rollouts& rollouts) {
  if (done()) return;
  if (!reviewing_) {
    const replay::Sought sought = player_.seek(shots_.size(), steps);
    if (sought == replay::Sought::on_way) return;
    stuck_ = sought == replay::Sought::nowhere;
    if (!stuck_) begin_shot();
    return;
  }
  reviewing_->advance(simulations_of_frame(replay::world(player_.game()), elapsed), rollouts);
  if (!reviewing_->done()) return;
  const auto& game = std::get<games::billiards::Game>(player_.game());
  shots_.push_back({game.player(), reviewing_->review()});
  reviewing_.reset();
}

void GameReview::begin_shot() {
  const auto& game = std::get<games::billiards::Game>(player_.game());
  const auto& moves = player_.replay().moves;
  search::PlayedTurn turn;
  std::size_t move = player_.turns()[shots_.size()].first_move;
  if (const auto* place = std::get_if<games::billiards::Place>(&moves[move].command)) {
    turn.place = place->position;
    ++move;
  }
  const auto* shot =
      move < moves.size() ? std::get_if<games::billiards::Shoot>(&moves[move].command) : nullptr;
  stuck_ = !shot;  // a ball that was put down and never shot
  if (!shot) return;
  turn.drag = shot->drag;
  const int level = player_.replay().occasion.computer[static_cast<std::size_t>(game.player())];
  const double error =
      level > 0 ? search::levels[static_cast<std::size_t>(level - 1)].hand.error : error_;
  auto reviewing = search::Reviewing::create(game, turn,
                                             {.hand = {error},
                                              .budget = {.simulations = tried, .fresh = fresh},
                                              .seed = game.world().state_hash()});
  stuck_ = !reviewing;
  if (reviewing) reviewing_.emplace(std::move(reviewing).value());
}

std::vector<std::size_t> GameReview::costliest(std::size_t most) const {
  std::vector<std::size_t> order(shots_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return shots_[i].review.decision() < 1; });
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return shots_[a].review.decision() > shots_[b].review.decision();
  });
  if (order.size() > most) order.resize(most);
  return order;
}

}  // namespace app
