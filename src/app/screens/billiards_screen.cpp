#include "app/screens/billiards_screen.hpp"

#include <algorithm>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/hud/aim_view.hpp"
#include "app/play/grid.hpp"
#include "app/view/game_effects.hpp"
#include "app/view/table_view.hpp"

namespace app {
namespace {

namespace billiards = games::billiards;
using billiards::Obstruction;
using billiards::Phase;

enum Answer : ButtonId { yes, no };
enum EndButton : ButtonId { again, watch, leave };  // watch: in practice, take back
Text reason(Obstruction obstruction) {
  switch (obstruction) {
    case Obstruction::ball:
      return Text::on_ball;
    case Obstruction::hole:
      return Text::on_hole;
    case Obstruction::cushion:
      return Text::on_cushion;
    case Obstruction::none:
      break;
  }
  return Text::hint_place;
}

}  // namespace

BilliardsScreen::BilliardsScreen(const Words& words, Session& session, Mode mode)
    : BilliardsScreen(words, session, BilliardsRecorder(billiards::Game(options_of(session)))) {
  if (mode == Mode::practice) played_.begin_practice();
}

BilliardsScreen::BilliardsScreen(const Words& words, Session& session, BilliardsRecorder played)
    : words_(words),
      session_(session),
      played_(session, std::move(played)),
      bar_(words),
      strip_(words) {
  announce_turn(game().player(), {});
  pointer_ = viewport_.to_window(billiards::cue_start);
  follow_phase();
}

void BilliardsScreen::resize(const View& view) {
  const carom::Vec2 pointed = viewport_.to_world(pointer_);
  view_ = view;
  layout_ = GameLayout::of(view);
  if (played_.practice())
    strip_.resize(view, layout_.world.cut_bottom(PracticeStrip::height(view)));
  bar_.resize(view, layout_.bar);
  viewport_ = table_viewport(layout_.world.inset(view.px(8)), game().world().scene());
  session_.sounds.turn(viewport_.turned());
  if (question_) question_->dialog.resize(view);
  if (auto* over = std::get_if<Over>(&state_)) over->dialog.resize(view);
  // The ball in hand stays where it was carried.
  pointer_ = viewport_.to_window(pointed);
  find_pointer();
}

/// Keys and sticks find the ball in hand on the table.
void BilliardsScreen::find_pointer() {
  if (!table_area().contains(pointer_)) pointer_ = viewport_.to_window(billiards::cue_start);
}

Transition BilliardsScreen::event(const Input& input) {
  if (const auto* moved = std::get_if<PointerMoved>(&input)) pointer_ = moved->at;
  if (const auto* press = std::get_if<PointerPressed>(&input)) {
    pointer_ = press->at;
    touch_ = press->touch;
  }

  auto* launcher = std::get_if<Launcher>(&state_);
  if (game_speed_.event(
          input, !question_ && game().phase() != Phase::over && !(launcher && launcher->held()),
          std::holds_alternative<WatchShot>(state_) && !on_button()))
    return Transition::stay;
  // A key that is let go is so beneath a question, too.
  if (launcher && std::holds_alternative<KeyReleased>(input)) launcher->event(input, stage());
  if (question_) {
    const auto chosen = question_->dialog.event(input, session_.sounds);
    if (!chosen) return Transition::stay;
    const UserBar::Command about = question_->about;
    question_.reset();
    return *chosen == yes ? obey(about) : Transition::stay;
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
    const auto chosen = over->dialog.event(input, session_.sounds);
    return chosen ? finish(*chosen) : Transition::stay;
  }
  if (std::holds_alternative<PlaceBall>(state_) && steer_place(input)) return Transition::stay;
  if (Buttons::move_focus({&bar_.buttons(), played_.practice() ? &strip_.buttons() : nullptr},
                          input))
    return Transition::stay;
  if (const auto command = bar_.event(input, session_.sounds)) return request(*command);
  if (is_key(input, Key::settings)) return Transition::settings;

  if (is_key(input, Key::escape)) return request(UserBar::Command::close);
  if (is_command(input, Command::again)) return request(UserBar::Command::restart);
  const auto* press = std::get_if<PointerPressed>(&input);
  if (press && press->button == PointerButton::left && !on_button() &&
      std::holds_alternative<PlaceBall>(state_))
    place(press->at);
  return Transition::stay;
}

bool BilliardsScreen::on_button() const {
  return bar_.has_button_at(pointer_, touch_) ||
         (played_.practice() && strip_.has_button_at(pointer_, touch_));
}

Launcher::Stage BilliardsScreen::stage() const {
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

/// Arrows and sticks carry the ball in hand, Enter and Space put it down. Whether that was it.
bool BilliardsScreen::steer_place(const Input& input) {
  constexpr double key_way = 5;      // px
  constexpr double fine_way = 1;     // px
  constexpr double stick_way = 250;  // px a second
  carom::Vec2 by;
  if (const auto* key = std::get_if<KeyPressed>(&input)) {
    const double way = key->shift || key->ctrl ? fine_way : key_way;
    switch (key->key) {
      case Key::left:
        by.x = -way;
        break;
      case Key::right:
        by.x = way;
        break;
      case Key::up:
        by.y = way;
        break;
      case Key::down:
        by.y = -way;
        break;
      case Key::enter:
      case Key::space:
        if (bar_.buttons().has_focus() || strip_.buttons().has_focus()) return false;
        place(pointer_);
        return true;
      default:
        return false;
    }
  } else if (const auto* steered = std::get_if<Steered>(&input)) {
    const double way = stick_way * std::chrono::duration<double>(steered->time).count();
    by = {way * static_cast<double>(steered->across), way * static_cast<double>(steered->up)};
  } else {
    return false;
  }
  bar_.buttons().blur();
  strip_.buttons().blur();
  const carom::Scene& table = game().world().scene();
  const carom::Vec2 to = viewport_.to_world(pointer_) + viewport_.seen_as(by);
  pointer_ = viewport_.to_window(
      {std::clamp(to.x, 0.0, table.width), std::clamp(to.y, 0.0, table.height)});
  return true;
}

void BilliardsScreen::place(Point at) {
  // A place that is not free stays shown as such.
  if (played_.apply(billiards::Place{on_grid(viewport_.to_world(at))})) follow_phase();
}

/// The table with its wood, window px.
Rect BilliardsScreen::table_area() const { return table_box(viewport_, game().world().scene()); }

Transition BilliardsScreen::request(UserBar::Command command) {
  if (command == UserBar::Command::settings) return Transition::settings;
  // Nothing to lose.
  if (game().world().steps() == 0 || played_.practice()) return obey(command);
  const bool restart = command == UserBar::Command::restart;
  question_ = Question{
      Dialog(words_(restart ? Text::ask_restart : Text::ask_leave),
             {{words_(Text::game_is_lost), {}, {}}},
             {{yes, words_(restart ? Text::new_game : Text::leave), words_(Text::tip_give_up)},
              {no, words_(Text::keep_playing), words_(Text::tip_close_help)}}),
      command};
  question_->dialog.resize(view_);
  return Transition::stay;
}

Transition BilliardsScreen::obey(UserBar::Command command) {
  if (command == UserBar::Command::close) {
    played_.forget();
    return Transition::title;
  }
  played_.restart(BilliardsRecorder(billiards::Game(options_of(session_))));
  game_speed_.new_game();
  show_anew();
  announce_turn(game().player(), {});
  return Transition::stay;
}

/// The game has gone elsewhere: to its start, back, or back and on.
void BilliardsScreen::show_anew() {
  effects_.clear();
  turn_points_ = 0;
  follow_phase();
}

/// The buttons of the end: again, the replay or in practice back by a shot, the title.
Transition BilliardsScreen::finish(ButtonId button) {
  if (button != watch)
    return obey(button == again ? UserBar::Command::restart : UserBar::Command::close);
  if (played_.practice()) {
    if (played_.practise(TakeBack{}, aim_in(state_))) show_anew();
    return Transition::stay;
  }
  session_.to_watch = played_.recorder().replay();
  return Transition::replay;
}

void BilliardsScreen::follow_phase() {
  interpolator_.restart(game().world());
  clock_.reset();
  foresight_.end();
  switch (game().phase()) {
    case Phase::aim: {
      const carom::Scene& table = game().world().scene();
      Launcher launcher(
          first_aim(game().world().ball(0).position, {table.width / 2, table.height / 2}));
      if (const auto& practice = played_.practice(); practice && practice->ready())
        launcher.show(practice->plan);
      state_ = std::move(launcher);
      break;
    }
    case Phase::roll:
      turn_points_ = 0;
      state_ = WatchShot{};
      if (!session_.calm()) foresight_.begin(game());
      break;
    case Phase::place:
      find_pointer();
      state_ = PlaceBall{};
      break;
    case Phase::over:
      state_ = Over{result()};
      std::get<Over>(state_).dialog.resize(view_);
      break;
  }
}

void BilliardsScreen::keep() {
  if (!played_.keep()) effects_.announce(words_(Text::not_kept), {}, {});
}

Transition BilliardsScreen::iterate(nanoseconds elapsed) {
  // The table waits for the answer.
  if (question_ || game_speed_.paused()) return Transition::stay;
  const Speed speed = game_speed_.pass(elapsed);
  effects_.advance(speed.quarters < 4 ? elapsed * speed.quarters / 4 : elapsed);
  if (auto* launcher = std::get_if<Launcher>(&state_)) launcher->advance(elapsed);
  if (game().phase() != Phase::roll) return Transition::stay;
  for (int due = clock_.advance(elapsed, speed); due > 0 && game().phase() == Phase::roll; --due)
    step();
  return Transition::stay;
}

void BilliardsScreen::step() {
  interpolator_.record(game().world());
  const int shooter = game().player();
  played_.step();
  if (foresight_.step()) game_speed_.decisive();
  show_events(effects_, session_.sounds, game(), words_);
  for (const billiards::Event& event : game().events()) note(event, shooter);
  if (game().phase() == Phase::roll) return;
  if (game().phase() == Phase::over && !played_.practice())
    session_.last_game = {game().options().first_player, game().winner()};
  follow_phase();
  keep();
}

/// `shooter`: whose turn it was before the step.
void BilliardsScreen::note(const billiards::Event& event, int shooter) {
  using billiards::EventKind;
  switch (event.kind) {
    case EventKind::scored:
      turn_points_ += event.points;
      break;
    case EventKind::turn: {
      const std::string before = words_.player(shooter);
      std::string detail = words_(Text::cue_ball_in_hand);
      if (game().phase() != Phase::place)
        detail = turn_points_ > 0 ? words_(Text::turn_scored, {before, words_.number(turn_points_)})
                                  : words_(Text::turn_nothing, {before});
      announce_turn(event.player, detail);
      break;
    }
    case EventKind::cue_pocketed:
    case EventKind::over:
      break;
  }
}

void BilliardsScreen::announce_turn(int player, const std::string& detail) {
  if (session_.teaches()) return;  // the lesson would cover it
  effects_.announce(words_(Text::turn_of, {words_.player(player)}), detail, player);
}

Dialog BilliardsScreen::result() const {
  const std::optional<int> winner = game().winner();
  std::vector<Dialog::Line> lines{
      {.columns = {{words_.player(0), words_.player(1)}}, .heads = true}};
  const auto compare = [&](Text what, auto count) {
    lines.push_back(
        {.text = words_(what), .columns = {{words_.number(count(0)), words_.number(count(1))}}});
  };
  compare(Text::points_made, [&](int player) { return game().score(player); });
  compare(Text::balls, [&](int player) { return game().tally(player).balls; });
  compare(Text::best_turn, [&](int player) { return game().tally(player).best_turn; });
  compare(Text::shots, [&](int player) { return game().tally(player).shots; });
  compare(Text::fouls, [&](int player) { return game().tally(player).fouls; });
  return {winner ? words_(Text::wins, {words_.player(*winner)}) : words_(Text::draw),
          std::move(lines),
          {{again, words_(Text::play_again), words_(Text::tip_restart)},
           played_.practice()
               ? Dialog::Button{watch, words_(Text::take_back), words_(Text::tip_take_back)}
               : Dialog::Button{watch, words_(Text::watch_replay), words_(Text::tip_watch)},
           {leave, words_(Text::back_to_title), words_(Text::tip_title)}}};
}

std::optional<AimPrompt> BilliardsScreen::aim_prompt() const {
  if (question_ || game_speed_.paused()) return std::nullopt;
  const float radius = viewport_.px(game().world().ball(0).radius);
  if (std::holds_alternative<PlaceBall>(state_))
    return AimPrompt{pointer_, radius, Text::nudge_place};
  if (!std::holds_alternative<Launcher>(state_)) return std::nullopt;
  return AimPrompt{viewport_.to_window(game().world().ball(0).position), radius,
                   nudge(session_.settings.get().aiming.way)};
}

bool BilliardsScreen::animating() const {
  const auto* launcher = std::get_if<Launcher>(&state_);
  return !question_ && !game_speed_.paused() &&
         (game().phase() == Phase::roll || effects_.active() || (launcher && launcher->charging()));
}

void BilliardsScreen::draw(Canvas& canvas) const {
  const double fraction = game().phase() == Phase::roll ? clock_.fraction() : 1;
  draw_table(canvas.list, canvas.view.area(), viewport_, game().world().scene());
  bar_.draw(canvas, bar_content());
  canvas.list.stand_still();
  effects_.draw_under_balls(canvas.list, viewport_);
  if (!canvas.calm)
    draw_table_trails(canvas.list, viewport_, game().world(), interpolator_, fraction);
  draw_balls(canvas.list, viewport_, game().world(), interpolator_, fraction);
  const auto* launcher = std::get_if<Launcher>(&state_);
  if (launcher) {
    const carom::Ball cue = game().world().ball(0);
    if (const auto to = launcher->pulled_to()) draw_sling(canvas.list, viewport_, cue, *to);
    if (launcher->aim.active())
      draw_aim(canvas.list, viewport_, game().world(), launcher->aim,
               previewer_.of(game().world(), launcher->aim, session_.settings.get().aiming,
                             played_.practice().has_value()));
    else
      draw_invitation(canvas.list, viewport_, cue,
                      !touch_ && on_lead(cue, pointer_, viewport_, view_),
                      canvas.list.palette->accents[static_cast<std::size_t>(game().player())]);
  }
  if (std::holds_alternative<PlaceBall>(state_)) draw_cue_ball_in_hand(canvas);
  effects_.draw_over_balls(canvas, viewport_, table_area());
  game_speed_.draw_veil(canvas, layout_.world, words_);
  if (played_.practice()) strip_.draw(canvas);
  draw_footer(canvas, layout_.footer, launcher ? &launcher->aim : nullptr,
              launcher && launcher->entry ? &*launcher->entry : nullptr, words_, hint(),
              hint_color(*canvas.list.palette),
              launcher && launcher->offers_shot(session_.settings.get().aiming.way, touch_));
  if (const auto* over = std::get_if<Over>(&state_)) over->dialog.draw(canvas);
  if (question_) question_->dialog.draw(canvas);
}

void BilliardsScreen::draw_cue_ball_in_hand(Canvas& canvas) const {
  if (!table_area().contains(pointer_)) return;
  DrawList& list = canvas.list;
  const float r = viewport_.px(game().world().ball(0).radius);
  const Obstruction obstruction = game().obstruction(on_grid(viewport_.to_world(pointer_)));
  if (obstruction == Obstruction::none) {
    draw_ball_shadow(list, pointer_, r);
    draw_ball(list, pointer_, r, BallKind::ivory);
    stroke_circle(list, pointer_, r * 1.8f, viewport_.px(2), canvas.list.palette->allowed);
    return;
  }
  // A dark ground first: the sign must stand out among red balls.
  fill_disc(list, pointer_, r * 2.1f, faded(palette::ink, 0.75f));
  draw_ball(list, pointer_, r, look_of(BallKind::ivory, *list.palette), 0.6f);
  dashed_circle(list, pointer_, r * 1.7f, viewport_.px(2.6), 8, canvas.list.palette->refused);
  const float arm = r * 0.8f;
  for (const float side : {-1.0f, 1.0f})
    line(list, pointer_ + Point{-arm, -arm * side}, pointer_ + Point{arm, arm * side},
         viewport_.px(3.4), rgb(0xc22a1c));
  const TextStyle style{Face::bold, 16, canvas.list.palette->refused};
  const std::string words = words_(reason(obstruction));
  const Point above = pointer_ - Point{0, r * 1.8f + canvas.px(22)};
  pill(canvas, pill_box(canvas, above, table_area(), style, words), style, words);
}

std::string BilliardsScreen::hint() const {
  const auto* launcher = std::get_if<Launcher>(&state_);
  const bool idle = launcher ? !launcher->aim.active() && !launcher->missed()
                             : std::holds_alternative<WatchShot>(state_);
  if (const auto& practice = played_.practice(); practice && practice->plan.active() && idle)
    return words_(Text::hint_repeat,
                  {session_.keyboard.name(Command::again), practised(words_, practice->plan)});
  if (launcher)
    return words_(aim_hint(*launcher, session_.settings.get().aiming.way, touch_,
                           {Text::hint_take_cue_ball, Text::hint_not_cue_ball, Text::hint_shoot}));
  if (std::holds_alternative<PlaceBall>(state_)) {
    const Obstruction obstruction = game().obstruction(on_grid(viewport_.to_world(pointer_)));
    if (obstruction != Obstruction::none)
      return words_(Text::hint_obstructed, {words_(reason(obstruction))});
    return words_(Text::hint_place);
  }
  return std::holds_alternative<WatchShot>(state_)
             ? words_(Text::hint_watch, {session_.keyboard.name(Command::fast),
                                         session_.keyboard.name(Command::pause)})
             : std::string();
}

Color BilliardsScreen::hint_color(const Palette& palette) const {
  if (const auto* launcher = std::get_if<Launcher>(&state_))
    return launcher->missed() ? palette.refused : palette::cream;
  if (std::holds_alternative<PlaceBall>(state_)) {
    const bool free =
        game().obstruction(on_grid(viewport_.to_world(pointer_))) == Obstruction::none;
    return free ? palette.allowed : palette.refused;
  }
  return palette::muted;
}

BilliardsBar::Content BilliardsScreen::bar_content() const {
  BilliardsBar::Content content;
  content.scores = {game().score(0), game().score(1)};
  if (game().phase() != Phase::over) content.on = game().player();
  content.balls_left = game().reds_left();
  content.turn_points = game().turn_points();
  return content;
}

std::string BilliardsScreen::describe() const {
  const std::string player = words_.player(game().player());
  std::string now = question_ ? question_->dialog.title() : [&] {
    switch (game().phase()) {
      case Phase::aim:
        return words_(Text::aiming, {player});
      case Phase::roll:
        return words_(Text::watching, {player});
      case Phase::place:
        return words_(Text::placing, {player});
      case Phase::over:
        break;
    }
    return std::get<Over>(state_).dialog.title();
  }();
  if (game_speed_.paused()) now = words_(Text::paused_state, {now});
  if (played_.practice()) now = words_(Text::practice_state, {now});
  return words_(Text::state, {words_(Text::product), now, words_.number(game().score(0)),
                              words_.number(game().score(1)), words_.number(game().reds_left()),
                              words_.player(0), words_.player(1)});
}

}  // namespace app
