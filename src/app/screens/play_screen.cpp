#include "app/screens/play_screen.hpp"

#include <algorithm>
#include <utility>

#include "app/hud/aim_controls.hpp"
#include "app/screens/next_offer.hpp"
#include "app/screens/place_ball.hpp"
#include "app/view/clear_place.hpp"
#include "app/view/game_effects.hpp"

namespace app {

template <class Game, class Waiting>
PlayScreen<Game, Waiting>::PlayScreen(const Words& words, Session& session, Recorder recorder,
                                      KeptGames::Place place, WorldView world_view)
    : words_(words),
      session_(session),
      played_(session, std::move(recorder), std::move(place)),
      world_view_(std::move(world_view)),
      strip_(words) {}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::begin() {
  announce_start();
  interpolator_.restart(game().world());
  follow_phase();
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::resize(const View& view) {
  const carom::Vec2 pointed = viewport().to_world(pointer_);
  view_ = view;
  layout_ = GameLayout::of(view);
  if (played_.practice())
    strip_.resize(view, layout_.world.cut_bottom(PracticeStrip::height(view)));
  resize_bar(layout_.bar);
  hint_button_.place(view, 0, shoot_button(view, layout_.footer));
  hint_button_.relabel(0, words_(Text::key_hint));
  hint_button_.explain(0, words_(Text::tip_hint));
  world_view_.fit(layout_.world, view.px(8));
  session_.sounds.turn(viewport().turned());
  pointer_ = viewport().to_window(pointed);
  find_pointer();
  place_parts();
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::place_parts() {
  if (auto* waiting = std::get_if<Waiting>(&state_)) place_waiting(*waiting);
}

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::event(const Input& input) {
  if (const auto* moved = std::get_if<PointerMoved>(&input)) pointer_ = moved->at;
  if (const auto* press = std::get_if<PointerPressed>(&input)) {
    pointer_ = press->at;
    touch_ = press->touch;
  }
  for (const auto part : {&PlayScreen::change_speed, &PlayScreen::aim,
                          static_cast<Handled (PlayScreen::*)(const Input&)>(&PlayScreen::practise),
                          &PlayScreen::act, &PlayScreen::move_focus, &PlayScreen::press_hint,
                          &PlayScreen::press_bar, &PlayScreen::command})
    if (Handled handled = (this->*part)(input)) return std::move(*handled);
  return Stay{};
}

template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::change_speed(const Input& input) -> Handled {
  const auto* launcher = std::get_if<Launcher>(&state_);
  const bool free = !std::holds_alternative<Over>(state_) && !(launcher && launcher->held());
  const bool watches =
      (std::holds_alternative<Watching>(state_) || std::holds_alternative<ComputerTurn>(state_)) &&
      !on_button();
  return game_speed_.event(input, free, watches) ? Handled(Stay{}) : std::nullopt;
}

template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::aim(const Input& input) -> Handled {
  auto* launcher = std::get_if<Launcher>(&state_);
  if (!launcher) return std::nullopt;
  const Launcher::Outcome outcome = launcher->event(input, stage());
  if (outcome != Launcher::Outcome::untouched) {
    blur();
    // The aim is finite and not zero: the game takes it.
    if (outcome == Launcher::Outcome::launch && played_.launch(launcher->aim)) {
      follow_phase();
      keep();  // leaving while the balls roll takes nothing back
    }
    return Stay{};
  }
  // First what is held is let go.
  return launcher->held() && is_press_of_key(input) ? Handled(Stay{}) : std::nullopt;
}

/// By its button, or by the key at any time while the player aims.
template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::press_hint(const Input& input) -> Handled {
  const bool key = is_command(input, Command::hint) && std::holds_alternative<Launcher>(state_);
  if (!key && !(offers_hint() && hint_button_.event(input, session_.sounds))) return std::nullopt;
  ask_hint();
  return Stay{};
}

/// As long as nothing is aimed: then the button that shoots takes the place.
template <class Game, class Waiting>
bool PlayScreen<Game, Waiting>::offers_hint() const {
  const auto* launcher = std::get_if<Launcher>(&state_);
  return launcher && launcher->stance() == Launcher::Stance::idle;
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::ask_hint() {
  effects_.end_announcement();
  if (!hint_) {
    auto hint = Hint::begin(game(), error_of(session_.settings.get().hand));
    if (!hint) return;
    hint_.emplace(std::move(*hint));
    ++hints_;
  } else {
    hint_->more();
  }
  if (hint_->tells(Hint::Step::aim)) std::get<Launcher>(state_).show(hint_->aim());
}

template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::practise(const Input& input) -> Handled {
  // Before the window of the end opens only these two: the others would change what is not seen.
  if (!played_.practice() || (std::holds_alternative<Over>(state_) &&
                              !is_key(input, Key::backspace) && !is_command(input, Command::again)))
    return std::nullopt;
  const auto chosen = strip_.event(input, session_.sounds);
  if (!chosen) return std::nullopt;
  practise(*chosen);
  return Stay{};
}

template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::act(const Input& input) -> Handled {
  if (auto* waiting = std::get_if<Waiting>(&state_)) return waiting_event(*waiting, input);
  if (skip(input)) return Stay{};
  return std::holds_alternative<Over>(state_) ? Handled(Stay{}) : std::nullopt;
}

template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::move_focus(const Input& input) -> Handled {
  const bool moved =
      Buttons::move_focus({&bar().buttons(), played_.practice() ? &strip_.buttons() : nullptr,
                           waiting_buttons(), offers_hint() ? &hint_button_ : nullptr},
                          input);
  return moved ? Handled(Stay{}) : std::nullopt;
}

template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::press_bar(const Input& input) -> Handled {
  const auto pressed = bar().event(input, session_.sounds);
  if (!pressed) return std::nullopt;
  return *pressed == UserBar::Command::pause ? pause() : request(*pressed);
}

/// Where nothing more will happen, a key or tap goes to the end of the launch at once.
template <class Game, class Waiting>
bool PlayScreen<Game, Waiting>::skip(const Input& input) {
  if (!std::holds_alternative<Watching>(state_) || !runout_.quiet()) return false;
  const bool key = is_key(input, Key::space) || is_key(input, Key::enter);
  const bool tap = std::holds_alternative<PointerPressed>(input) && !on_button() &&
                   layout_.world.contains(pointer_);
  if (!tap && !(key && !focus_elsewhere())) return false;
  while (std::holds_alternative<Watching>(state_) && moving()) step();
  return true;
}

template <class Game, class Waiting>
auto PlayScreen<Game, Waiting>::command(const Input& input) -> Handled {
  if (is_key(input, Key::settings)) {
    game_speed_.let_go();
    return ShowSettings{};
  }
  if (is_key(input, Key::escape)) {
    Buttons* const own = waiting_buttons();
    if (!focus_elsewhere() && !(own && own->has_focus())) return pause();
    blur();
    if (own) own->blur();
    return Stay{};
  }
  if (is_command(input, Command::again)) return request(UserBar::Command::restart);
  return std::nullopt;
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::practise(const PracticeCommand& command) {
  if (played_.practise(command, aim_in(state_))) show_anew();
}

/// The game has gone elsewhere: to its start, back, or back and on.
template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::show_anew() {
  effects_.clear();
  begin_launch();
  turn_points_ = 0;
  follow_phase();
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::follow_phase() {
  phase_ = game().phase();
  hint_.reset();
  if (!continues()) {
    interpolator_.restart(game().world());
    clock_.reset();
    foresight_.end();
  }
  const Doing now = doing();
  if (now == Doing::aim || now == Doing::wait)
    if (auto turn = computer_turn()) {
      state_.template emplace<ComputerTurn>(std::move(*turn));
      return;
    }
  switch (now) {
    case Doing::aim: {
      Launcher launcher(first_drag());
      if (const auto& practice = played_.practice(); practice && practice->ready())
        launcher.show(practice->plan);
      state_ = std::move(launcher);
      break;
    }
    case Doing::watch:
      turn_points_ = 0;
      begin_launch();
      state_ = Watching{};
      runout_.reset();
      effects_.end_announcement();
      if (!session_.calm()) foresight_.begin(game());
      break;
    case Doing::wait:
      state_ = Waiting{};
      break;
    case Doing::over:
      state_ = ending();
      break;
  }
  place_parts();
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::keep() {
  if (!played_.keep()) effects_.announce(words_(Text::not_kept), {}, {});
}

template <class Game, class Waiting>
Navigation PlayScreen<Game, Waiting>::iterate(nanoseconds elapsed) {
  if (game_speed_.paused()) return Stay{};
  const bool watches = std::holds_alternative<Watching>(state_);
  if (watches && session_.settings.get().quick_rolling) runout_.look(game());
  game_speed_.ease(watches && runout_.quiet());
  if (std::holds_alternative<Waiting>(state_)) pass_waiting(elapsed);
  const Speed speed = game_speed_.pass(elapsed);
  effects_.advance(speed.quarters < 4 ? elapsed * speed.quarters / 4 : elapsed);
  if (auto* launcher = std::get_if<Launcher>(&state_)) launcher->advance(elapsed);
  if (hint_) hint_->advance(elapsed, session_.rollouts);
  if (auto* computer = std::get_if<ComputerTurn>(&state_))
    compute(*computer, elapsed * speed.quarters / 4);
  if (!moving()) return Stay{};
  // Slow motion does not hold the window up.
  if (auto* over = std::get_if<Over>(&state_))
    over->wait -= elapsed * std::max(speed.quarters, 4) / 4;
  for (int due = clock_.advance(elapsed, speed); due > 0 && moving(); --due) step();
  return Stay{};
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::compute(ComputerTurn& turn, nanoseconds elapsed) {
  const bool thought = turn.thinking();
  turn.advance(elapsed, session_.rollouts);
  if (thought && !turn.thinking()) interpolator_.restart(turn.world());
  if (!turn.ready()) return;
  play(search::Decision(turn.decision()));
  follow_phase();
  keep();
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::step() {
  interpolator_.record(shown_world());
  if (auto* over = std::get_if<Over>(&state_)) {
    if constexpr (requires { game().level(); })
      show_balls(effects_, session_.sounds, over->epilogue->step(), game().level());
    return;
  }
  played_.step();
  if (foresight_.step()) game_speed_.decisive();
  after_step();
  happened();
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::happened() {
  show_events(effects_, session_.sounds, game(), words_);
  for (const auto& event : game().events()) note(event);
  if (game().phase() == phase_) return;
  follow_phase();
  keep();
}

template <class Game, class Waiting>
const carom::World& PlayScreen<Game, Waiting>::shown_world() const {
  if (const auto* computer = std::get_if<ComputerTurn>(&state_)) return computer->world();
  const auto* over = std::get_if<Over>(&state_);
  return over && over->epilogue ? *over->epilogue : game().world();
}

template <class Game, class Waiting>
bool PlayScreen<Game, Waiting>::on_button() const {
  return bar().has_button_at(pointer_, touch_) ||
         (offers_hint() && hint_button_.cover(pointer_, touch_)) ||
         (played_.practice() && strip_.has_button_at(pointer_, touch_));
}

template <class Game, class Waiting>
bool PlayScreen<Game, Waiting>::focus_elsewhere() const {
  return bar().buttons().has_focus() || strip_.buttons().has_focus() || hint_button_.has_focus();
}

template <class Game, class Waiting>
void PlayScreen<Game, Waiting>::blur() {
  bar().buttons().blur();
  strip_.buttons().blur();
  hint_button_.blur();
}

template <class Game, class Waiting>
Launcher::Stage PlayScreen<Game, Waiting>::stage() const {
  return {.lead = game().world().ball(0),
          .viewport = viewport(),
          .view = view_,
          .world = layout_.world,
          .meter = strength_meter(view_, layout_.footer),
          .shoot = shoot_button(view_, layout_.footer),
          .fine = fine_field(view_, layout_.footer),
          .way = session_.settings.get().aiming.way,
          .on_button = on_button(),
          .focus_elsewhere = focus_elsewhere(),
          .sounds = &session_.sounds};
}

template <class Game, class Waiting>
std::vector<Dialog::Button> PlayScreen<Game, Waiting>::end_buttons(Text again_label) const {
  const bool back = played_.practice().has_value();
  return {{again, words_(again_label), words_(Text::tip_restart)},
          {back ? take_back : watch, words_(back ? Text::take_back : Text::watch_replay),
           words_(back ? Text::tip_take_back : Text::tip_watch)}};
}

template <class Game, class Waiting>
std::optional<AimPrompt> PlayScreen<Game, Waiting>::aim_prompt() const {
  if (game_speed_.paused()) return std::nullopt;
  if (std::holds_alternative<Waiting>(state_)) return waiting_prompt();
  if (!std::holds_alternative<Launcher>(state_)) return std::nullopt;
  const carom::Ball lead = game().world().ball(0);
  return AimPrompt{
      viewport().to_window(lead.position), viewport().px(lead.radius),
      nudge(session_.settings.get().aiming.way),
      session_.teaches() ? things_in(game().world(), viewport()) : std::vector<Rect>()};
}

template <class Game, class Waiting>
bool PlayScreen<Game, Waiting>::animating() const {
  const auto* launcher = std::get_if<Launcher>(&state_);
  return !game_speed_.paused() &&
         (moving() || effects_.active() || (launcher && launcher->charging()) ||
          std::holds_alternative<ComputerTurn>(state_) || (hint_ && hint_->searching()));
}

template class PlayScreen<games::billiards::Game, PlaceBall>;
template class PlayScreen<games::angry_balls::Game, NextOffer>;

}  // namespace app
