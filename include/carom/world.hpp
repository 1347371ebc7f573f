#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "carom/balls.hpp"
#include "carom/event.hpp"
#include "carom/public.hpp"
#include "carom/region.hpp"
#include "carom/result.hpp"
#include "carom/scene.hpp"
#include "carom/vec2.hpp"

namespace CAROM_PUBLIC carom {

inline constexpr double time_step = 0.01;     ///< s, dt (§1.2.1)
inline constexpr int steps_per_second = 100;  ///< 1 / time_step
inline constexpr double rest_speed = 30;      ///< px/s, vmin: slower counts as standing (§1.4.1)
inline constexpr int max_threads = 64;
inline constexpr int max_sub_steps = 64;  ///< of one step, docs/physics.md#one-step

/// The way in which a world finds the pairs of balls that may collide. It changes the speed and
/// nothing else.
enum class BroadPhase : std::uint8_t {
  automatic,  ///< the quadtree, or what is quicker for a few balls
  quadtree,   ///< O(balls) as long as they do not lie in heaps
  pairs,      ///< tests every pair, O(balls²): the reference that the others are compared with
};

/// When World::run ends, besides after its `max_steps`.
struct Until {
  bool rest = false;    ///< as soon as at_rest(); at once, after no step, if it is so already
  EventKinds events{};  ///< after the first step with an event of one of these kinds
};

struct RunEnd {
  enum class Why : std::uint8_t { steps, rest, event };
  std::uint64_t steps = 0;  ///< taken
  Why why = Why::steps;     ///< event, if more than one is true; steps, if none of Until is

  friend bool operator==(const RunEnd&, const RunEnd&) = default;
};

struct FixedParts;
struct Workspace;

/// Balls, holes, obstacles and edges in motion (§1.1.4, §1.2, §2.2). A plain value: copy it to keep
/// a state. The same scene and the same calls give the same bits everywhere.
///
/// Balls live in an array; one that goes out of play is swapped with the last and dropped, so an
/// index is good until the next step() only, an id for ever (§1.1.4). The lead (cue ball or
/// projectile) is the exception: it stays at index 0 and waits, out of play, for place_lead().
class World {
 public:
  /// Refuses a scene that check() finds anything wrong with.
  static Result<World> create(Scene scene);

  /// Advances by time_step (docs/physics.md#one-step) and returns what happened, in order. The span
  /// is good until the next step() or the world's end.
  std::span<const Event> step();

  /// Takes steps as step() does, with the same bits, at most `max_steps`, and much quicker than one
  /// by one. For each step that has events calls sink(step, events): its number, as steps() tells
  /// after it, and a std::span<const Event> that is good during the call. The sink must not change
  /// the world.
  template <class Sink>
  RunEnd run(Until until, std::uint64_t max_steps, Sink&& sink) {
    using Plain = std::remove_reference_t<Sink>;
    return run(
        until, max_steps,
        [](void* to, std::uint64_t step, std::span<const Event> events) {
          (*static_cast<Plain*>(to))(step, events);
        },
        const_cast<void*>(static_cast<const void*>(std::addressof(sink))));
  }
  /// The same for those who need no events.
  RunEnd run(Until until, std::uint64_t max_steps) {
    return run(until, max_steps, nullptr, nullptr);
  }

  /// The world's fixed part: size, edges, friction, holes, obstacles, … Its `balls` are empty.
  const Scene& scene() const;

  /// Slots in the array, a lead out of play included: indices run from 0 to this, exclusive.
  std::size_t size() const { return balls_.size(); }
  /// The ball at an index < size().
  Ball ball(std::size_t index) const { return balls_[index]; }
  /// All of them, for loops over many. Good until the world changes.
  BallsView balls() const { return balls_.view(); }
  /// False only for a lead that waits to be placed.
  bool in_play(std::size_t index) const { return index != 0 || !lead_out_; }
  /// Balls in play.
  std::size_t balls_left() const { return balls_.size() - (lead_out_ ? 1 : 0); }
  /// True if ball 0 is a cue ball or a projectile.
  bool has_lead() const { return size() > 0 && is_lead(balls_.role[0]); }

  /// The index of the ball with an id; none if it is not in play. O(balls).
  std::optional<std::size_t> index_of(std::uint32_t id) const;

  // Questions about places. The first after a step or a change builds an index of all balls, O(n);
  // so they are no const functions. Touching is not overlapping.

  /// The balls in play that overlap a disc, by ascending index. Refuses NaN, infinities and more
  /// than max_quantity.
  Result<std::vector<std::uint32_t>> balls_in(Disc disc);
  /// Those that reach into a box, its boundary included. It may be infinite. Refuses NaN and
  /// corners that are not in order.
  Result<std::vector<std::uint32_t>> balls_in(Box box);
  /// The first ball in play, solid edge or obstacle that a disc with `radius` (px, 0 for a ray)
  /// touches on its straight way from `from` (px) along `direction` (of any length); none if it
  /// meets nothing. Balls and obstacles that it overlaps at the start are not met, so a ball's own
  /// place is a start. Holes are never met. Refuses NaN, infinities, more than max_quantity and the
  /// direction 0.
  Result<std::optional<Contact>> first_contact(Vec2 from, Vec2 direction, double radius);

