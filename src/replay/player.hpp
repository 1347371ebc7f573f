#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/result.hpp"
#include "replay/any_game.hpp"
#include "replay/replay.hpp"

namespace replay {

/// A turn of a replay: one shot with the placement before it, or one throw with the Next after it.
struct Turn {
  std::size_t first_move = 0;    ///< index in Replay::moves
  std::uint64_t first_step = 0;  ///< steps of the game before the turn
  std::uint64_t steps = 0;       ///< steps of the turn
  // These are known once the look-ahead has reached the turn, and final once it has passed it.
  int player = 0;                       ///< billiards: who plays it, 0 or 1
  std::int64_t points = 0;              ///< made in it
  std::array<std::int64_t, 2> score{};  ///< after it, as in Replay::score
};

/// Where a game left the way that its replay tells.
struct Divergence {
  std::size_t turn = 0;  ///< index in Player::turns()
  /// The steps, counted from the start of the game, after which it was still right and already
  /// wrong.
  std::uint64_t first_step = 0;
  std::uint64_t last_step = 0;
  std::string expected{};  ///< what the replay says: "hash 0123456789abcdef"
  std::string got{};       ///< what playing gives
};

/// "diverged in turn 7, steps 188 to 214: expected …, got …"; `turns`: how many the replay has, if
/// known, else 0.
std::string to_string(const Divergence& divergence, std::size_t turns);

/// Result of a part of the way to a turn.
enum class Sought : std::uint8_t {
  shown,    ///< there now
  on_way,   ///< go on; what is shown has not changed
  nowhere,  ///< there is no such turn, or the game diverges before it; nothing has changed
};

/// Plays a replay: shows the game at any step, and goes to any turn at once. It looks ahead of what
/// it shows; what the look-ahead has passed is verified.
class Player {
 public:
  /// Refuses what check() finds wrong.
  static carom::Result<Player> create(Replay replay);

  const Replay& replay() const { return replay_; }

  /// The game as it is shown, first at its start. Its events are those of the last step().
  const AnyGame& game() const { return shown_.game; }
  std::uint64_t steps() const { return shown_.step; }  ///< of the world since the start
  /// The turn that is shown, an index in turns(): between two the one that comes. 0 if there are
  /// none.
  std::size_t turn() const;

  /// Gives the commands that are due and takes the step after them; the last commands of a replay
  /// may have none. False, and nothing has changed, at the end and where the game diverges.
  bool step();

  /// Shows the start of a turn, before anything is done in it; turns().size() is the end of what
  /// can be played. Looks ahead as far as needed. False, and nothing has changed, where there is no
  /// such turn.
  bool seek(std::size_t turn);
  /// The same in parts, of at most this many steps: to be called again until it is there. To ask
  /// for another turn in between is fine.
  Sought seek(std::size_t turn, std::uint64_t steps);

  /// Looks ahead by this many steps, each command counted as one. False when that reached the end,
  /// or the divergence.
  bool look_ahead(std::uint64_t steps);

  /// All turns of the replay; from reached_turns() on without player, points and score.
  const std::vector<Turn>& turns() const { return turns_; }
  std::size_t reached_turns() const { return reached_turns_; }
  /// Known once the look-ahead has met it: nothing is shown beyond it.
  const std::optional<Divergence>& divergence() const { return divergence_; }

  /// The replay with all bits of all hashes. Only once the look-ahead has reached the end without
  /// divergence.
  Replay with_full_hashes() const;

 private:
  struct Moment {
    AnyGame game;
    std::size_t move = 0;         // the next command
    std::uint64_t steps_due = 0;  // before it
    std::uint64_t step = 0;       // of the world since the start

    // Commands and steps, counted together, are the time of a replay.
    std::uint64_t time() const { return move + step; }
  };

  Player(Replay replay, AnyGame game);
  bool at_end(const Moment& moment) const;
  bool advance_ahead(std::uint64_t most);
  void advance(Moment& moment, std::uint64_t most) const;
  void keep();
  void begin_turn();
  void compare();
  void diverge(std::string expected, std::string got);

  Replay replay_;
  std::vector<Turn> turns_;
  std::size_t reached_turns_ = 0;
  Moment shown_;
  Moment ahead_;
  std::vector<Moment> kept_;      // at the starts of the turns 0, kept_each_, 2·kept_each_, …
  std::size_t kept_each_ = 1;     // doubled when there are too many
  std::size_t kept_things_ = 0;   // in all of them
  std::optional<Moment> sought_;  // on the way to the start of a turn
  std::size_t sought_turn_ = 0;
  std::vector<std::uint64_t> hashes_;  // after each move that the look-ahead has passed
  std::uint64_t right_step_ = 0;       // ahead_.step when it was last found right
  std::optional<Divergence> divergence_;
};

/// Plays a replay to its end or divergence; then turns() and divergence() tell. Refuses what
/// check() finds wrong.
carom::Result<Player> verify(Replay replay);

/// The same replay with all bits of all hashes. Refuses what check() finds wrong, and what
/// diverges.
carom::Result<Replay> with_full_hashes(Replay replay);

}  // namespace replay
