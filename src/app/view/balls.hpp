#pragma once

#include "app/graphics/draw_list.hpp"

namespace app {

/// A ball's colours, from the lit side to the dark one.
struct BallLook {
  Color base;
  Color shade;
  float gloss = 1;  ///< 0: matte
};

enum class BallKind : std::uint8_t { ivory, red, wooden, stone };
BallLook look_of(BallKind kind, const Palette& palette);

/// A ball, lit from above and left.
void draw_ball(DrawList& list, Point center, float radius, const BallLook& look, float opacity = 1);
/// The same by a stamp: for radii that come again.
void draw_ball(DrawList& list, Point center, float radius, BallKind kind);
/// A ball's shadow on the ground; drawn before every ball.
void draw_ball_shadow(DrawList& list, Point center, float radius);

}  // namespace app
