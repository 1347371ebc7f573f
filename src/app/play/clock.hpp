#pragma once

#include "app/base/time.hpp"

namespace app {

/// Speed of the game's time.
struct Speed {
  int quarters = 4;  ///< of real time, > 0
};
inline constexpr Speed real_speed{4};
inline constexpr Speed slow_motion{1};
inline constexpr Speed fast_forward{16};

/// Turns the time that frames take into the simulation's steps of 10 ms, whatever the monitor's
/// rate. The rest of a frame is carried to the next: nothing is rounded away.
class Clock {
 public:
  static constexpr nanoseconds step{10'000'000};  ///< carom::time_step
  /// Steps made up for after a stall, at real speed or slower; the rest of the stall is forgotten,
  /// so that a slow machine shows slow motion instead of falling ever further behind.
  static constexpr int catch_up = 8;

  /// Returns the number of steps to take now.
  int advance(nanoseconds elapsed, Speed speed = real_speed);
  /// Returns the part of the coming step that has passed, in [0, 1).
  double fraction() const;
  /// Starts anew, at the beginning of a step.
  void reset() { remainder_ = 0; }

 private:
  nanoseconds::rep remainder_ = 0;  ///< quarters of a nanosecond, in [0, 4 steps)
};

}  // namespace app
