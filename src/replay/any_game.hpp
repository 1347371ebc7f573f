#pragma once

#include <array>
#include <variant>

#include "carom/result.hpp"
#include "carom/world.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "replay/replay.hpp"

namespace replay {

/// A game of either kind. A plain value, like both: a copy keeps the state.
using AnyGame = std::variant<games::billiards::Game, games::angry_balls::Game>;

/// The game at the start of a replay. Refuses a level that is none.
carom::Result<AnyGame> start(const Replay& replay);

/// Refuses what the game's phase does not allow, and commands of the other game.
carom::Status apply_command(AnyGame& game, const Command& command);

/// One step of the world; nothing while it stands still.
void step(AnyGame& game);
/// At most `most` steps, up to the first of which the rules have something to tell; how many.
std::uint64_t run(AnyGame& game, std::uint64_t most);

const carom::World& world(const AnyGame& game);

/// Is true if step() moves the world on: a ball rolls or flies, or a level waits for Next.
bool moves(const games::billiards::Game& game);
bool moves(const games::angry_balls::Game& game);
bool moves(const AnyGame& game);

/// Is true if the game has come to its end.
bool over(const games::billiards::Game& game);
bool over(const games::angry_balls::Game& game);
bool over(const AnyGame& game);

/// Points so far, as in Replay::score.
std::array<std::int64_t, 2> score(const games::billiards::Game& game);
std::array<std::int64_t, 2> score(const games::angry_balls::Game& game);
std::array<std::int64_t, 2> score(const AnyGame& game);

}  // namespace replay
