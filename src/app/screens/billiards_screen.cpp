#include "app/screens/billiards_screen.hpp"

#include <utility>

#include "app/graphics/palette.hpp"
#include "app/play/first_aim.hpp"
#include "app/play/table_match.hpp"
#include "games/launch.hpp"

namespace app {

namespace billiards = games::billiards;
using billiards::Phase;

BilliardsScreen::BilliardsScreen(const Words& words, Session& session, Mode mode)
    : BilliardsScreen(words, session, new_table(session, mode == Mode::practice)) {
  if (mode == Mode::practice) played_.begin_practice();
}

BilliardsScreen::BilliardsScreen(const Words& words, Session& session, BilliardsRecorder played,
                                 KeptGames::Place place)
    : PlayScreen(words.with_computers(played.occasion().computer), session, played,
                 std::move(place), WorldView(played.game().world().scene(), false)),
      bar_(words_) {
  pointer_ = viewport().to_window(billiards::cue_start);
  begin();
}

BilliardsScreen::Doing BilliardsScreen::doing() const {
  if (resigned_) return Doing::over;
  switch (game().phase()) {
    case Phase::aim:
      return Doing::aim;
    case Phase::roll:
      return Doing::watch;
    case Phase::place:
      return Doing::wait;
    case Phase::over:
      break;
  }
  return Doing::over;
}

carom::Vec2 BilliardsScreen::first_drag() const {
  return first_aim(game().world(), carom::Role::red);
}

bool BilliardsScreen::start_again() {
  if (played_.practice())
    played_.restart(new_table(session_, true));
  else if (doing() == Doing::over)
    played_.restart(next_table(session_, played_.recorder(), winner()));
  else
    played_.restart(same_table(session_, played_.recorder()));
  resigned_.reset();
  return true;
}

std::optional<ComputerTurn> BilliardsScreen::computer_turn() const {
  return resigned_ ? std::nullopt : ComputerTurn::begin(game(), occasion());
}

void BilliardsScreen::play(const search::Decision& decision) {
  // The search tried them on this very table: the game takes both.
  if (decision.meant.place) played_.apply(billiards::Place{*decision.meant.place});
  Aim aim;
  aim.set(decision.drag);
  played_.launch(aim);
}

bool BilliardsScreen::can_resign() const {
  return doing() != Doing::over && (occasion().computer[0] > 0) != (occasion().computer[1] > 0);
}

void BilliardsScreen::resign() {
  resigned_ = occasion().computer[0] > 0 ? 1 : 0;
  session_.last_game = {game().options().first_player, winner()};
  played_.give_up();
  follow_phase();
}

void BilliardsScreen::note(const Event& event) {
  using billiards::EventKind;
  switch (event.kind) {
    case EventKind::scored:
      turn_points_ += event.points;
      break;
    case EventKind::turn: {
      const std::string before = words_.player(shooter_);
      std::string detail = words_(missed_ ? Text::missed_all : Text::cue_ball_in_hand);
      if (game().phase() != Phase::place)
        detail = turn_points_ > 0 ? words_(Text::turn_scored, {before, words_.number(turn_points_)})
                                  : words_(Text::turn_nothing, {before});
      announce_turn(detail);
      break;
    }
    case EventKind::over:
      if (!game().options().alone)
        session_.last_game = {game().options().first_player, game().winner()};
      break;
    case EventKind::missed:
      missed_ = true;
      break;
    case EventKind::cue_pocketed:
      break;
  }
}

void BilliardsScreen::announce_turn(const std::string& detail) {
  // The lesson would cover it; who plays alone needs none but for a ball in hand.
  const bool alone = game().options().alone;
  if (session_.teaches() || (alone && game().phase() != Phase::place)) return;
  if (alone) return effects_.announce(detail, {}, {});
  effects_.announce(words_(Text::turn_of, {words_.player(game().player())}), detail,
                    game().player());
}

Over BilliardsScreen::ending() {
  if (game().options().alone && !played_.practice()) return cleared();
  const std::optional<int> winner = this->winner();
  const bool match = occasion().best_of > 1;
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
  if (hints() > 0)
    lines.push_back(
        {words_(Text::key_line, {words_(Text::hints_used), words_.number(hints())}), {}, {}});
  if (match)
    compare(Text::games_won, [&, won = games_won(occasion(), winner)](int player) {
      return won[static_cast<std::size_t>(player)];
    });
  const bool goes_on = match && !match_winner(occasion(), winner);
  const bool computer = occasion().computer != std::array{0, 0};
  std::vector<Dialog::Button> buttons = end_buttons(goes_on    ? Text::next_game
                                                    : computer ? Text::rematch
                                                               : Text::play_again);
  if (!played_.practice())
    buttons.push_back({review, words_(Text::review), words_(Text::tip_review)});
  buttons.push_back({leave, words_(Text::back_to_title), words_(Text::tip_title)});
  const Text wins = match && !goes_on ? Text::wins_match : Text::wins;
  return {Dialog(winner ? words_(wins, {words_.player(*winner)}) : words_(Text::draw),
                 std::move(lines), std::move(buttons))};
}

/// The end of a game alone: how many shots it took, and the best so far.
Over BilliardsScreen::cleared() {
  const int shots = game().tally(0).shots;
  const std::size_t place = session_.alone.record(game().options(), shots);
  std::vector<Dialog::Line> lines;
  if (place == 1) lines.push_back({words_(Text::new_best), {}, {}});
  std::string list;
  for (const int fewest : session_.alone.of(game().options()))
    list += (list.empty() ? "" : " · ") + words_.number(fewest);
  lines.push_back({words_(Text::fewest, {list}), {}, {}});
  lines.push_back(
      {words_(Text::key_line, {words_(Text::fouls), words_.number(game().tally(0).fouls)}),
       {},
       {}});
  if (hints() > 0)
    lines.push_back(
        {words_(Text::key_line, {words_(Text::hints_used), words_.number(hints())}), {}, {}});
  std::vector<Dialog::Button> buttons = end_buttons();
  buttons.push_back({leave, words_(Text::back_to_title), words_(Text::tip_title)});
  return {
      Dialog(words_(Text::cleared, {words_.number(shots)}), std::move(lines), std::move(buttons))};
}

PlaceBall::Stage BilliardsScreen::stage() const {
  return {.game = game(),
          .viewport = viewport(),
          .table = world_view_.box(),
          .pointer = pointer_,
          .on_button = on_button(),
          .focus_elsewhere = focus_elsewhere()};
}

/// Keys and sticks find the ball in hand on the table.
void BilliardsScreen::find_pointer() {
  if (!world_view_.box().contains(pointer_)) pointer_ = viewport().to_window(billiards::cue_start);
}

BilliardsScreen::Handled BilliardsScreen::waiting_event(PlaceBall& place, const Input& input) {
  const PlaceBall::Outcome outcome = place.event(input, stage());
  if (outcome == PlaceBall::Outcome::untouched) return std::nullopt;
  pointer_ = place.to;
  blur();
  // A place that is not free stays shown as such.
  if (outcome == PlaceBall::Outcome::put &&
      played_.apply(billiards::Place{games::on_grid(viewport().to_world(pointer_))})) {
    follow_phase();
    keep();
  }
  return Stay{};
}

void BilliardsScreen::draw_waiting(Canvas& canvas, const PlaceBall&, bool over_effects) const {
  if (!over_effects) PlaceBall::draw(canvas, words_, stage());
}

std::optional<AimPrompt> BilliardsScreen::waiting_prompt() const {
  return AimPrompt{pointer_, viewport().px(game().world().ball(0).radius), Text::nudge_place};
}

Color BilliardsScreen::lead_color(const Palette& palette) const {
  return palette.accents[static_cast<std::size_t>(game().player())];
}

void BilliardsScreen::draw_bar(Canvas& canvas) const {
  BilliardsBar::Content content;
  content.scores = {game().score(0), game().score(1)};
  if (game().phase() != Phase::over) content.on = game().player();
  content.balls_left = game().reds_left();
  content.turn_points = game().turn_points();
  if (game().options().alone) content.shots = game().tally(0).shots;
  bar_.draw(canvas, content);
}

std::string BilliardsScreen::now() const {
  const std::string player = words_.player(game().player());
  if (resigned_) return end_title();
  if (thinking()) return words_(Text::thinking, {player});
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
  return end_title();
}

std::string BilliardsScreen::state_line(const std::string& now) const {
  if (game().options().alone && !played_.practice()) {
    const auto count = [&](Text what, int number) {
      return " · " + words_(Text::key_line, {words_(what), words_.number(number)});
    };
    return words_(Text::product) + " · " + now + count(Text::shots, game().tally(0).shots) +
           count(Text::balls_left, game().reds_left());
  }
  return words_(Text::state, {words_(Text::product), now, words_.number(game().score(0)),
                              words_.number(game().score(1)), words_.number(game().reds_left()),
                              words_.player(0), words_.player(1)});
}

}  // namespace app
