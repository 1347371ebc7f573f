#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/base/time.hpp"
#include "app/input/input.hpp"

namespace app {

/// A gamepad, as keys where it does what they do: the cross is the arrows and repeats when held, A
/// is Enter, B Esc, X Tab, Back Shift+Tab, Y help, Start pause, the shoulders turn by 0.1°. The
/// sticks steer what is aimed or placed, the left one across and up, the right one and the triggers
/// the power; where nothing is steered, the left stick is a cross.
class Pad {
 public:
  /// Returns its immediate meaning. `steers`: something is aimed or placed.
  std::vector<Input> event(const Input& input, bool steers);
  /// Returns the meaning of all that is held for so long.
  std::vector<Input> advance(nanoseconds elapsed, bool steers);
  /// Something is held: time has to pass.
  bool held() const;

 private:
  std::optional<Key> stick_key() const;
  float deflection(PadAxis axis) const;
  void hold(std::optional<Key> key);

  std::array<float, 6> axes_{};
  std::optional<Key> stick_;  ///< the arrow that the left stick is
  std::optional<Key> key_;    ///< the arrow that repeats
  nanoseconds until_repeat_{};
};

}  // namespace app
