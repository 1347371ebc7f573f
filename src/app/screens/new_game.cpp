#include "app/screens/new_game.hpp"

#include <array>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {

using games::billiards::Rack;

namespace {

// Units.
constexpr float width = 440;
constexpr float title_height = 60;
constexpr float row_height = 48;
constexpr float gap = 8;
constexpr float padding = 20;

}  // namespace

NewGame::NewGame(const Words& words, Session& session)
    : words_(words),
      session_(session),
      buttons_({{players}, {rack}, {keep_turn}, {touch_red}, {start}, {back}}, start) {
  buttons_.explain(players, words_(Text::about_who_plays));
  buttons_.explain(rack, words_(Text::about_rack));
  buttons_.explain(keep_turn, words_(Text::about_keep_turn));
  buttons_.explain(touch_red, words_(Text::about_touch_red));
  buttons_.explain(start, words_(Text::tip_billiards));
  buttons_.explain(back, words_(Text::tip_close_help));
  relabel();
}

void NewGame::relabel() {
  const Settings& now = session_.settings.get();
  const auto row = [&](Button button, Text what, Text value) {
    buttons_.relabel(button, words_(Text::key_line, {words_(what), words_(value)}));
  };
  const auto on_or_off = [](bool on) { return on ? Text::yes : Text::no; };
  row(players, Text::who_plays, now.seats == Seats::alone ? Text::seats_alone : Text::seats_two);
  row(rack, Text::set_rack, now.rack == Rack::quick ? Text::rack_quick : Text::rack_classic);
  row(keep_turn, Text::set_keep_turn, on_or_off(now.keep_turn));
  row(touch_red, Text::set_touch_red, on_or_off(now.touch_red));
  buttons_.relabel(start, words_(Text::start_game));
  buttons_.relabel(back, words_(Text::help_back));
}

void NewGame::resize(const View& view) {
  const float high = view.button(row_height);
  const float pitch =
      std::min(high + view.px(gap), (view.height - view.px(title_height + 2 * padding + gap)) / 5);
  const float least = std::min(high, pitch - view.px(4));
  panel_ = centered(view.area().center(), std::min(view.px(width), view.width - view.px(16)),
                    view.px(title_height + 2 * padding) + 5 * pitch);
  Rect rest = panel_.inset(view.px(padding));
  title_ = rest.cut_top(view.px(title_height)).inset(0, view.px(4));
  for (const Button button : {players, rack, keep_turn, touch_red}) {
    Rect row = rest.cut_top(pitch);
    buttons_.place(view, button, row.cut_top(least));
  }
  Rect row = rest.cut_top(least);
  buttons_.place(view, start, row.cut_left((row.w - view.px(gap)) * 0.6f));
  row.cut_left(view.px(gap));
  buttons_.place(view, back, row);
  relabel();
}

void NewGame::change(Button button) {
  Settings settings = session_.settings.get();
  switch (button) {
    case players:
      settings.seats = settings.seats == Seats::two ? Seats::alone : Seats::two;
      break;
    case rack:
      settings.rack = settings.rack == Rack::classic ? Rack::quick : Rack::classic;
      break;
    case keep_turn:
      settings.keep_turn = !settings.keep_turn;
      break;
    case touch_red:
      settings.touch_red = !settings.touch_red;
      break;
    case start:
    case back:
      return;
  }
  session_.settings.set(std::move(settings));
  relabel();
}

Navigation NewGame::event(const Input& input) {
  if (is_key(input, Key::escape)) return Back{};
  const auto chosen = buttons_.event(input, session_.sounds);
  if (!chosen) return Stay{};
  if (*chosen == start) return PlayBilliards{};
  if (*chosen == back) return Back{};
  change(static_cast<Button>(*chosen));
  return Stay{};
}

void NewGame::draw(Canvas& canvas) const {
  DrawList& list = canvas.list;
  list.tip.reset();  // of what lies beneath
  fill_rounded(list, canvas.view.area(), 0, palette::scrim);
  list.covered = list.boxes.size();
  const float radius = canvas.px(16);
  fill_rounded(list, panel_.moved({0, canvas.px(8)}), radius, palette::shadow, canvas.px(24));
  fill_rounded(list, panel_, radius, Paint::vertical(panel_, palette::panel, palette::slate_top));
  stroke_rounded(list, panel_, radius, canvas.px(2),
                 Paint::vertical(panel_, palette::brass, palette::brass_dark));
  label(canvas, title_, {Face::black, 32, palette::cream, Align::center}, words_(Text::new_game));
  buttons_.draw(canvas, 18);
}

std::string NewGame::describe() const {
  std::string line = words_(Text::product) + " · " + words_(Text::new_game);
  for (const Button button : {players, rack, keep_turn, touch_red})
    line += " · " + buttons_.label_of(button);
  return line;
}

}  // namespace app
