#include "app/play/computer_turn.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace app {
namespace {

using Seconds = std::chrono::duration<double>;

// A simulation takes about the square of the number of balls: these are some milliseconds of one
// core, 14 at the rack, and in a browser ten.
constexpr std::uint64_t squares_of_frame = 20'000;
constexpr std::uint64_t fewest = 2;
constexpr std::uint64_t most = 200;
constexpr nanoseconds usual_frame = milliseconds{16};
constexpr int longest_frame = 3;  ///< usual ones

constexpr double swing = 0.35;      ///< radians, to each side
constexpr double swing_rate = 3.2;  ///< radians a second, of its phase
constexpr double near = 6;          ///< px, of the tip from the ball
constexpr double far = 40;

carom::Vec2 turned(carom::Vec2 way, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  return {way.x * c - way.y * s, way.x * s + way.y * c};
}

/// Towards the middle of what is to be hit.
carom::Vec2 way_to_balls(const carom::World& world) {
  carom::Vec2 sum;
  for (std::size_t i = 1; i < world.size(); ++i)
    if (world.in_play(i)) sum = sum + (world.ball(i).position - world.ball(0).position);
  return carom::length(sum) > 0 ? carom::unit(sum) : carom::Vec2{1, 0};
}

}  // namespace

std::uint64_t simulations_of_frame(const carom::World& world, nanoseconds elapsed) {
  std::uint64_t balls = 0;
  for (std::size_t i = 0; i < world.size(); ++i) balls += world.in_play(i) ? 1 : 0;
  const std::uint64_t usual =
      std::clamp(squares_of_frame / std::max<std::uint64_t>(balls * balls, 1), fewest, most);
  const auto longer = std::clamp<nanoseconds::rep>(elapsed / usual_frame, 1, longest_frame);
  return usual * static_cast<std::uint64_t>(longer);
}

std::optional<ComputerTurn> ComputerTurn::begin(const games::billiards::Game& game,
                                                const replay::Occasion& occasion) {
  const int level = occasion.computer[static_cast<std::size_t>(game.player())];
  if (level == 0) return std::nullopt;
  const int shots = game.tally(0).shots + game.tally(1).shots;
  auto opponent = search::Opponent::create(
      game, search::levels[static_cast<std::size_t>(level - 1)],
      search::player_seed(occasion.seed, game.player()), static_cast<std::uint64_t>(shots));
  if (!opponent) return std::nullopt;
  return ComputerTurn(game, std::move(opponent).value());
}

void ComputerTurn::advance(nanoseconds elapsed, carom::Rollouts& rollouts) {
  if (decision_) {
    aimed_ += elapsed;
    return;
  }
  thought_ += elapsed;
  opponent_.advance(simulations_of_frame(world(), elapsed), rollouts);
  if (!opponent_.done() || thought_ < least_thought) return;
  decision_ = opponent_.decision();
  // The search tried it on this very table.
  if (decision_->meant.place)
    static_cast<void>(game_.apply(games::billiards::Place{*decision_->meant.place}));
}

std::optional<ComputerTurn::Cue> ComputerTurn::cue() const {
  if (game_.phase() != games::billiards::Phase::aim) return std::nullopt;
  const double phase = swing_rate * Seconds(thought_).count();
  const carom::Vec2 idle = turned(way_to_balls(world()), swing * std::sin(phase));
  if (!decision_) return Cue{idle, (near + far) / 2 + 4 * std::sin(2 * phase)};
  // It turns to where it will shoot, goes back and comes down.
  const double done = std::min(Seconds(aimed_).count() / Seconds(aim_time).count(), 1.0);
  const carom::Vec2 meant = carom::unit(search::drag(decision_->meant.aim));
  const double left = std::max(1 - 2.5 * done, 0.0);
  const carom::Vec2 mixed = meant + left * (idle - meant);
  const carom::Vec2 way = carom::length(mixed) > 0 ? carom::unit(mixed) : meant;
  const double back =
      done < 0.85 ? near + (far - near) * done / 0.85 : near + (far - near) * (1 - done) / 0.15;
  return Cue{way, back};
}

}  // namespace app
