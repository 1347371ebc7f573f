#pragma once

#include <cstdint>
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

/// Angry Balls (§2.3, docs/physics.md#angry-balls): a state machine like billiards. A level is a
/// scene with a projectile and at least one enemy; the projectile's place in it is the launch
/// place.
namespace games {
namespace CAROM_PUBLIC angry_balls {

/// After this many steps (30 simulated seconds) the next throw is offered, whatever still moves.
inline constexpr std::uint64_t offer_steps = 3000;

enum class Phase : std::uint8_t {
  aim,    ///< waiting for Throw; the level stands still
  fly,    ///< the level moves
  offer,  ///< it goes on moving, and Next is allowed
  won,    ///< no enemy is left
  lost,   ///< the last throw is over, and an enemy is left
};

/// Throws the projectile. `drag` (px): from the first click to the second (launch_velocity).
struct Throw {
  carom::Vec2 drag;
  /// By the velocity (px/s) that it gives (launch_drag).
  static Throw at(carom::Vec2 velocity) { return {launch_drag(velocity)}; }
  friend bool operator==(const Throw&, const Throw&) = default;
};
/// Ends the turn. The projectile is back at the launch place, or the level lost after the last
/// throw.
struct Next {
  friend bool operator==(const Next&, const Next&) = default;
};
/// The level from its start, at any time.
struct Restart {};
using Command = std::variant<Throw, Next, Restart>;

enum class EventKind : std::uint8_t {
  scored,   ///< `ball` was destroyed, or left the level, for `points`
  offered,  ///< Next is allowed from now on
  won,
  lost,
};

struct Event {
  EventKind kind = EventKind::scored;
  std::uint32_t ball = 0;   ///< scored: its id
  std::int64_t points = 0;  ///< scored
  carom::Vec2 position{};   ///< scored: px, where the ball was last
  friend bool operator==(const Event&, const Event&) = default;
};

/// Returns why a sound scene cannot be a level: no projectile, no enemy. Empty if it can.
carom::Errors check_level(const carom::Scene& scene);

/// carom::read_scene for a level: refuses what check_level finds, too.
carom::Result<carom::Scene> read_level(std::string_view json);

class Game {
 public:
  /// Refuses what carom::check or check_level finds wrong.
  static carom::Result<Game> create(carom::Scene level);

  /// Refuses, changing nothing, what the phase does not allow, and a drag that is zero or not
  /// finite.
  carom::Status apply(const Command& command);

  /// Advances by carom::time_step in phases fly and offer; otherwise does nothing. Afterwards
  /// physics_events() and events() tell what happened, as after apply().
  void step();
  /// Takes steps as step() does, with the same bits, at most `most`, and much quicker than one by
  /// one; ends after the first of which events() has something to tell. Returns the number taken: 0
  /// where step() would do nothing. Afterwards events() and physics_events() are the last step's.
  std::uint64_t run(std::uint64_t most);

  /// The game as bytes (docs/formats.md#states): load_state makes a game of it that goes on with
  /// the same bits. Its events are not part of it.
  std::string save_state() const;
  /// Refuses bytes that are no state of such a game, were changed, or are of other physics or
  /// rules.
  static carom::Result<Game> load_state(std::string_view state);

  Phase phase() const { return phase_; }
  const carom::World& world() const { return world_; }
  const carom::Scene& level() const { return level_; }  ///< as it was at the start
  carom::Vec2 launch_place() const { return level_.balls[0].position; }
  int throws_left() const { return throws_left_; }  ///< the one in flight no longer counts
  int enemies_left() const;
  std::int64_t score() const { return score_; }
  int turn_balls() const { return turn_balls_; }  ///< destroyed or gone in this turn

  /// Events of the last step() or of the last command that was taken: the world's, which a command
  /// has none of, and what the rules made of them.
  std::span<const carom::Event> physics_events() const { return physics_; }
  std::span<const Event> events() const { return events_; }

 private:
  Game(carom::Scene level, carom::World world);
  carom::Status launch(carom::Vec2 drag);
  carom::Status next();
  void score_lost_balls();

  carom::Scene level_;
  carom::World world_;
  Phase phase_ = Phase::aim;
  int throws_left_;
  std::int64_t score_ = 0;
  int turn_balls_ = 0;
  std::uint64_t turn_steps_ = 0;
  std::vector<carom::Event> physics_;
  std::vector<Event> events_;
};

}  // namespace angry_balls
}  // namespace games
