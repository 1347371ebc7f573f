#pragma once

#include "app/audio/sound.hpp"
#include "app/text/text.hpp"
#include "app/view/effects.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"

namespace app {

// Effects and sounds of a game's step or command: contacts, balls that
// sink or burst, the points they make, and how it ends.

void show_events(Effects& effects, Sounds& sounds, const games::billiards::Game& game,
                 const Words& words);
void show_events(Effects& effects, Sounds& sounds, const games::angry_balls::Game& game,
                 const Words& words);

/// Only the balls, for a level's world that goes on without its rules.
void show_balls(Effects& effects, Sounds& sounds, std::span<const carom::Event> events,
                const carom::Scene& level);

}  // namespace app
