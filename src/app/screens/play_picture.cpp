// PlayScreen's picture and its line of text.

#include "app/graphics/palette.hpp"
#include "app/hud/aim_view.hpp"
#include "app/hud/cue_view.hpp"
#include "app/hud/hint_view.hpp"
#include "app/hud/loupe.hpp"
#include "app/screens/next_offer.hpp"
#include "app/screens/place_ball.hpp"
#include "app/screens/play_screen.hpp"

namespace app {

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::draw(Canvas& canvas) const {
  DrawList& list = canvas.list;
  const std::size_t begin = list.vertices.size();
  world_view_.draw_still(canvas);
  const bool bar_last = bar_is_last();
  if (!bar_last) draw_bar(canvas);
  list.stand_still();
  draw_ground(canvas);
  effects_.draw_under_balls(list, viewport());
  world_view_.draw_moving(canvas, shown_world(), interpolator_, moving() ? clock_.fraction() : 1);
  if (canvas.shake) effects_.shake(list, begin, layout_.world);
  const auto* launcher = std::get_if<Launcher>(&state_);
  if (launcher) draw_launcher(canvas, *launcher);
  if (hint_) draw_hint(canvas, layout_.world, viewport(), game().world(), *hint_, words_);
  if (const auto* computer = std::get_if<ComputerTurn>(&state_)) draw_computer(canvas, *computer);
  const auto* waiting = std::get_if<Waiting>(&state_);
  if (waiting) draw_waiting(canvas, *waiting, false);
  effects_.draw_over_balls(canvas, viewport(), effects_area(canvas), shown_world());
  if (waiting) draw_waiting(canvas, *waiting, true);
  game_speed_.draw_veil(canvas, layout_.world, words_);
  if (bar_last) draw_bar(canvas);
  if (played_.practice()) strip_.draw(canvas);
  Footer footer{.hint = hint(),
                .color = hint_color(*list.palette),
                .practice = played_.practice().has_value()};
  if (launcher) {
    const AimWay way = session_.settings.get().aiming.way;
    footer.aim = &launcher->aim;
    footer.entry = launcher->entry ? &*launcher->entry : nullptr;
    footer.slides = way == AimWay::apart || way == AimWay::turn;
    footer.shoot = launcher->offers_shot(way, touch_);
    footer.fine = launcher->offers_fine(way);
    footer.hint_button = offers_hint();
  }
  draw_footer(canvas, layout_.footer, footer, words_);
  if (footer.hint_button) hint_button_.draw(canvas, 18);
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::draw_launcher(Canvas& canvas, const Launcher& launcher) const {
  DrawList& list = canvas.list;
  const carom::Ball lead = game().world().ball(0);
  const auto pulled = launcher.pulled_to();
  if (pulled) draw_sling(list, viewport(), lead, *pulled);
  if (launcher.aim.active()) {
    const Preview& preview =
        previewer_.of(game().world(), launcher.aim, session_.settings.get().aiming,
                      played_.practice().has_value());
    draw_aim(list, viewport(), game().world(), launcher.aim, preview);
    if (pulled)
      draw_loupe(canvas, world_view_, game().world(), interpolator_, launcher.aim, preview,
                 *pulled);
    return;
  }
  draw_invitation(list, viewport(), lead, !touch_ && on_lead(lead, pointer_, viewport(), view_),
                  lead_color(*list.palette));
}

/// Its cue, and the aim that it has chosen; the hand that shoots may err.
template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::draw_computer(Canvas& canvas, const ComputerTurn& turn) const {
  const auto cue = turn.cue();
  if (!cue) return;
  if (!turn.thinking()) {
    Aim meant;
    meant.set(search::drag(turn.decision().meant.aim));
    draw_aim(canvas.list, viewport(), turn.world(), meant,
             previewer_.of(turn.world(), meant, {.preview = PreviewLength::contact}, false));
  }
  draw_cue(canvas.list, layout_.world, viewport(), turn.world().ball(0), *cue);
}

template <class Game, class Waiting>
std::string PlayScreen<Game, Waiting>::hint() const {
  const auto* launcher = std::get_if<Launcher>(&state_);
  const bool watches = std::holds_alternative<Watching>(state_);
  const bool idle = launcher ? !launcher->aim.active() && !launcher->missed() : watches;
  if (const auto& practice = played_.practice(); practice && practice->plan.active() && idle)
    return words_(Text::hint_repeat,
                  {session_.keyboard.name(Command::again), practised(words_, practice->plan)});
  if (launcher)
    return words_(aim_hint(*launcher, session_.settings.get().aiming.way, touch_, aim_hints()));
  if (watches && runout_.quiet()) return words_(Text::hint_quiet);
  if (watches)
    return words_(watch_hint(),
                  {session_.keyboard.name(Command::fast), session_.keyboard.name(Command::pause)});
  if (std::holds_alternative<ComputerTurn>(state_))
    return words_(thinking() ? Text::hint_thinking : Text::hint_computer_aims);
  return std::holds_alternative<Waiting>(state_) ? waiting_hint() : std::string();
}

template <class Game, class Waiting>
Color PlayScreen<Game, Waiting>::hint_color(const Palette& palette) const {
  if (const auto* launcher = std::get_if<Launcher>(&state_))
    return launcher->missed() ? palette.refused : palette::cream;
  return std::holds_alternative<Waiting>(state_) ? waiting_color(palette) : palette::muted;
}

template <class Game, class Waiting>
std::string PlayScreen<Game, Waiting>::describe() const {
  return described(now());
}

template <class Game, class Waiting>
std::string PlayScreen<Game, Waiting>::described(std::string what) const {
  if (game_speed_.paused()) what = words_(Text::paused_state, {what});
  if (played_.practice()) what = words_(Text::practice_state, {what});
  return state_line(what);
}

template class PlayScreen<games::billiards::Game, PlaceBall>;
template class PlayScreen<games::angry_balls::Game, NextOffer>;

}  // namespace app
