#pragma once

#include <optional>

#include "app/graphics/canvas.hpp"
#include "app/input/input.hpp"
#include "app/play/clock.hpp"
#include "app/text/text.hpp"

namespace app {

/// Speed of the shown game, by the player's hand and by events: P pauses, F or a finger
/// held down goes faster, a decisive moment passes slowly. Only how many steps a frame makes: the
/// steps are the same.
class GameSpeed {
 public:
  /// A decisive moment is shown slowly for so long, real time.
  static constexpr nanoseconds slow_time = milliseconds{1500};
  /// Where nothing more will happen, the game is at its quickest after so long, real time.
  static constexpr nanoseconds ease_time = milliseconds{800};
  static constexpr int eased_quarters = 16;  ///< then, of Speed
  /// So long a press is a touch like any other, not yet one that is held.
  static constexpr nanoseconds touch_time = milliseconds{250};

  /// Returns true if it was meant for the speed: then it is done with. `free`: the game may
  /// be paused. `watches`: a press does nothing else there.
  bool event(const Input& input, bool free, bool watches);
  /// Nothing is held any more.
  void let_go() { pressed_.reset(); }
  bool paused() const { return paused_; }
  /// Slow from now on; at most once a game.
  void decisive();
  /// Nothing more will happen in this launch: it passes more and more quickly.
  void ease(bool on) {
    if (!on) eased_ = nanoseconds{0};
    easing_ = on;
  }
  void new_game() { *this = {}; }
  /// The speed of a frame that takes `elapsed`.
  Speed pass(nanoseconds elapsed);

  /// Over `area`, while paused.
  void draw_veil(Canvas& canvas, const Rect& area, const Words& words) const;

 private:
  bool paused_ = false;
  bool fast_ = false;                   ///< the key is held down
  std::optional<nanoseconds> pressed_;  ///< for how long, while the balls are watched
  bool was_slow_ = false;               ///< in this game
  nanoseconds slow_left_{};
  bool easing_ = false;
  nanoseconds eased_{};  ///< for how long
};

}  // namespace app
