// Follows the line of an aim over the table: what the cue ball would meet first, for some
// directions; and which balls lie near a hole.
#include <cstdio>

#include "games/billiards.hpp"

int main() {
  const games::billiards::Game game;
  carom::World world = game.world();  // questions build an index, so of a copy
  const carom::Ball cue = world.ball(0);
  for (const carom::Vec2 direction : {carom::Vec2{1, 0}, {1, 0.12}, {0, 1}, {-1, -1}}) {
    const auto answer = world.first_contact(cue.position, direction, cue.radius);
    if (!answer || !answer.value()) return 1;
    const carom::Contact& contact = *answer.value();
    const char* const names[] = {"ball", "edge", "obstacle"};
    std::printf("towards (%g, %g): %s %zu after %.3f px\n", direction.x, direction.y,
                names[static_cast<int>(contact.with)], contact.index, contact.distance);
  }
  const auto near = world.balls_in(carom::Disc{world.scene().holes[5].position, 150});
  if (!near) return 1;
  std::printf("%zu balls within 150 px of the last hole\n", near.value().size());
}
