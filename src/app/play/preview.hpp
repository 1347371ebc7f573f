#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/play/aim.hpp"
#include "app/storage/aim_settings.hpp"
#include "carom/vec2.hpp"
#include "carom/world.hpp"

namespace app {

inline constexpr int brief_steps = 300;   ///< 3 s: what a preview but the full one looks ahead
inline constexpr int full_steps = 3000;   ///< 30 s: longer than any turn seen
inline constexpr int steps_per_dot = 5;   ///< 0.05 s
inline constexpr int dotted_steps = 100;  ///< the first second of flight

/// A place on a ball's way, px.
struct Waypoint {
  carom::Vec2 at;
  int step = 0;       ///< of the turn, 1 the first; 0 the start
  bool bend = false;  ///< where something met it within the step; otherwise where the step left it
  friend bool operator==(const Waypoint&, const Waypoint&) = default;
};
using BallPath = std::vector<Waypoint>;

/// Forecast of a launch: taken from the engine, which plays it.
struct Preview {
  BallPath lead;                     ///< from its place to its first contact with a ball
  std::optional<carom::Vec2> ghost;  ///< px, the lead's centre when it first touches a ball
  BallPath lead_after;               ///< from there on
  BallPath target;                   ///< of the ball that is hit, from there on
  std::uint32_t target_ball = 0;     ///< its id
  std::vector<carom::Vec2> dots;     ///< with gravity: the lead's flight, a place each 0.05 s
  bool pocketed = false;             ///< the lead's path shown ends in a hole
  friend bool operator==(const Preview&, const Preview&) = default;
};

/// Plays the launch by `drag` (px) in a copy of the world; empty for a drag that launches nothing.
/// Looks ahead no further than `length` asks, never further than a turn: contact and brief stop
/// after `brief` steps, full after full_steps, all when a turn would be over (all at rest, the cue
/// ball pocketed, the last red or enemy gone). brief follows both balls from their contact to what
/// each of them meets next.
Preview look_ahead(carom::World world, carom::Vec2 drag, PreviewLength length,
                   int brief = brief_steps);

/// Remembers the last preview, and makes another only when it is asked for something else.
class Previewer {
 public:
  /// Of a launch in a world that waits for it, as long as the player wants it; empty for an aim
  /// that is too weak. With gravity it ends with the dots, unless the player wants the full one.
  /// Good until the next call.
  const Preview& of(const carom::World& world, const Aim& aim, const AimSettings& settings,
                    bool practice);
  /// Number of previews made.
  std::size_t made() const { return made_; }

 private:
  struct Question {
    std::uint64_t state = 0;
    carom::Vec2 drag;
    PreviewLength length{};
    int brief = brief_steps;
    friend bool operator==(const Question&, const Question&) = default;
  };
  std::optional<Question> answered_;
  Preview preview_;
  std::size_t made_ = 0;
};

}  // namespace app
