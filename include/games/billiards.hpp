#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "carom/event.hpp"
#include "carom/public.hpp"
#include "carom/result.hpp"
#include "carom/scene.hpp"
#include "carom/vec2.hpp"
#include "carom/world.hpp"
#include "games/launch.hpp"

/// Billiards for two (§1.4, docs/physics.md#billiards): a state machine. Commands go in by apply(),
/// time by step(); state and events come out. A table is any scene with a cue ball; all its other
/// balls count as reds.
namespace games {
namespace CAROM_PUBLIC billiards {

/// The reds at the start, in a triangle.
enum class Rack : std::uint8_t {
  classic,  ///< 36 in 8 rows (§1.4.2)
  quick,    ///< 15 in 5 rows
};
constexpr int rows_of(Rack rack) { return rack == Rack::quick ? 5 : 8; }
constexpr int reds_of(Rack rack) { return rows_of(rack) * (rows_of(rack) + 1) / 2; }

inline constexpr int reds = reds_of(Rack::classic);
inline constexpr int rows = rows_of(Rack::classic);
inline constexpr carom::Vec2 cue_start{200, 200};   ///< px
inline constexpr carom::Vec2 apex_start{540, 200};  ///< px, the red nearest the cue ball

/// A turn that still runs after this many steps (2 simulated minutes) ends as if all stood.
/// Friction ends every turn seen long before; this is the promise that no turn can hang.
inline constexpr std::uint64_t max_turn_steps = 12'000;

/// The table at the start: 800 × 400 px, six holes, the rack, the cue ball
/// (docs/physics.md#billiards).
carom::Scene rack(Rack kind = Rack::classic);

/// Returns why a sound scene cannot be a table: it has no cue ball. Empty if it can.
carom::Errors check_table(const carom::Scene& scene);

/// Options that players agree on before a game. The defaults are the report's game.
struct Options {
  int first_player = 0;  ///< who has the first turn, 0 or 1; any other number means 0
  bool keep_turn =
      false;  ///< house rule: who scores has the next turn too, unless the cue ball fell
  /// House rule: after a shot that touches no red the other player has the cue ball in hand.
  bool touch_red = false;
  Rack rack = Rack::classic;  ///< of a game that starts from the rack
  bool alone = false;         ///< the first player has every turn
  friend bool operator==(const Options&, const Options&) = default;
};

enum class Phase : std::uint8_t {
  aim,    ///< waiting for Shoot
  roll,   ///< balls in motion: step() is all there is to do
  place,  ///< the cue ball is in hand: waiting for Place; the others wait with their speeds
  over,   ///< only the cue ball is left
};

/// Launches the cue ball. `drag` (px): from the first click to the second (launch_velocity).
struct Shoot {
  carom::Vec2 drag;
  /// By the velocity (px/s) that it gives (launch_drag).
  static Shoot at(carom::Vec2 velocity) { return {launch_drag(velocity)}; }
  friend bool operator==(const Shoot&, const Shoot&) = default;
};
/// Puts the cue ball in hand down. `position`: px.
struct Place {
  carom::Vec2 position;
  friend bool operator==(const Place&, const Place&) = default;
};
/// A new game from the same start with the same options, at any time.
struct Restart {};
using Command = std::variant<Shoot, Place, Restart>;

/// Why the cue ball may not be placed somewhere. An obstacle is a cushion, too.
enum class Obstruction : std::uint8_t { none, ball, hole, cushion };

enum class EventKind : std::uint8_t {
  scored,        ///< `player` pocketed red `ball` for `points`
  cue_pocketed,  ///< or it left by an open side: `player`'s turn ends; the next one has it in hand
  missed,        ///< it touched no red, which Options::touch_red forbids: the same follows
  turn,          ///< the next turn begins: `player` is on
  over,          ///< the game has ended
};

struct Event {
  EventKind kind = EventKind::turn;
  int player = 0;           ///< 0 or 1
  std::uint32_t ball = 0;   ///< scored: the red's id
  std::int64_t points = 0;  ///< scored
  friend bool operator==(const Event&, const Event&) = default;
};

/// A player's figures in a game so far.
struct Tally {
  int balls = 0;               ///< reds pocketed
  std::int64_t best_turn = 0;  ///< the most points made in one turn
  int shots = 0;               ///< the one whose balls still roll included
  int fouls = 0;               ///< turns that gave the cue ball away
  friend bool operator==(const Tally&, const Tally&) = default;
};

class Game {
 public:
  /// A game from the rack.
  explicit Game(Options options = {});

