#include "search/solver.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "carom/arithmetic.hpp"
#include "replay/recorder.hpp"
#include "search/search.hpp"

namespace search {

namespace {

using games::angry_balls::Next;
using games::angry_balls::Phase;
using games::angry_balls::Throw;
using LevelGame = games::angry_balls::Game;

constexpr std::uint64_t first_tries = 250;  // for each state, in the first round
constexpr std::size_t beam_width = 8;

// Single throws among which to choose: the best that searches with these hands find.
constexpr std::array<double, 4> robust_hands{0, 0.5, 1, 4};  // px
constexpr std::uint64_t robust_tries = 2000;
constexpr std::size_t robust_ways = 8;

/// A state after some throws.
struct Node {
  LevelGame game;
  Throws throws;
};

/// Plays a throw; false once the game is over.
bool play(LevelGame& game, const Aim& aim) {
  if (!game.apply(Throw{drag(aim)})) return false;
  while (game.phase() == Phase::fly) game.run(games::angry_balls::offer_steps);
  return game.phase() == Phase::offer && game.apply(Next{}) && game.phase() == Phase::aim;
}

/// What a search finds, the best first.
std::vector<Ranked> explore(const LevelGame& game, const Hand& hand, std::uint64_t tries,
                            std::size_t shown, Seed seed, carom::Rollouts& rollouts) {
  // The game waits for a throw, and there are simulations.
  Search search =
      Search::create(game,
                     {.hand = hand, .budget = {.simulations = tries, .shown = shown}, .seed = seed})
          .value();
  while (!search.done()) search.advance(tries, rollouts);
  return search.answer().ranked;
}

/// The states after one throw more.
std::vector<Node> next_beam(const std::vector<Node>& beam,
                            const std::vector<std::pair<std::size_t, Ranked>>& ways) {
  std::vector<std::size_t> order(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) order[i] = i;
  const auto left = [&](std::size_t i) {
    return beam[ways[i].first].game.enemies_left() - ways[i].second.fresh.enemies_out;
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  std::vector<Node> next;
  for (const std::size_t i : order) {
    if (next.size() == beam_width) break;
    Node node = beam[ways[i].first];
    const Aim aim = ways[i].second.shot.aim;
    if (!play(node.game, aim)) continue;
    node.throws.push_back(aim);
    next.push_back(std::move(node));
  }
  return next;
}

/// Plays throws on a world; true if they leave no enemy.
bool wins(carom::World& world, carom::Vec2 launch_place, std::span<const Aim> throws) {
  for (std::size_t i = 0; i < throws.size(); ++i) {
    if (i > 0 && !world.place_lead(launch_place)) return false;
    if (simulate(world, {}, drag(throws[i])).cleared) return true;
  }
  return false;
}

/// The margins of a throw, from one state for all that is tried.
class Margins {
 public:
  Margins(const LevelGame& level, const Throws& throws, std::size_t index,
          carom::Rollouts& rollouts)
      : level_(level), throws_(throws), index_(index), rollouts_(rollouts), before_(level) {
    possible_ = std::all_of(throws.begin(), throws.begin() + static_cast<std::ptrdiff_t>(index),
                            [this](const Aim& aim) { return play(before_, aim); });
  }

  /// Of the throw if it were `aim`.
  Margin of(const Aim& aim) {
    if (!possible_) return no_margin;
    for (Margin size = 0; size <= widest_margin; ++size)
      if (!ring_wins(aim, size)) return size - 1;
    return widest_margin;
  }

 private:
  // Every aim whose greatest distance from the middle is `size`.
  bool ring_wins(const Aim& middle, Margin size) {
    ring_.clear();
    for (int turn = -size; turn <= size; ++turn) {
      const bool side = turn == -size || turn == size;
      for (int step = -size; step <= size; step += side || size == 0 ? 1 : 2 * size) {
        const int speed = middle.speed + step * margin_speed;
        if (speed < least_speed || speed > greatest_speed) return false;
        ring_.push_back(turned({.tenths = middle.tenths, .speed = speed}, turn));
      }
    }
    won_.resize(ring_.size());
    rollouts_.run(before_.world(), std::span(won_), [this](carom::World& world, std::size_t k) {
      Throws rest(throws_.begin() + static_cast<std::ptrdiff_t>(index_), throws_.end());
      rest.front() = ring_[k];
      return static_cast<unsigned char>(wins(world, level_.launch_place(), rest));
    });
    return std::ranges::all_of(won_, [](unsigned char won) { return won != 0; });
  }

  const LevelGame& level_;
  const Throws& throws_;
  std::size_t index_;
  carom::Rollouts& rollouts_;
  LevelGame before_;
  bool possible_ = true;
  std::vector<Aim> ring_;
  std::vector<unsigned char> won_;
};

Margin least_margin(const LevelGame& level, const Throws& throws, carom::Rollouts& rollouts) {
  Margin least = widest_margin;
  for (std::size_t i = 0; i < throws.size() && least >= 0; ++i)
    least = std::min(least, margin(level, throws, i, rollouts));
  return least;
}

/// Moves one throw as long as its box grows.
void widen(const LevelGame& level, Throws& throws, std::size_t index, carom::Rollouts& rollouts) {
  Margins margins(level, throws, index, rollouts);
  Aim best = throws[index];
  Margin widest = margins.of(best);
  for (bool moved = true; moved && widest < widest_margin;) {
    moved = false;
    const Aim from = best;
    const int further = std::max(1, widest);
    for (const int turn : {-further, -1, 0, 1, further})
      for (const int step : {-further, -1, 0, 1, further}) {
        Aim aim = turned(from, turn);
        aim.speed = std::clamp(aim.speed + step * margin_speed, least_speed, greatest_speed);
        if (const Margin there = margins.of(aim); there > widest) {
          best = aim;
          widest = there;
          moved = true;
        }
      }
  }
  throws[index] = best;
}

}  // namespace

Solved solve(const LevelGame& level, std::uint64_t simulations, Seed seed,
             carom::Rollouts& rollouts) {
  const carom::ExactArithmetic exact;
  Solved solved;
  for (std::uint64_t round = 0; solved.simulations < simulations; ++round) {
    std::vector<Node> beam{{.game = level, .throws = {}}};
    for (std::uint64_t depth = 0; !beam.empty(); ++depth) {
      std::vector<std::pair<std::size_t, Ranked>> ways;
      for (std::size_t i = 0; i < beam.size(); ++i) {
        const std::uint64_t tries =
            std::min(first_tries << round, simulations - solved.simulations);
        if (tries == 0) break;
        const Seed own = random_of(seed, Use::solving, round, depth * beam_width + i).next();
        for (const Ranked& ranked : explore(beam[i].game, {}, tries, beam_width, own, rollouts)) {
          ways.emplace_back(i, ranked);
          if (ranked.fresh.cleared == 0) continue;
          solved.found.push_back(beam[i].throws);
          solved.found.back().push_back(ranked.shot.aim);
        }
        solved.simulations += tries;
      }
      if (!solved.found.empty()) return solved;
      beam = next_beam(beam, ways);
    }
  }
  return solved;
}

Margin margin(const LevelGame& level, const Throws& throws, std::size_t index,
              carom::Rollouts& rollouts) {
  const carom::ExactArithmetic exact;
  return Margins(level, throws, index, rollouts).of(throws[index]);
}

Throws most_robust(const LevelGame& level, const Solved& solved, Seed seed,
                   carom::Rollouts& rollouts) {
  const carom::ExactArithmetic exact;
  std::vector<Throws> ways = solved.found;
  if (ways.front().size() == 1)
    for (std::size_t i = 0; i < robust_hands.size(); ++i)
      for (const Ranked& ranked :
           explore(level, {robust_hands[i]}, robust_tries, robust_ways,
                   random_of(seed, Use::solving, i, robust_tries).next(), rollouts))
        ways.push_back({ranked.shot.aim});
  Throws best;
  Margin widest = no_margin;
  for (Throws& way : ways) {
    for (std::size_t i = 0; i < way.size(); ++i) widen(level, way, i, rollouts);
    const Margin least = least_margin(level, way, rollouts);
    if (least <= widest) continue;
    widest = least;
    best = std::move(way);
  }
  return best;
}

replay::Replay replay_of(const LevelGame& level, const Throws& throws) {
  replay::Recorder<LevelGame> recorder(level);
  for (const Aim& aim : throws) {
    if (recorder.game().phase() == Phase::offer && !recorder.apply(Next{})) break;
    if (!recorder.apply(Throw{drag(aim)})) break;
    while (recorder.game().phase() == Phase::fly) recorder.step();
  }
  return recorder.replay();
}

}  // namespace search
