#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "carom/result.hpp"
#include "carom/scene.hpp"
#include "carom/version.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"

/// Games written down as what the players did. The same start, the same commands and the same
/// numbers of steps between them give the same game, bit by bit.
namespace replay {

// A replay is of these, and no other.
using carom::physics_version;
using carom::rules_version;

// Limits of what is accepted; anything beyond is refused. They hold back texts that are not games,
// and games that would take hours to play.
inline constexpr std::size_t max_bytes = 4 << 20;         ///< of a file or of an unpacked text
inline constexpr std::size_t max_moves = 10'000;          ///< of a game
inline constexpr std::uint64_t max_move_steps = 360'000;  ///< after one command: an hour
inline constexpr std::uint64_t max_steps = 2'000'000;     ///< of a game: five and a half hours
/// Of a player, exact in binary64 too. The greatest world, of 10 million balls, gives 5.0e15.
inline constexpr std::int64_t max_score = (std::int64_t{1} << 53) - 1;

enum class Kind : std::uint8_t { billiards, angry_balls };

/// A command of a player. A game that starts again is another replay.
using Command = std::variant<games::billiards::Shoot, games::billiards::Place,
                             games::angry_balls::Throw, games::angry_balls::Next>;

/// A command and what came of it.
struct Move {
  Command command{};
  /// Steps of the world after the command, until the next one was given or, for the last, until
  /// the replay was taken. 0 for Place and Next, after which all stands still.
  std::uint64_t steps = 0;
  std::uint64_t hash = 0;  ///< World::state_hash() after these steps

  friend bool operator==(const Move&, const Move&) = default;
};

inline constexpr int most_computer = 10;  ///< the strongest computer player
inline constexpr int most_games = 5;      ///< of a match
inline constexpr std::uint64_t most_mark = (std::uint64_t{1} << 53) - 1;  ///< exact in binary64

/// What a game of billiards is played for, and by whom. The rules do not ask.
struct Occasion {
  /// The level of the computer that plays for a player, 1 to most_computer; 0: a person plays.
  std::array<int, 2> computer{};
  std::uint64_t seed = 0;    ///< of all that a computer does, up to most_mark
  int best_of = 1;           ///< games of the match that this is one of: 1, 3 or 5
  std::array<int, 2> won{};  ///< of the match before this game, by each player
  std::uint64_t duel = 0;    ///< the same in all games that are compared; 0: in none
  friend bool operator==(const Occasion&, const Occasion&) = default;
};

/// A game from its start to its end, or to where it was left.
struct Replay {
  std::optional<carom::Scene> level{};  ///< Angry Balls: the level as at the start; none: billiards
  games::billiards::Options options{};  ///< billiards: what was agreed on; otherwise the default
  Occasion occasion{};                  ///< billiards; otherwise the default
  std::vector<Move> moves{};            ///< in their order
  /// Points at the end: of both players of billiards; in Angry Balls the second is 0.
  std::array<std::int64_t, 2> score{};
  /// Every hash but the last move's is known by its lowest 8 bits only, the others being 0: so it
  /// is read from a text. with_full_hashes() fills them in.
  bool short_hashes = false;

  Kind kind() const { return level ? Kind::angry_balls : Kind::billiards; }

  friend bool operator==(const Replay&, const Replay&) = default;
};

/// The bits of a move's hash that a replay with short hashes knows.
inline constexpr std::uint64_t short_hash_mask = 0xff;

/// All that is wrong with a replay as data (pointers as in its file): a level that is none,
/// options or
/// commands of the other game, numbers that are not finite or negative, more than the limits allow.
/// Empty when it is sound. Whether the game went that way only playing tells.
carom::Errors check(const Replay& replay);

}  // namespace replay
