#pragma once

#include <span>

#include "app/audio/sound.hpp"
#include "carom/event.hpp"
#include "carom/scene.hpp"

namespace app {

/// Sounds of a step: contacts by their strength, balls that drop or break. `level`: balls of
/// wood and stone on earth, instead of billiard balls on a table.
void note_contacts(Sounds& sounds, std::span<const carom::Event> events, const carom::Scene& scene,
                   bool level);

/// The lead is launched: the cue ball, or a level's projectile. `lead`: as it starts.
void note_launch(Sounds& sounds, const carom::Ball& lead, const carom::Scene& scene);

}  // namespace app
