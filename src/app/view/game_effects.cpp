#include "app/view/game_effects.hpp"

#include "app/graphics/palette.hpp"
#include "app/view/game_sounds.hpp"
#include "app/view/level_view.hpp"

namespace app {

namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;

void show_events(Effects& effects, Sounds& sounds, const billiards::Game& game,
                 const Words& words) {
  const carom::Scene& table = game.world().scene();
  note_contacts(sounds, game.physics_events(), table, false);
  for (const billiards::Event& event : game.events())
    if (event.kind == billiards::EventKind::over) sounds.note({SoundKind::win});
  for (const carom::Event& event : game.physics_events()) {
    if (event.kind != carom::EventKind::pocketed) continue;
    const bool cue = event.ball == 0;
    effects.sink(event.position, table.holes[event.other].position,
                 cue ? carom::default_cue_radius : carom::default_radius,
                 cue ? BallKind::ivory : BallKind::red);
    for (const billiards::Event& scored : game.events())
      if (scored.kind == billiards::EventKind::scored && scored.ball == event.ball)
        effects.float_up(event.position, words(Text::points, {words.number(scored.points)}),
                         scored.player);
  }
}

void show_events(Effects& effects, Sounds& sounds, const angry_balls::Game& game,
                 const Words& words) {
  show_balls(effects, sounds, game.physics_events(), game.level());
  for (const angry_balls::Event& event : game.events()) {
    if (event.kind == angry_balls::EventKind::won) sounds.note({SoundKind::win});
    if (event.kind == angry_balls::EventKind::lost) sounds.note({SoundKind::lose});
    if (event.kind == angry_balls::EventKind::scored)
      effects.float_up(event.position, words(Text::points, {words.number(event.points)}), 0);
  }
}

void show_balls(Effects& effects, Sounds& sounds, std::span<const carom::Event> events,
                const carom::Scene& level) {
  note_contacts(sounds, events, level, true);
  for (const carom::Event& event : events) {
    const carom::Ball& ball = level.balls[event.ball];
    const BallKind kind = kind_of(ball, ball.solidity, level);
    if (event.kind == carom::EventKind::destroyed)
      effects.burst(event.position, ball.radius, kind, event.ball);
    else if (event.kind == carom::EventKind::pocketed)
      effects.sink(event.position, level.holes[event.other].position, ball.radius, kind);
  }
}

}  // namespace app
