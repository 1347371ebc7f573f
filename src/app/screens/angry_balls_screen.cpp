#include "app/screens/angry_balls_screen.hpp"

#include <utility>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/play/first_aim.hpp"
#include "app/view/level_view.hpp"

namespace app {
namespace {

namespace angry_balls = games::angry_balls;
using angry_balls::Phase;

constexpr nanoseconds epilogue_time = milliseconds{1200};
constexpr nanoseconds go_on_after = milliseconds{1500};
constexpr int needless_clicks = 3;           ///< before a player is asked
constexpr double trace_spacing = 0.016;      ///< of the level's width, between the dots
constexpr std::size_t longest_trace = 1000;  ///< dots

}  // namespace

AngryBallsScreen::AngryBallsScreen(const Words& words, Session& session)
    : AngryBallsScreen(
          words, session,
          LevelRecorder(angry_balls::Game::create(
                            session.campaign.levels[session.campaign.current].scene.value())
                            .value())) {
  if (campaign_.practice) played_.begin_practice();
}

AngryBallsScreen::AngryBallsScreen(const Words& words, Session& session, LevelRecorder played,
                                   KeptGames::Place place)
    : PlayScreen(words, session, played, std::move(place), WorldView(played.game().level(), true)),
      campaign_(session.campaign),
      bar_(words) {
  begin();
}

void AngryBallsScreen::announce_start() {
  if (session_.teaches()) return;  // the lesson would cover it
  effects_.announce(title(),
                    words_(Text::goal, {words_.number(game().enemies_left()),
                                        words_.number(game().throws_left())}),
                    {});
}

/// "Level 1: First steps".
std::string AngryBallsScreen::title() const {
  return words_(Text::level_and_name, {words_.number(static_cast<int>(campaign_.current) + 1),
                                       shown_name(words_, campaign_.levels[campaign_.current])});
}

AngryBallsScreen::Doing AngryBallsScreen::doing() const {
  switch (game().phase()) {
    case Phase::aim:
      return Doing::aim;
    case Phase::fly:
      return Doing::watch;
    case Phase::offer:
      return Doing::wait;
    case Phase::won:
    case Phase::lost:
      break;
  }
  return Doing::over;
}

bool AngryBallsScreen::moving() const {
  if (const auto* over = std::get_if<Over>(&state_)) return over->wait > nanoseconds{0};
  // A level left alone for an hour stands still rather than outgrow what can be kept and watched.
  return game().phase() == Phase::fly ||
         (game().phase() == Phase::offer && played_.recorder().has_room());
}

bool AngryBallsScreen::continues() const {
  return game().phase() != Phase::aim && game().phase() != Phase::fly;
}

carom::Vec2 AngryBallsScreen::first_drag() const {
  return played_.last_drag().value_or(first_aim(game().world(), carom::Role::enemy));
}

void AngryBallsScreen::after_step() {
  const carom::World& world = game().world();
  if (!world.in_play(0) || trace_.size() >= longest_trace) return;
  const carom::Vec2 at = world.ball(0).position;
  const carom::Vec2 last = trace_.empty() ? game().launch_place() : trace_.back();
  if (carom::length(at - last) >= trace_spacing * game().level().width) trace_.push_back(at);
}

Navigation AngryBallsScreen::levels_changed() {
  if (campaign_.levels[campaign_.current].identity == level_in_play()) return Stay{};
  return PlayLevel{campaign_.current, played_.practice().has_value()};
}

Navigation AngryBallsScreen::next_game() {
  return PlayLevel{*campaign_.next(), played_.practice().has_value()};
}

Over AngryBallsScreen::ending() {
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
  if (hints() > 0)
    lines.push_back(
        {words_(Text::key_line, {words_(Text::hints_used), words_.number(hints())}), {}, {}});
  std::vector<Dialog::Button> buttons = end_buttons();
  buttons.push_back({leave, words_(Text::menu), words_(Text::tip_menu)});
  if (won && campaign_.next())
    buttons.insert(buttons.begin(),
                   {go_on, words_(Text::next_level), words_(Text::tip_next_level)});
  return {Dialog(words_(won ? Text::won : Text::lost), std::move(lines), std::move(buttons)),
          game().world(), won ? epilogue_time : nanoseconds{0}};
}

AngryBallsScreen::Handled AngryBallsScreen::waiting_event(NextOffer& offer, const Input& input) {
  if (!offer.event(input, focus_elsewhere(), on_button(), session_.sounds)) return std::nullopt;
  blur();
  if (stillness_.still()) ++session_.needless_clicks;
  take_next();
  return Stay{};
}

void AngryBallsScreen::take_next() {
  if (played_.apply(angry_balls::Next{})) happened();
}

void AngryBallsScreen::pass_waiting(nanoseconds elapsed) {
  stillness_.look(game().world());
  if (!stillness_.still()) return;
  still_for_ += elapsed;
  if (session_.settings.get().go_on && still_for_ >= go_on_after) take_next();
}

/// Once, a player who clicks where nothing can change any more is asked.
std::optional<Ask> AngryBallsScreen::own_window() {
  const Settings& settings = session_.settings.get();
  const bool between = game().phase() == Phase::aim && game().throws_left() < game().level().throws;
  if (settings.go_on || settings.go_on_offered || !between ||
      session_.needless_clicks < needless_clicks)
    return std::nullopt;
  Settings changed = settings;
  changed.go_on_offered = true;
  session_.settings.set(std::move(changed));
  return Ask{.dialog = Dialog(words_(Text::ask_go_on), {{words_(Text::ask_go_on_line), {}, {}}},
                              {{yes, words_(Text::yes), words_(Text::tip_go_on)},
                               {no, words_(Text::no), words_(Text::tip_go_on)}}),
             .line = state_line(words_(Text::ask_go_on))};
}

void AngryBallsScreen::own_answer(ButtonId button) {
  Settings settings = session_.settings.get();
  settings.go_on = button == yes;
  session_.settings.set(std::move(settings));
}

Buttons* AngryBallsScreen::waiting_buttons() {
  auto* offer = std::get_if<NextOffer>(&state_);
  return offer ? &offer->buttons() : nullptr;
}

void AngryBallsScreen::place_waiting(NextOffer& offer) {
  const bool more = game().throws_left() > 0;
  offer.place(
      view_, layout_.world,
      words_(more ? Text::next_throw : Text::finish, {session_.keyboard.name(Command::next)}),
      words_(more ? Text::tip_next : Text::tip_finish));
}

void AngryBallsScreen::draw_waiting(Canvas& canvas, const NextOffer& offer,
                                    bool over_effects) const {
  if (over_effects) offer.draw(canvas);
}

std::string AngryBallsScreen::waiting_hint() const {
  return words_(game().throws_left() > 0 ? Text::hint_next : Text::hint_finish,
                {session_.keyboard.name(Command::next)});
}

Rect AngryBallsScreen::effects_area(const Canvas& canvas) const {
  Rect free = layout_.world.inset(canvas.px(4));
  if (game().phase() == Phase::offer) free.cut_top(canvas.px(64));
  return free;
}

bool AngryBallsScreen::bar_is_last() const {
  const auto* over = std::get_if<Over>(&state_);
  return effects_.active() ||
         any_above(layout_.world, viewport(), over ? *over->epilogue : game().world());
}

void AngryBallsScreen::draw_bar(Canvas& canvas) const {
  LevelBar::Content content;
  content.number = static_cast<int>(campaign_.current) + 1;
  content.name = shown_name(words_, campaign_.levels[campaign_.current]);
  content.score = game().score();
  content.turn_points = turn_points_;
  content.throws_left = game().throws_left();
  content.enemies_left = game().enemies_left();
  bar_.draw(canvas, content);
  fill_rounded(canvas.list, layout_.footer, 0,
               Paint::vertical(layout_.footer, palette::slate_top, palette::slate_bottom));
}

/// Where the last throw went: dashes, dark and thin, as the next throw's dots are round and light.
void AngryBallsScreen::draw_ground(Canvas& canvas) const {
  const float width = std::max(viewport().px(2), 1.5f);
  for (std::size_t i = 1; i < trace_.size(); i += 2)
    line(canvas.list, viewport().to_window(trace_[i - 1]), viewport().to_window(trace_[i]), width,
         faded(palette::ink, 0.55f));
}

std::string AngryBallsScreen::now() const {
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
  return end_title();
}

std::string AngryBallsScreen::state_line(const std::string& now) const {
  return words_(Text::level_state,
                {words_(Text::product), title(), now, words_.number(game().score()),
                 words_.number(game().throws_left()), words_.number(game().enemies_left())});
}

}  // namespace app
