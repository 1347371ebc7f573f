#include "app/view/game_sounds.hpp"

#include "games/launch.hpp"

namespace app {
namespace {

constexpr double loudest = 1500;  ///< px/s between two balls
/// px/s; rolling, and balls that lie on each other under gravity, are not heard.
constexpr double quiet = 25;

float strength(double speed) {
  return speed < quiet ? 0 : static_cast<float>(std::min(speed / loudest, 1.0));
}

/// Less than the table's width: nothing is heard by one ear alone.
float pan(const Sounds& sounds, carom::Vec2 at, const carom::Scene& scene) {
  const double across = sounds.turned() ? 1 - at.y / scene.height : at.x / scene.width;
  return static_cast<float>(std::clamp(1.4 * across - 0.7, -0.7, 0.7));
}

}  // namespace

void note_contacts(Sounds& sounds, std::span<const carom::Event> events, const carom::Scene& scene,
                   bool level) {
  using carom::EventKind;
  for (const carom::Event& event : events) {
    const auto note = [&](SoundKind kind, float strong) {
      sounds.note({kind, strong, pan(sounds, event.position, scene)});
    };
    const double speed = carom::length(event.deviation);
    switch (event.kind) {
      case EventKind::pair:
        note(level ? SoundKind::block : SoundKind::ball, strength(speed));
        break;
      // A ball thrown back comes and goes with half its change.
      case EventKind::cushion:
        note(level ? SoundKind::wall : SoundKind::cushion, strength(speed / 2));
        break;
      case EventKind::floor:
        note(SoundKind::ground, strength(speed / 2));
        break;
      case EventKind::wall:
      case EventKind::cap:
        note(SoundKind::wall, strength(speed / 2));
        break;
      case EventKind::pocketed:
        note(SoundKind::pocket, 0.8f);
        break;
      case EventKind::destroyed:
        note(SoundKind::burst, 0.9f);
        break;
      case EventKind::damage:
      case EventKind::left:
        break;
    }
  }
}

void note_launch(Sounds& sounds, const carom::Ball& lead, const carom::Scene& scene) {
  const double speed = carom::length(lead.velocity) / games::max_launch_speed;
  sounds.note({lead.role == carom::Role::cue ? SoundKind::cue : SoundKind::sling,
               static_cast<float>(std::clamp(speed, 0.1, 1.0)), pan(sounds, lead.position, scene)});
}

}  // namespace app