  /// A game from any table, which waits with the speeds it has for the first shot. It is over at
  /// once if there is only the cue ball. Refuses what carom::check or check_table finds wrong.
  static carom::Result<Game> create(carom::Scene table, Options options = {});

  /// Refuses, changing nothing, what the phase does not allow: Shoot outside aim or with a drag
  /// that is zero or not finite; Place outside place or where obstruction() is not none.
  carom::Status apply(const Command& command);

  /// Advances by carom::time_step in phase roll; otherwise does nothing. Afterwards
  /// physics_events() and events() tell what happened, as after apply().
  void step();
  /// Takes steps as step() does, with the same bits, at most `most`, and much quicker than one by
  /// one; ends after the first of which events() has something to tell. Returns the number taken: 0
  /// where step() would do nothing. Afterwards events() and physics_events() are the last step's.
  std::uint64_t run(std::uint64_t most);

  /// Returns the obstacle to the cue ball at `position` (px): it must overlap no ball, no hole
  /// and no cushion, nor stick out of an open side (docs/physics.md#billiards). A position that is
  /// not finite gives cushion.
  Obstruction obstruction(carom::Vec2 position) const;

  /// The game as bytes (docs/formats.md#states): load_state makes a game of it that goes on with
  /// the same bits. Its events are not part of it.
  std::string save_state() const;
  /// Refuses bytes that are no state of such a game, were changed, or are of other physics or
  /// rules.
  static carom::Result<Game> load_state(std::string_view state);

  const Options& options() const { return options_; }
  Phase phase() const { return phase_; }
  const carom::World& world() const { return world_; }
  int player() const { return player_; }  ///< who is on: 0 or 1
  std::int64_t score(int player) const { return scores_[static_cast<std::size_t>(player)]; }
  int turn_balls() const { return turn_balls_; }             ///< reds pocketed in this turn
  std::int64_t turn_points() const { return turn_points_; }  ///< points made in this turn
  int reds_left() const;
  /// `player`: 0 or 1.
  const Tally& tally(int player) const { return tallies_[static_cast<std::size_t>(player)]; }
  /// Once over: who won; none for a draw (and before the end).
  std::optional<int> winner() const;

  /// Events of the last step() or of the last command that was taken: the world's, which a command
  /// has none of, and what the rules made of them.
  std::span<const carom::Event> physics_events() const { return physics_; }
  std::span<const Event> events() const { return events_; }

 private:
  Game(std::shared_ptr<const carom::World> start, Options options);
  carom::Status shoot(carom::Vec2 drag);
  carom::Status place(carom::Vec2 position);
  void end_turn();
  void score_pocketed(std::span<const std::uint32_t> ids_by_index);
  void pass_turn(int next);
  int other_player() const { return options_.alone ? player_ : 1 - player_; }
  Tally& tally() { return tallies_[static_cast<std::size_t>(player_)]; }

  std::shared_ptr<const carom::World> start_;  ///< shared by all copies of the game
  carom::World world_;
  Options options_;
  Phase phase_ = Phase::aim;
  int player_ = 0;
  std::array<std::int64_t, 2> scores_{};
  std::array<Tally, 2> tallies_{};
  int turn_balls_ = 0;
  std::int64_t turn_points_ = 0;
  std::uint64_t turn_steps_ = 0;
  bool touched_red_ = false;  ///< in this turn
  std::vector<carom::Event> physics_;
  std::vector<Event> events_;
};

}  // namespace billiards
}  // namespace games
