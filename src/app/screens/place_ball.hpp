#pragma once

#include "app/graphics/canvas.hpp"
#include "app/input/input.hpp"
#include "app/text/text.hpp"
#include "app/view/viewport.hpp"
#include "games/billiards.hpp"

namespace app {

/// The cue ball in hand is carried by pointer, arrows or sticks, and put down.
class PlaceBall {
 public:
  /// The state of the screen when something happens.
  struct Stage {
    const games::billiards::Game& game;
    const Viewport& viewport;
    Rect table;  ///< window px, with its wood
    Point pointer;
    bool on_button = false;        ///< the pointer is on a button
    bool focus_elsewhere = false;  ///< a button has the keyboard's focus
  };
  enum class Outcome : std::uint8_t {
    untouched,  ///< the input is somebody else's
    carried,    ///< the pointer is to go to `to`
    put,        ///< down at `to`, if the game takes it
  };

  Outcome event(const Input& input, const Stage& stage);
  Point to;  ///< window px

  static std::string hint(const Words& words, const Stage& stage);
  static Color hint_color(const Palette& palette, const Stage& stage);
  static void draw(Canvas& canvas, const Words& words, const Stage& stage);

 private:
  static games::billiards::Obstruction obstruction(const Stage& stage);
};

}  // namespace app
