#include "app/screens/angry_balls_screen.hpp"

#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/hud/aim_view.hpp"
#include "app/view/game_effects.hpp"
#include "app/view/level_view.hpp"

namespace app {
namespace {

namespace angry_balls = games::angry_balls;
using angry_balls::Phase;

constexpr nanoseconds epilogue_time = milliseconds{1200};
constexpr double trace_spacing = 0.016;      ///< of the level's width, between the dots
constexpr std::size_t longest_trace = 1000;  ///< dots

enum Answer : ButtonId { yes, no };
enum EndButton : ButtonId { go_on, again, watch, menu };  // watch: in practice, take back

}  // namespace

AngryBallsScreen::AngryBallsScreen(const Words& words, Session& session)
    : AngryBallsScreen(
          words, session,
          LevelRecorder(angry_balls::Game::create(
                            session.campaign.levels[session.campaign.current].scene.value())
                            .value())) {
  if (campaign_.practice) played_.begin_practice();
}

AngryBallsScreen::AngryBallsScreen(const Words& words, Session& session, LevelRecorder played)
    : words_(words),
      session_(session),
      campaign_(session.campaign),
      played_(session, std::move(played)),
      bar_(words),
      strip_(words) {
  announce_level();
  interpolator_.restart(game().world());
  follow_phase();
}

void AngryBallsScreen::announce_level() {
  if (session_.teaches()) return;  // the lesson would cover it
  effects_.announce(title(),
                    words_(Text::goal, {words_.number(game().enemies_left()),
                                        words_.number(game().throws_left())}),
                    {});
}

/// "Level 1: First steps".
std::string AngryBallsScreen::title() const {
  return words_(Text::level_and_name,
                {words_.number(static_cast<int>(campaign_.current) + 1),
                 words_.level_name(campaign_.levels[campaign_.current].name)});
}

void AngryBallsScreen::resize(const View& view) {
  view_ = view;
  layout_ = GameLayout::of(view);
  if (played_.practice())
    strip_.resize(view, layout_.world.cut_bottom(PracticeStrip::height(view)));
  bar_.resize(view, layout_.bar);
  viewport_ = level_viewport(layout_.world, game().level());
  session_.sounds.turn(false);
  pointer_ = viewport_.to_window(game().launch_place());
  place_parts();
}

/// Puts what comes and goes where it belongs in the window.
void AngryBallsScreen::place_parts() {
  if (question_) question_->resize(view_);
  if (auto* over = std::get_if<Over>(&state_)) over->dialog.resize(view_);
  if (auto* offered = std::get_if<NextOffered>(&state_)) {
    const Rect& world = layout_.world;
    const float height = view_.button(48);
    const Point middle{world.center().x, world.y + view_.px(16) + height / 2};
    offered->prompt.relabel(0, next_label());
    offered->prompt.explain(0,
                            words_(game().throws_left() > 0 ? Text::tip_next : Text::tip_finish));
    offered->prompt.place(
        view_, 0, centered(middle, std::min(view_.px(300), world.w - view_.px(32)), height));
  }
}

Transition AngryBallsScreen::event(const Input& input) {
  if (const auto* moved = std::get_if<PointerMoved>(&input)) pointer_ = moved->at;
  const auto* press = std::get_if<PointerPressed>(&input);
  if (press) {
    pointer_ = press->at;
    touch_ = press->touch;
  }

  auto* launcher = std::get_if<Launcher>(&state_);
  if (game_speed_.event(
          input,
          !question_ && !std::holds_alternative<Over>(state_) && !(launcher && launcher->held()),
          std::holds_alternative<WatchThrow>(state_) && !on_button()))
    return Transition::stay;
  // A key that is let go is so beneath a question, too.
  if (launcher && std::holds_alternative<KeyReleased>(input)) launcher->event(input, stage());
  if (question_) {
    const auto chosen = question_->event(input, session_.sounds);
    if (!chosen) return Transition::stay;
    question_.reset();
    if (*chosen != yes) return Transition::stay;
    played_.forget();
    return Transition::levels;
  }
  if (launcher) {
    const Launcher::Outcome outcome = launcher->event(input, stage());
    if (outcome != Launcher::Outcome::untouched) {
      bar_.buttons().blur();
      strip_.buttons().blur();
      // What is aimed is finite and not zero: the game takes it.
      if (outcome == Launcher::Outcome::launch && played_.launch(launcher->aim)) follow_phase();
      return Transition::stay;
    }
    // First what is held is let go.
    if (launcher->held() && is_press_of_key(input)) return Transition::stay;
  }
  auto* over = std::get_if<Over>(&state_);
  // At the end only these two: the others would change what is not seen, or move the focus.
  if (played_.practice() &&
      (!over || is_key(input, Key::backspace) || is_command(input, Command::again))) {
    if (const auto command = strip_.event(input, session_.sounds)) {
      if (played_.practise(*command, aim_in(state_))) show_anew();
      return Transition::stay;
    }
  }
  if (over) {
    if (over->wait > nanoseconds{0}) return Transition::stay;
    const auto chosen = over->dialog.event(input, session_.sounds);
    return chosen ? finish(*chosen) : Transition::stay;
  }
  auto* offered = std::get_if<NextOffered>(&state_);
  if (Buttons::move_focus({&bar_.buttons(), played_.practice() ? &strip_.buttons() : nullptr,
                           offered ? &offered->prompt : nullptr},
                          input))
    return Transition::stay;
  if (const auto command = bar_.event(input, session_.sounds)) return obey(*command);
  if (is_key(input, Key::settings)) return Transition::settings;
  if (is_command(input, Command::again)) return obey(UserBar::Command::restart);

  if (is_key(input, Key::escape)) return obey(UserBar::Command::close);

  const bool click = press && press->button == PointerButton::left && !on_button();
  if (offered) {
    offered->prompt.event(input, session_.sounds);
    const bool key =
        is_command(input, Command::next) || is_key(input, Key::enter) || is_key(input, Key::space);
    if ((click || key) && played_.apply(angry_balls::Next{})) {
      show_events(effects_, session_.sounds, game(), words_);
      follow_phase();
      keep();
    }
  }
  return Transition::stay;
}

/// The game has gone elsewhere: to its start, back, or back and on.
void AngryBallsScreen::show_anew() {
  effects_.clear();
  trace_.clear();
  turn_points_ = 0;
  follow_phase();
}

bool AngryBallsScreen::on_button() const {
  return bar_.has_button_at(pointer_, touch_) ||
         (played_.practice() && strip_.has_button_at(pointer_, touch_));
}

Launcher::Stage AngryBallsScreen::stage() const {
  return {.lead = game().world().ball(0),
          .viewport = viewport_,
          .view = view_,
          .world = layout_.world,
          .meter = strength_meter(view_, layout_.footer),
          .shoot = shoot_button(view_, layout_.footer),
          .way = session_.settings.get().aiming.way,
          .on_button = on_button(),
          .focus_elsewhere = bar_.buttons().has_focus() || strip_.buttons().has_focus(),
          .sounds = &session_.sounds};
}

Transition AngryBallsScreen::obey(UserBar::Command command) {
  if (command == UserBar::Command::settings) return Transition::settings;
  const bool under_way =
      game().world().steps() > 0 && !std::holds_alternative<Over>(state_) && !played_.practice();
  if (command == UserBar::Command::close) {
    if (!under_way) return Transition::levels;
    question_.emplace(words_(Text::ask_leave_level),
                      std::vector<Dialog::Line>{{words_(Text::level_is_lost), {}, {}}},
                      std::vector<Dialog::Button>{
                          {yes, words_(Text::leave), words_(Text::tip_give_up)},
                          {no, words_(Text::keep_playing), words_(Text::tip_close_help)}});
    place_parts();
  } else if (played_.restart()) {
    game_speed_.new_game();
    show_anew();
    announce_level();
  }
  return Transition::stay;
}

Transition AngryBallsScreen::finish(ButtonId button) {
  switch (button) {
    case go_on:
      campaign_.current = *campaign_.next();
      return Transition::level;
    case again:
      return obey(UserBar::Command::restart);
    case watch:
      if (played_.practice()) {
        if (played_.practise(TakeBack{}, aim_in(state_))) show_anew();
        return Transition::stay;
      }
      session_.to_watch = played_.recorder().replay();
      return Transition::replay;
    default:
      return Transition::levels;
  }
}

std::string AngryBallsScreen::next_label() const {
  return words_(game().throws_left() > 0 ? Text::next_throw : Text::finish,
                {session_.keyboard.name(Command::next)});
}

void AngryBallsScreen::follow_phase() {
  switch (game().phase()) {
    case Phase::aim: {
      foresight_.end();
      const carom::Scene& level = game().level();
      Launcher launcher(played_.last_drag().value_or(
          first_aim(game().launch_place(), {level.width / 2, level.height / 2})));
      if (const auto& practice = played_.practice(); practice && practice->ready())
        launcher.show(practice->plan);
      state_ = std::move(launcher);
      break;
    }
    case Phase::fly:
      turn_points_ = 0;
      trace_.clear();
      state_ = WatchThrow{};
      if (!session_.calm()) foresight_.begin(game());
      break;
    case Phase::offer:
      state_ = NextOffered{Buttons({{0, next_label()}}, 0)};
      place_parts();
      return;  // the level goes on moving
    case Phase::won:
    case Phase::lost:
      foresight_.end();
      state_ = Over{result(), game().world(),
                    game().phase() == Phase::won ? epilogue_time : nanoseconds{0}};
      place_parts();
      return;
  }
  interpolator_.restart(game().world());
  clock_.reset();
}

Dialog AngryBallsScreen::result() {
  const bool won = game().phase() == Phase::won;
  std::vector<Dialog::Line> lines;
  lines.push_back({words_(Text::score), words_.number(game().score()), {}});
  if (played_.practice()) {
    lines.push_back({words_(Text::practice_only), {}, {}});
  } else if (won) {
    const std::string& identity = campaign_.levels[campaign_.current].identity;
    const bool better = campaign_.best.record(identity, game().score());
    const int used = game().level().throws - game().throws_left();
    lines.push_back(
        {words_(Text::throws_used, {words_.number(used), words_.number(game().level().throws)}),
         {},
         {}});
    lines.push_back({better ? words_(Text::new_best)
                            : words_(Text::best, {words_.number(*campaign_.best.of(identity))}),
                     {},
                     {}});
    if (campaign_.best.trouble() == BestScores::Trouble::not_kept)
      lines.push_back({words_(Text::scores_not_kept), {}, {}});
  } else {
    lines.push_back({words_(Text::enemies_remain, {words_.number(game().enemies_left())}), {}, {}});
  }
  std::vector<Dialog::Button> buttons{
      {again, words_(Text::play_again), words_(Text::tip_restart)},
      played_.practice()
          ? Dialog::Button{watch, words_(Text::take_back), words_(Text::tip_take_back)}
          : Dialog::Button{watch, words_(Text::watch_replay), words_(Text::tip_watch)},
      {menu, words_(Text::menu), words_(Text::tip_menu)}};
  if (won && campaign_.next())
    buttons.insert(buttons.begin(),
                   {go_on, words_(Text::next_level), words_(Text::tip_next_level)});
  return {words_(won ? Text::won : Text::lost), std::move(lines), buttons};
}

bool AngryBallsScreen::moving() const {
  if (question_) return false;
  if (const auto* over = std::get_if<Over>(&state_)) return over->wait > nanoseconds{0};
  // A level left alone for an hour stands still rather than outgrow what can be kept and watched.
  return game().phase() == Phase::fly ||
         (game().phase() == Phase::offer && played_.recorder().has_room());
}

std::optional<AimPrompt> AngryBallsScreen::aim_prompt() const {
  if (question_ || game_speed_.paused() || !std::holds_alternative<Launcher>(state_))
    return std::nullopt;
  const carom::Ball projectile = game().world().ball(0);
  return AimPrompt{viewport_.to_window(projectile.position), viewport_.px(projectile.radius),
                   nudge(session_.settings.get().aiming.way)};
}

bool AngryBallsScreen::animating() const {
  const auto* launcher = std::get_if<Launcher>(&state_);
  return !question_ && !game_speed_.paused() &&
         (moving() || effects_.active() || (launcher && launcher->charging()));
}

const carom::World& AngryBallsScreen::shown_world() const {
  const auto* over = std::get_if<Over>(&state_);
  return over ? over->epilogue : game().world();
}

Transition AngryBallsScreen::iterate(nanoseconds elapsed) {
  // The level waits for the answer.
  if (question_ || game_speed_.paused()) return Transition::stay;
  const Speed speed = game_speed_.pass(elapsed);
  effects_.advance(speed.quarters < 4 ? elapsed * speed.quarters / 4 : elapsed);
  if (auto* launcher = std::get_if<Launcher>(&state_)) launcher->advance(elapsed);
  if (!moving()) return Transition::stay;
  // Slow motion does not hold the window up.
  if (auto* over = std::get_if<Over>(&state_))
    over->wait -= elapsed * std::max(speed.quarters, 4) / 4;
  for (int due = clock_.advance(elapsed, speed); due > 0 && moving(); --due) step();
  return Transition::stay;
}

void AngryBallsScreen::step() {
  interpolator_.record(shown_world());
  if (auto* over = std::get_if<Over>(&state_)) {
    show_balls(effects_, session_.sounds, over->epilogue.step(), game().level());
    return;
  }
  const Phase before = game().phase();
  played_.step();
  if (foresight_.step()) game_speed_.decisive();
  trace_projectile();
  show_events(effects_, session_.sounds, game(), words_);
  for (const angry_balls::Event& event : game().events())
    if (event.kind == angry_balls::EventKind::scored) turn_points_ += event.points;
  if (game().phase() == before) return;
  follow_phase();
  keep();
}

void AngryBallsScreen::keep() {
  if (!played_.keep()) effects_.announce(words_(Text::not_kept), {}, {});
}

void AngryBallsScreen::trace_projectile() {
  const carom::World& world = game().world();
  if (!world.in_play(0) || trace_.size() >= longest_trace) return;
  const carom::Vec2 at = world.ball(0).position;
  const carom::Vec2 last = trace_.empty() ? game().launch_place() : trace_.back();
  if (carom::length(at - last) >= trace_spacing * game().level().width) trace_.push_back(at);
}

void AngryBallsScreen::draw(Canvas& canvas) const {
  DrawList& list = canvas.list;
  const std::size_t begin = list.vertices.size();
  draw_level(list, layout_.world, viewport_, game().level());
  // Over what leaves the level; otherwise the bars stand still with it.
  const bool bars_last = effects_.active() || any_above(layout_.world, viewport_, shown_world());
  if (!bars_last) draw_bars(canvas);
  list.stand_still();
  draw_trace(list);
  effects_.draw_under_balls(list, viewport_);
  const auto* launcher = std::get_if<Launcher>(&state_);
  const double fraction = moving() ? clock_.fraction() : 1;
  if (!canvas.calm)
    draw_level_trails(list, viewport_, shown_world(), game().level(), interpolator_, fraction);
  draw_level_balls(list, layout_.world, viewport_, shown_world(), game().level(), interpolator_,
                   fraction);
  if (canvas.shake) effects_.shake(list, begin, layout_.world);
  if (launcher) {
    const carom::Ball projectile = game().world().ball(0);
    if (const auto to = launcher->pulled_to()) draw_sling(list, viewport_, projectile, *to);
    if (launcher->aim.active())
      draw_aim(list, viewport_, game().world(), launcher->aim,
               previewer_.of(game().world(), launcher->aim, session_.settings.get().aiming,
                             played_.practice().has_value()));
    else
      draw_invitation(list, viewport_, projectile,
                      !touch_ && on_lead(projectile, pointer_, viewport_, view_),
                      canvas.list.palette->accents[0]);
  }
  Rect free = layout_.world.inset(canvas.px(4));
  const auto* offered = std::get_if<NextOffered>(&state_);
  if (offered) free.cut_top(canvas.px(64));
  effects_.draw_over_balls(canvas, viewport_, free);
  if (offered) offered->prompt.draw(canvas, 20);
  game_speed_.draw_veil(canvas, layout_.world, words_);

  if (bars_last) draw_bars(canvas);
  if (played_.practice()) strip_.draw(canvas);
  draw_footer(canvas, layout_.footer, launcher ? &launcher->aim : nullptr,
              launcher && launcher->entry ? &*launcher->entry : nullptr, words_, hint(),
              hint_color(*canvas.list.palette),
              launcher && launcher->offers_shot(session_.settings.get().aiming.way, touch_));
  const auto* over = std::get_if<Over>(&state_);
  if (over && over->wait <= nanoseconds{0}) over->dialog.draw(canvas);
  if (question_) question_->draw(canvas);
}

void AngryBallsScreen::draw_bars(Canvas& canvas) const {
  LevelBar::Content content;
  content.number = static_cast<int>(campaign_.current) + 1;
  content.name = words_.level_name(campaign_.levels[campaign_.current].name);
  content.score = game().score();
  content.turn_points = turn_points_;
  content.throws_left = game().throws_left();
  content.enemies_left = game().enemies_left();
  bar_.draw(canvas, content);
  fill_rounded(canvas.list, layout_.footer, 0,
               Paint::vertical(layout_.footer, palette::slate_top, palette::slate_bottom));
}

void AngryBallsScreen::draw_trace(DrawList& list) const {
  const float radius = std::max(viewport_.px(2.6), 1.5f);
  for (const carom::Vec2 at : trace_) {
    const Point c = viewport_.to_window(at);
    fill_disc(list, c, radius + 1, faded(palette::ink, 0.35f));
    fill_disc(list, c, radius, faded(palette::cream, 0.8f));
  }
}

std::string AngryBallsScreen::hint() const {
  const auto* launcher = std::get_if<Launcher>(&state_);
  const bool idle = launcher ? !launcher->aim.active() && !launcher->missed()
                             : std::holds_alternative<WatchThrow>(state_);
  if (const auto& practice = played_.practice(); practice && practice->plan.active() && idle)
    return words_(Text::hint_repeat,
                  {session_.keyboard.name(Command::again), practised(words_, practice->plan)});
  if (launcher)
    return words_(
        aim_hint(*launcher, session_.settings.get().aiming.way, touch_,
                 {Text::hint_take_projectile, Text::hint_not_projectile, Text::hint_throw}));
  if (std::holds_alternative<NextOffered>(state_))
    return words_(game().throws_left() > 0 ? Text::hint_next : Text::hint_finish,
                  {session_.keyboard.name(Command::next)});
  return std::holds_alternative<WatchThrow>(state_)
             ? words_(Text::hint_flying, {session_.keyboard.name(Command::fast),
                                          session_.keyboard.name(Command::pause)})
             : std::string();
}

Color AngryBallsScreen::hint_color(const Palette& palette) const {
  if (const auto* launcher = std::get_if<Launcher>(&state_))
    return launcher->missed() ? palette.refused : palette::cream;
  return std::holds_alternative<NextOffered>(state_) ? palette.allowed : palette::muted;
}

std::string AngryBallsScreen::describe() const {
  std::string now = question_ ? question_->title() : [&] {
    switch (game().phase()) {
      case Phase::aim:
        return words_(Text::ready_to_throw);
      case Phase::fly:
        return words_(Text::watching_throw);
      case Phase::offer:
        return words_(game().throws_left() > 0 ? Text::next_offered : Text::finish_offered);
      case Phase::won:
      case Phase::lost:
        break;
    }
    return std::get<Over>(state_).dialog.title();
  }();
  if (game_speed_.paused()) now = words_(Text::paused_state, {now});
  if (played_.practice()) now = words_(Text::practice_state, {now});
  return words_(Text::level_state,
                {words_(Text::product), title(), now, words_.number(game().score()),
                 words_.number(game().throws_left()), words_.number(game().enemies_left())});
}

}  // namespace app
