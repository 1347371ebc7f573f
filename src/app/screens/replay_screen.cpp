#include "app/screens/replay_screen.hpp"

#include <array>
#include <numeric>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/hud/shot_view.hpp"
#include "app/screens/load_screen.hpp"
#include "app/screens/replay_list.hpp"
#include "app/screens/timeline.hpp"
#include "app/view/game_effects.hpp"
#include "app/view/game_sounds.hpp"

namespace app {
namespace {

enum Button : ButtonId { previous, play, one, following, slower, faster, keep, copy_text, close };

struct NamedSpeed {
  Speed speed;
  std::string_view name;
};
constexpr std::array<NamedSpeed, 7> speeds{{{slow_motion, "¼"},
                                            {{2}, "½"},
                                            {real_speed, "1"},
                                            {{8}, "2"},
                                            {fast_forward, "4"},
                                            {{32}, "8"},
                                            {{64}, "16"}}};
constexpr std::size_t first_speed = 2;

/// Turn and status stand below the buttons, the players are not named.
bool tight(const View& view) { return view.width < view.px(960); }

}  // namespace

ReplayScreen::ReplayScreen(const Words& words, Session& session, replay::Player player,
                           std::optional<std::size_t> turn, std::optional<search::Shot> better)
    : words_(words.with_computers(player.replay().occasion.computer)),
      session_(session),
      player_(std::move(player)),
      better_turn_(turn),
      better_(better),
      wanted_(turn),
      playing_(!turn),
      speed_(first_speed),
      buttons_({{previous, words(Text::previous_turn), words(Text::tip_previous_turn)},
                {play, words(Text::pause), words(Text::tip_play)},
                {one, words(Text::one_step), words(Text::tip_step)},
                {following, words(Text::following_turn), words(Text::tip_following_turn)},
                {slower, words(Text::slower), words(Text::tip_slower)},
                {faster, words(Text::faster), words(Text::tip_faster)},
                {keep, words(Text::save_replay), words(Text::tip_save)},
                {copy_text, words(Text::copy), words(Text::tip_copy)},
                {close, words(Text::close), words(Text::tip_close_replay)}}),
      world_view_(player_.replay().level.value_or(replay::world(player_.game()).scene()),
                  player_.replay().level.has_value()) {
  interpolator_.record(replay::world(player_.game()));
}

void ReplayScreen::resize(const View& view) {
  view_ = view;
  constexpr std::array tips{Text::tip_previous_turn,  Text::tip_play,   Text::tip_step,
                            Text::tip_following_turn, Text::tip_slower, Text::tip_faster,
                            Text::tip_save,           Text::tip_copy,   Text::tip_close_replay};
  for (std::size_t i = 0; i < tips.size(); ++i) buttons_.explain(i, words_(tips[i]));
  const bool narrow = view.narrow();
  const float gap = view.px(6);
  Rect rest = view.area();
  const float height = view.button(40);
  top_ = rest.cut_top(height + view.px(narrow ? 60 : 24));
  bottom_ = rest.cut_bottom(height + view.px(tight(view) ? 98 : 84));

  const float width = view.px(narrow ? 760 : 1120);
  Rect top = centered(top_.center(), std::min(top_.w, width), top_.h).inset(view.px(8));
  Rect commands = narrow ? top.cut_bottom(height) : top.cut_right(view.px(336));
  for (const Button button : {keep, copy_text, close}) {
    const auto left = static_cast<float>(close - button + 1);
    buttons_.place(view, button, commands.cut_left((commands.w - gap * (left - 1)) / left));
    commands.cut_left(gap);
  }
  if (!narrow) top.cut_right(gap * 2);
  score_ = top.cut_right(std::round(top.w * 0.45f));
  top.cut_right(gap);
  name_ = top;

  Rect bottom = centered(bottom_.center(), std::min(bottom_.w, width), bottom_.h)
                    .inset(view.px(8), view.px(6));
  timeline_ = bottom.cut_top(view.px(24));
  bottom.cut_top(view.px(8));
  Rect row = bottom.cut_top(height);
  bottom.cut_top(view.px(4));
  hint_ = bottom.cut_bottom(view.px(26));
  const float between = std::min(gap, row.w * 0.008f);
  // For fingers the least ones are wider, at the cost of the others.
  constexpr std::array plain{76.0f, 84.0f, 64.0f, 76.0f, 44.0f, 52.0f, 44.0f};
  constexpr std::array fingers{71.0f, 76.0f, 59.0f, 71.0f, 54.0f, 45.0f, 54.0f};
  const auto& widths = view.touch ? fingers : plain;
  const float wanted = view.px(std::accumulate(widths.begin(), widths.end(), 0.0f)) + 6 * between;
  // On a phone all of them are narrower together.
  const float part = std::min(1.0f, (row.w - 6 * between) / (wanted - 6 * between));
  const float controls_width = std::min(wanted, row.w);
  if (tight(view)) {
    status_ = bottom;
    turn_ = status_.cut_left(std::round(status_.w * 0.54f));
    status_.cut_left(gap);
    row = centered(row.center(), controls_width, row.h);
  } else {
    const float side = (row.w - controls_width) / 2 - gap;
    turn_ = row.cut_left(side);
    row.cut_left(gap);
    status_ = row.cut_right(side);
    row.cut_right(gap);
  }
  const auto next = [&](float units) {
    const Rect box = row.cut_left(view.px(units) * part);
    row.cut_left(between);
    return box;
  };
  buttons_.place(view, previous, next(widths[0]));
  buttons_.place(view, play, next(widths[1]));
  buttons_.place(view, one, next(widths[2]));
  buttons_.place(view, following, next(widths[3]));
  buttons_.place(view, slower, next(widths[4]));
  speed_label_ = next(widths[5]);
  buttons_.place(view, faster, next(widths[6]));

  world_view_.fit(rest, view.px(6));
  session_.sounds.turn(world_view_.viewport().turned());
}

Navigation ReplayScreen::event(const Input& input) {
  const auto* press_at = std::get_if<PointerPressed>(&input);
  if (press_at && press_at->button == PointerButton::left && timeline_.contains(press_at->at))
    seek(turn_at(timeline_, player_, press_at->at));
  if (const auto* key = std::get_if<KeyPressed>(&input)) {
    switch (key->key) {
      case Key::space:
        return press(play);
      case Key::period:
        return press(one);
      case Key::left:
        return press(previous);
      case Key::right:
        return press(following);
      case Key::plus:
      case Key::up:
        return press(faster);
      case Key::minus:
      case Key::down:
        return press(slower);
      case Key::copy:
        return press(copy_text);
      case Key::escape:
        if (!buttons_.has_focus()) return Back{};
        buttons_.blur();
        return Stay{};
      default:
        break;
    }
  }
  if (is_command(input, Command::pause)) return press(play);
  const auto chosen = buttons_.event(input, session_.sounds);
  return chosen ? press(*chosen) : Stay{};
}

Navigation ReplayScreen::press(ButtonId button) {
  message_.clear();
  const std::size_t now = wanted_.value_or(player_.turn());
  const bool at_end = ended_ && !wanted_;
  switch (static_cast<Button>(button)) {
    case previous: {
      // First to the start of the turn that is shown.
      const auto& turns = player_.turns();
      const bool inside = !wanted_ && !turns.empty() && player_.steps() > turns[now].first_step;
      seek(inside || now == 0 ? now : now - 1);
      break;
    }
    case following:
      if (!at_end) seek(now + 1);
      break;
    case play:
      play_or_pause();
      break;
    case one:
      playing_ = false;
      wanted_.reset();
      step();
      break;
    case slower:
      change_speed(-1);
      break;
    case faster:
      change_speed(1);
      break;
    case keep:
      save();
      break;
    case copy_text:
      copy();
      break;
    case close:
      return Back{};
  }
  buttons_.relabel(play, words_(playing_ ? Text::pause : Text::play));
  return Stay{};
}

void ReplayScreen::play_or_pause() {
  if (!playing_ && ended_) seek(0);
  playing_ = !playing_;
  clock_.reset();
}

void ReplayScreen::change_speed(int by) {
  const auto wanted = static_cast<std::ptrdiff_t>(speed_) + by;
  if (wanted >= 0 && wanted < static_cast<std::ptrdiff_t>(speeds.size()))
    speed_ = static_cast<std::size_t>(wanted);
}

void ReplayScreen::seek(std::size_t turn) {
  wanted_ = std::min(turn, player_.turns().size());
  go_where_wanted();
}

/// As soon as the look-ahead has been there, and no further than it can go.
void ReplayScreen::go_where_wanted() {
  if (!wanted_) return;
  const bool is_end = *wanted_ >= player_.reached_turns();
  if (is_end && !complete_) return;
  const std::size_t turn = is_end ? player_.turns().size() : *wanted_;
  if (player_.seek(turn, steps_at_once(player_)) == replay::Sought::on_way) return;
  wanted_.reset();
  ended_ = is_end;
  if (ended_) playing_ = false;
  effects_.clear();
  clock_.reset();
  interpolator_.restart(replay::world(player_.game()));
}

void ReplayScreen::step() {
  const auto& turns = player_.turns();
  const std::uint64_t before = player_.steps();
  const bool begins = !turns.empty() && before == turns[player_.turn()].first_step;
  interpolator_.record(replay::world(player_.game()));
  if (!player_.step()) {
    ended_ = true;
    playing_ = false;
    return;
  }
  // A ball that was put down has not rolled there.
  const carom::World& world = replay::world(player_.game());
  if (begins) interpolator_.restart(world);
  if (begins && player_.steps() != before && world.in_play(0))
    note_launch(session_.sounds, world.ball(0), world.scene());
  std::visit([&](const auto& game) { show_events(effects_, session_.sounds, game, words_); },
             player_.game());
}

Navigation ReplayScreen::iterate(nanoseconds elapsed) {
  effects_.advance(elapsed);
  if (!complete_) complete_ = !player_.look_ahead(steps_at_once(player_));
  go_where_wanted();
  if (playing_ && !wanted_) {
    auto due = std::min(static_cast<std::uint64_t>(clock_.advance(elapsed, speeds[speed_].speed)),
                        steps_at_once(player_));
    for (; due > 0 && playing_; --due) step();
  }
  buttons_.relabel(play, words_(playing_ ? Text::pause : Text::play));
  return Stay{};
}

bool ReplayScreen::animating() const {
  return playing_ || !complete_ || wanted_ || effects_.active();
}

void ReplayScreen::save() {
  // The hashes that a text leaves out come from playing it.
  const bool is_short = player_.replay().short_hashes;
  if (is_short && !complete_) {
    message_ = words_(Text::verifying);
    return;
  }
  if (is_short && player_.divergence()) {
    message_ = words_(Text::replay_not_saved);
    return;
  }
  const auto name = session_.saved.save(is_short ? player_.with_full_hashes() : player_.replay());
  message_ = name ? words_(Text::replay_saved, {name.value()}) : words_(Text::replay_not_saved);
}

void ReplayScreen::copy() {
  const bool copied = session_.clipboard.set_text(shared_text(session_, player_.replay()));
  message_ = words_(copied ? Text::replay_copied : Text::replay_not_copied);
}

void ReplayScreen::draw(Canvas& canvas) const {
  draw_world(canvas);
  draw_top(canvas);
  draw_bottom(canvas);
}

void ReplayScreen::draw_better(Canvas& canvas) const {
  const bool there = better_ && !wanted_ && player_.turn() == better_turn_ &&
                     player_.steps() == player_.turns()[*better_turn_].first_step;
  if (there)
    draw_shot(canvas.list, world_view_.viewport(), std::get<games::billiards::Game>(player_.game()),
              *better_, previewer_);
}

void ReplayScreen::draw_world(Canvas& canvas) const {
  DrawList& list = canvas.list;
  const std::size_t begin = list.vertices.size();
  const Viewport& viewport = world_view_.viewport();
  world_view_.draw_still(canvas);
  list.stand_still();
  effects_.draw_under_balls(list, viewport);
  world_view_.draw_moving(canvas, replay::world(player_.game()), interpolator_,
                          playing_ ? clock_.fraction() : 1);
  if (canvas.shake) effects_.shake(list, begin, world_view_.area());
  draw_better(canvas);
  effects_.draw_over_balls(canvas, viewport, world_view_.area().inset(canvas.px(4)),
                           replay::world(player_.game()));
}

void ReplayScreen::draw_top(Canvas& canvas) const {
  DrawList& list = canvas.list;
  fill_rounded(list, top_, 0, Paint::vertical(top_, palette::slate_top, palette::slate_bottom));
  line(list, {top_.x, top_.bottom()}, {top_.right(), top_.bottom()}, canvas.px(1),
       palette::brass_dark);
  const TextStyle name{Face::bold, 22, palette::cream};
  label(canvas, name_, name, elided(canvas, name, title(), name_.w));
  label(canvas, score_, {Face::bold, 18, palette::brass_lit, Align::right}, score());
}

void ReplayScreen::draw_bottom(Canvas& canvas) const {
  DrawList& list = canvas.list;
  fill_rounded(list, bottom_, 0,
               Paint::vertical(bottom_, palette::slate_top, palette::slate_bottom));
  line(list, {bottom_.x, bottom_.y}, {bottom_.right(), bottom_.y}, canvas.px(1),
       palette::brass_dark);
  draw_timeline(canvas, timeline_, bottom_, player_);
  buttons_.draw(canvas);
  label(canvas, speed_label_, {Face::bold, 20, palette::cream, Align::center},
        words_(Text::times, {speeds[speed_].name}));
  label(canvas, turn_, {Face::bold, 17, palette::cream}, turn());
  label(canvas, status_, {Face::bold, 17, status_color(*list.palette), Align::right}, status());
  const TextStyle hint{Face::regular, 16, message_.empty() ? palette::muted : list.palette->allowed,
                       Align::center};
  label(canvas, hint_, hint,
        elided(canvas, hint, message_.empty() ? words_(Text::hint_replay) : message_, hint_.w));
}

std::string ReplayScreen::title() const {
  const auto& level = player_.replay().level;
  if (!level) return table_name(words_, player_.replay());
  return shown_name(words_, session_.campaign.known(*level));
}

std::string ReplayScreen::score() const {
  const auto points = replay::score(player_.game());
  if (player_.replay().level) return words_(Text::score) + " " + words_.number(points[0]);
  return words_(tight(view_) ? Text::score_pair : Text::kept_billiards,
                {words_.number(points[0]), words_.number(points[1])});
}

std::string ReplayScreen::turn() const {
  const auto& turns = player_.turns();
  const std::size_t now = wanted_.value_or(player_.turn());
  // Where the game diverges, the turn that it went wrong in.
  const std::size_t last = complete_ ? player_.reached_turns() : turns.size();
  const std::size_t shown = std::min(now, std::max<std::size_t>(last, 1) - 1);
  const std::string number = words_.number(turns.empty() ? 0 : static_cast<int>(shown) + 1);
  const std::string all = words_.number(static_cast<int>(turns.size()));
  if (player_.replay().level || shown >= player_.reached_turns())
    return words_(Text::turn_of_turns, {number, all});
  return words_(Text::turn_of_player, {number, all, words_.number(turns[shown].player + 1)});
}

std::string ReplayScreen::status() const {
  if (const auto& wrong = player_.divergence())
    return words_(Text::diverged, {words_.number(static_cast<int>(wrong->turn) + 1)});
  return words_(complete_ ? Text::verified : Text::verifying);
}

Color ReplayScreen::status_color(const Palette& palette) const {
  if (player_.divergence()) return palette.refused;
  return complete_ ? palette.allowed : palette::muted;
}

std::string ReplayScreen::describe() const {
  const std::string now =
      playing_ ? words_(Text::replay_playing, {speeds[speed_].name}) : words_(Text::replay_paused);
  return words_(Text::replay_state, {words_(Text::product), words_(Text::replay_title), title(),
                                     turn(), now, score(), status()});
}

}  // namespace app
