#pragma once

#include <chrono>

namespace app {

using std::chrono::nanoseconds;

/// Turns the time that frames take into the simulation's steps of 10 ms, whatever the monitor's
/// rate. What is left of a frame is kept for the next: nothing is rounded away.
class Clock {
 public:
  static constexpr nanoseconds step{10'000'000};  ///< carom::time_step
  /// Steps made up for after a stall; the rest of the stall is forgotten, so that a slow machine
  /// shows slow motion instead of falling ever further behind.
  static constexpr int catch_up = 8;

  /// How many steps to take now, at most `most`.
  int advance(nanoseconds elapsed, int most = catch_up);
  /// How far into the step to come, in [0, 1).
  double fraction() const;
  /// Starts anew, at the beginning of a step.
  void reset() { remainder_ = {}; }

 private:
  nanoseconds remainder_{};  ///< in [0, step)
};

}  // namespace app
