#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "games/random.hpp"
#include "replay/games.hpp"
#include "soak/random_game.hpp"

namespace recorded {

/// A replay that is sound as data, though hardly one of a game: any finite numbers, any hashes.
inline replay::Replay random_replay(std::uint64_t seed) {
  games::Random random(seed);
  const auto number = [&] {
    if (random.one_in(2)) return std::floor(random.uniform(-60'000, 60'000)) / 64;
    double any = 0;
    do any = std::bit_cast<double>(random.next());
    while (!std::isfinite(any) || any == 0);
    return any;
  };
  replay::Replay replay;
  const bool billiards = random.one_in(2);
  replay.score = {static_cast<int>(random.below(5000)),
                  billiards ? static_cast<int>(random.below(5000)) : 0};
  if (billiards && random.one_in(2))
    replay.options = {.first_player = static_cast<int>(random.below(2)),
                      .keep_turn = random.one_in(2)};
  if (billiards && random.one_in(2)) {  // version 2
    replay.options.touch_red = random.one_in(2);
    replay.options.rack = static_cast<games::billiards::Rack>(random.below(2));
    replay.options.alone = random.one_in(4);
    replay.occasion = {.computer = {static_cast<int>(random.below(11)), 0},
                       .seed = random.next() & replay::most_mark,
                       .best_of = 1 + 2 * static_cast<int>(random.below(3)),
                       .duel = random.one_in(2) ? random.next() & replay::most_mark : 0};
    replay.occasion.won[1] = static_cast<int>(random.below(2)) * (replay.occasion.best_of / 2);
  }
  if (!billiards) {
    do replay.level = soak::random_level(random);
    while (!games::angry_balls::Game::create(*replay.level));
  }
  for (auto count = random.below(12); count > 0; --count) {
    replay::Move move{.hash = random.next()};
    const carom::Vec2 place{number(), number()};
    const bool first = random.one_in(2);
    if (first) move.steps = random.below(replay::max_move_steps / 4);
    if (billiards)
      move.command = first ? replay::Command(games::billiards::Shoot{place})
                           : replay::Command(games::billiards::Place{place});
    else
      move.command = first ? replay::Command(games::angry_balls::Throw{place})
                           : replay::Command(games::angry_balls::Next{});
    replay.moves.push_back(move);
  }
  return replay;
}

}  // namespace recorded
