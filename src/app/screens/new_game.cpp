#include "app/screens/new_game.hpp"

#include <array>
#include <type_traits>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/screens/opponent_list.hpp"

namespace app {

using games::billiards::Rack;

namespace {

// Units.
constexpr float width = 440;
constexpr float wide = 760;  ///< in two columns
constexpr float title_height = 60;
constexpr float row_height = 48;
constexpr float gap = 8;
constexpr float padding = 20;

}  // namespace

NewGame::NewGame(const Words& words, Session& session) : words_(words), session_(session) {}

std::vector<NewGame::Button> NewGame::rows() const {
  std::vector<Button> rows{players};
  const Seats seats = session_.settings.get().seats;
  if (seats == Seats::computer) rows.push_back(opponent);
  if (seats != Seats::alone) rows.push_back(match);
  for (const Button rule : {rack, keep_turn, touch_red}) rows.push_back(rule);
  return rows;
}

std::string NewGame::label_of(Button button) const {
  const Settings& now = session_.settings.get();
  const auto row = [&](Text what, const std::string& value) {
    return words_(Text::key_line, {words_(what), value});
  };
  const auto on_or_off = [&](bool on) { return words_(on ? Text::yes : Text::no); };
  switch (button) {
    case players:
      return row(Text::who_plays, words_(now.seats == Seats::alone      ? Text::seats_alone
                                         : now.seats == Seats::computer ? Text::seats_computer
                                                                        : Text::seats_two));
    case opponent:
      return row(Text::set_opponent, ranked(words_, now.opponent));
    case match:
      return row(Text::set_match,
                 now.match == BestOf::one
                     ? words_(Text::match_one)
                     : words_(Text::match_best, {words_.number(games_of(now.match))}));
    case rack:
      return row(Text::set_rack,
                 words_(now.rack == Rack::quick ? Text::rack_quick : Text::rack_classic));
    case keep_turn:
      return row(Text::set_keep_turn, on_or_off(now.keep_turn));
    case touch_red:
      return row(Text::set_touch_red, on_or_off(now.touch_red));
    case start:
      return words_(Text::start_game);
    case back:
      break;
  }
  return words_(Text::help_back);
}

void NewGame::resize(const View& view) {
  view_ = view;
  constexpr std::array tips{Text::about_who_plays, Text::about_opponent,  Text::about_match,
                            Text::about_rack,      Text::about_keep_turn, Text::about_touch_red,
                            Text::tip_billiards,   Text::tip_close_help};
  const std::vector<Button> in_rows = rows();
  std::vector<Buttons::Button> shown;
  for (const Button button : in_rows) shown.push_back({button});
  for (const Button button : {start, back}) shown.push_back({button});
  Buttons buttons(std::move(shown), start);
  buttons.keep_focus(buttons_);
  buttons_ = std::move(buttons);
  for (const auto& button : buttons_.all()) {
    const auto id = static_cast<Button>(button.id);
    buttons_.explain(id, words_(tips[id]));
    buttons_.relabel(id, label_of(id));
  }

  const float high = view.button(row_height);
  const float around = view.px(title_height + 2 * padding);
  const float pitch = high + view.px(gap);
  // In a low window two stand side by side, and the title lower.
  const auto lines_of = [&](std::size_t columns) {
    return static_cast<float>((in_rows.size() + columns - 1) / columns + 1);
  };
  const bool low = view.height < around + lines_of(1) * pitch;
  const std::size_t columns = low && view.width >= view.px(620) ? 2 : 1;
  const float height = std::min(around + lines_of(columns) * pitch, view.height);
  const float step = std::min(pitch, (height - around) / lines_of(columns));
  const float least = std::min(high, step - view.px(4));
  panel_ =
      centered(view.area().center(),
               std::min(view.px(columns == 1 ? width : wide), view.width - view.px(16)), height);
  Rect rest = panel_.inset(view.px(padding));
  title_ = rest.cut_top(view.px(title_height)).inset(0, view.px(4));
  const float half = (rest.w - view.px(gap)) / 2;
  Rect line;
  for (std::size_t i = 0; i < in_rows.size(); ++i) {
    if (i % columns == 0) {
      line = rest.cut_top(step);
      line.h = least;
    }
    buttons_.place(view, in_rows[i], columns == 1 ? line : line.cut_left(half));
    if (columns == 2) line.cut_left(view.px(gap));
  }
  Rect row = rest.cut_top(least);
  buttons_.place(view, start, row.cut_left((row.w - view.px(gap)) * 0.6f));
  row.cut_left(view.px(gap));
  buttons_.place(view, back, row);
  buttons_.set_columns(columns);
}

void NewGame::change(Button button) {
  Settings settings = session_.settings.get();
  const auto next = [](auto& choice, int count) {
    choice = static_cast<std::remove_reference_t<decltype(choice)>>((static_cast<int>(choice) + 1) %
                                                                    count);
  };
  switch (button) {
    case players:
      next(settings.seats, 3);
      break;
    case match:
      next(settings.match, 3);
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
    case opponent:
    case start:
    case back:
      return;
  }
  session_.settings.set(std::move(settings));
  resize(view_);
}

Navigation NewGame::event(const Input& input) {
  if (is_key(input, Key::escape)) return Back{};
  const auto chosen = buttons_.event(input, session_.sounds);
  if (!chosen) return Stay{};
  if (*chosen == start) return PlayBilliards{};
  if (*chosen == back) return Back{};
  if (*chosen == opponent) return ShowOpponents{};
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
  for (const Button button : rows()) line += " · " + buttons_.label_of(button);
  return line;
}

}  // namespace app
