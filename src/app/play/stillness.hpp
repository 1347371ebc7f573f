#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "carom/world.hpp"

namespace app {

/// Finds out, a slice of steps at a time, when a world that goes on cannot change any more: within
/// the next `horizon` steps no ball is lost or moves by `least`. A copy of it runs ahead.
class Stillness {
 public:
  static constexpr int horizon = 3000;  ///< steps
  static constexpr double least = 1;    ///< px
  static constexpr int slice = 100;     ///< steps a call

  /// Forgets all: another world follows.
  void reset() { *this = {}; }
  /// Looks on; begins again at `now` where something has changed. Call it once a frame.
  void look(const carom::World& now);
  /// Nothing changes any more, as of a look before.
  bool still() const { return still_; }

 private:
  bool changed() const;

  std::optional<carom::World> ahead_;
  std::vector<carom::Vec2> places_;  ///< px, where the look began
  std::size_t in_play_ = 0;          ///< balls, there
  int steps_ = 0;                    ///< of the look
  bool still_ = false;
};

}  // namespace app
