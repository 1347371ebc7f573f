#pragma once

#include "app/draw_list.hpp"

namespace app {

/// A ball's colours, from the lit side to the dark one.
struct BallLook {
  Color base;
  Color shade;
  float gloss = 1;  ///< 0: matte
};
extern const BallLook ivory_ball;
extern const BallLook red_ball;
extern const BallLook wooden_ball;
extern const BallLook stone_ball;

/// A ball, lit from above and left.
void draw_ball(DrawList& list, Point center, float radius, const BallLook& look, float opacity = 1);
/// What it darkens of the ground it lies on; drawn before every ball.
void draw_ball_shadow(DrawList& list, Point center, float radius);

}  // namespace app