  /// Steps taken since create().
  std::uint64_t steps() const { return steps_; }

  /// Every ball is slower than rest_speed and none is being pulled by a hole (§1.4.1).
  bool at_rest() const;

  /// Gives a ball in play a velocity, px/s. Refuses a wrong index, NaN, infinities and more than
  /// max_speed.
  Status set_velocity(std::size_t index, Vec2 velocity);

  /// Puts the lead, in or out of play, at `position` (px), at rest (§1.4.1, §2.3.1). One that broke
  /// is whole again, with the solidity that it had at the start. Refuses a
  /// world without one, NaN, infinities, coordinates beyond max_quantity, a place inside an
  /// obstacle or sticking out of a solid edge.
  Status place_lead(Vec2 position);

  /// Adds a ball as a scene's: its id, which it returns, is a new one, its acceleration zero.
  /// Refuses what check() would refuse of a scene with this ball alone, a lead except as the only
  /// ball, and more than max_balls. Balls that overlap are taken, however many: heaps cost time.
  /// O(holes + obstacles).
  Result<std::uint32_t> add(Ball ball);

  /// Takes a ball out of play: the last ball gets its index, but a lead waits to be placed. Refuses
  /// a wrong index.
  Status remove(std::size_t index);

  /// Gives a ball in play the role, position, velocity, radius and solidity of `ball`; it keeps its
  /// id and acceleration. Refuses a wrong index, what add() refuses, and a lead's role elsewhere
  /// than at index 0.
  Status set_ball(std::size_t index, Ball ball);

  /// The whole state as bytes (docs/formats.md#states): load_state makes a world of it that goes on
  /// with the same bits. Broad phase, skipping and threads are no part of it.
  std::string save_state() const;
  /// Refuses bytes that are no state of a world, were changed, or are of other physics.
  static Result<World> load_state(std::string_view state);

  /// All speeds become zero (end of a turn, §1.4.1).
  void stop();

  /// No part of the state: the same bits come out, sooner or later.
  void set_broad_phase(BroadPhase broad_phase) { broad_phase_ = broad_phase; }

  /// True: steps in which surely nothing meets are passed over quickly (the default); false: every
  /// one is tested. No part of the state: the same bits come out, sooner or later.
  void set_skipping(bool skipping) { skipping_ = skipping; }

  /// The number of threads that step() may use, 1 (the default) to max_threads; other numbers are
  /// taken as the nearest of these. With fewer than 20 000 balls it uses one. No part of the state:
  /// the same bits come out with every number. Where threads cannot be had, there are fewer.
  void set_threads(int threads) {
    threads_ = static_cast<std::size_t>(std::clamp(threads, 1, max_threads));
  }

  /// 64-bit FNV-1a over the canonical state: one byte (1: the lead is out of play), the number of
  /// balls in play as 64 bits, then in index order for each ball in play its id (32 bits), role
  /// (8 bits), position, velocity, acceleration, radius and solidity (64 bits each). Little-endian,
  /// -0.0 as 0.0.
  std::uint64_t state_hash() const;

 private:
  using Tell = void (*)(void* sink, std::uint64_t step, std::span<const Event> events);

  explicit World(Scene scene);
  RunEnd run(Until until, std::uint64_t max_steps, Tell tell, void* sink);

  /// Data cached by steps belongs to the state it was made for: a copy starts without, an
  /// assignment forgets it, but keeps its memory.
  struct WorkspaceOwner {
    WorkspaceOwner() = default;
    WorkspaceOwner(const WorkspaceOwner&) {}
    WorkspaceOwner(WorkspaceOwner&&) = default;
    WorkspaceOwner& operator=(const WorkspaceOwner& other);
    WorkspaceOwner& operator=(WorkspaceOwner&&) = default;
    ~WorkspaceOwner() = default;
    std::shared_ptr<Workspace> workspace;  ///< never shared; made by the first step()
  };

  Workspace& workspace();
  /// The state is no longer what the last step left.
  void changed();
  /// Nor are the balls or their radii.
  void balls_changed();
  static Error no_such_ball();
  std::vector<std::uint32_t> in_play_only(std::vector<std::uint32_t> found) const;

  std::shared_ptr<const FixedParts> fixed_;  ///< shared by copies
  Balls balls_;
  bool lead_out_ = false;
  std::uint64_t steps_ = 0;
  std::uint32_t next_id_ = 0;  ///< of a ball that is added
  BroadPhase broad_phase_ = BroadPhase::automatic;
  bool skipping_ = true;
  std::size_t threads_ = 1;
  WorkspaceOwner owner_;

  friend class Stepper;
};

}  // namespace carom
