#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "carom/scene.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "games/random.hpp"
#include "replay/replay.hpp"

/// Random games, played with every invariant checked after every step.
namespace soak {

/// A level that can be played, whatever it is worth as one: any edges, obstacles, holes, balls.
carom::Scene random_level(games::Random& random);

/// Next command of a player without a plan: any drag, any free place. None while he has to wait, or
/// wants to, and when the game is over.
std::optional<games::billiards::Command> random_command(const games::billiards::Game& game,
                                                        games::Random& random);
std::optional<games::angry_balls::Command> random_command(const games::angry_balls::Game& game,
                                                          games::Random& random);

struct PlayedGame {
  replay::Replay replay;
  std::size_t turns = 0;
  std::uint64_t steps = 0;
  std::uint64_t longest_turn = 0;  ///< steps
  std::size_t text_size = 0;       ///< characters of the replay as text
  std::string failure;             ///< the first invariant that did not hold; empty: all did
};

/// Plays a whole game and checks: the Invariants after every step; that the quadtree and testing
/// all pairs give the same states; then that its replay, written as JSON, read, written as text and
/// read again, is the same and verifies. The seed determines all of it, the options
/// of billiards too.
PlayedGame play_random_game(std::uint64_t seed, replay::Kind kind);

}  // namespace soak
