#pragma once

#include "app/graphics/draw_list.hpp"

/// Marks that tell balls apart besides their colour. `radius` is the ball's.
namespace app {

/// The projectile's and the title's: furious, glaring to the right.
void draw_angry_face(DrawList& list, Point center, float radius);

/// An enemy's horns; drawn before its ball.
void draw_horns(DrawList& list, Point center, float radius);
/// An enemy's face: a malicious grin to the left.
void draw_villain_face(DrawList& list, Point center, float radius);

}  // namespace app
