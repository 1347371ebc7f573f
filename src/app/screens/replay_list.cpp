#include "app/screens/replay_list.hpp"

#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/landscape.hpp"
#include "carom/display_text.hpp"

namespace app {
namespace {

// Units.
constexpr float margin = 16;
constexpr float row_height = 44;
constexpr float high_row = 60;  ///< with two lines, in a narrow window
constexpr float row_gap = 8;
constexpr float button_width = 104;
constexpr float most_width = 900;

}  // namespace

ReplayList::ReplayList(const Words& words, Session& session)
    : words_(words), session_(session), names_(session.saved.names()), list_(words) {
  // The last ones saved are what a player looks for.
  first_ = names_.size();
}

void ReplayList::resize(const View& view) {
  names_ = session_.saved.names();  // the replay watched may have been saved
  view_ = view;
  Rect rest = view.area().inset(view.px(margin), view.px(4));
  rest = centered(rest.center(), std::min(rest.w, view.px(most_width)), rest.h);
  head_ = rest.cut_top(view.button(44) + 2 * view.px(4));
  rest.cut_top(view.px(8));
  foot_ = rest.cut_bottom(view.button(40) + view.px(view.narrow() ? 52 : 12));
  rest.cut_bottom(view.px(8));
  rows_ = rest;
  const float pitch = view.button(view.narrow() ? high_row : row_height) + view.px(row_gap);
  per_page_ = static_cast<std::size_t>(std::max((rows_.h + view.px(row_gap)) / pitch, 1.0f));
  show_page(first_ / per_page_);
}

void ReplayList::show_page(std::size_t page) {
  list_.show(page, names_.size(), per_page_,
             {{paste, words_(Text::paste), words_(Text::tip_paste)},
              {title, words_(Text::title_button), words_(Text::tip_title)}});
  first_ = list_.first();
  entries_.clear();
  Buttons& buttons = list_.buttons;
  Rect rows = rows_;
  for (std::size_t i = 0; i < list_.count(); ++i) {
    const std::string& name = names_[first_ + i];
    auto read = session_.saved.load(name);
    Entry& entry = entries_.emplace_back(Entry{name, {}, {}});
    if (read)
      entry.replay = std::move(read).value();
    else
      entry.fault = fault_of(read.errors());
    buttons.explain(i, entry.replay ? words_(Text::tip_watch) : fault(entry));
    buttons.place(view_, i, rows.cut_top(view_.button(view_.narrow() ? high_row : row_height)));
    rows.cut_top(view_.px(row_gap));
  }
  Rect head = head_.inset(0, view_.px(4));
  const float width = view_.px(button_width);
  buttons.place(view_, title, head.cut_right(width));
  head.cut_right(view_.px(row_gap));
  buttons.place(view_, paste, head.cut_right(width));
  message_box_ = list_.place_pager(view_, foot_);
  if (list_.pages() > 1 && !view_.narrow()) message_box_.cut_right(view_.px(row_gap));
}

Navigation ReplayList::event(const Input& input) {
  if (is_key(input, Key::escape)) return ShowTitle{};
  if (is_key(input, Key::paste)) return take_pasted_replay();
  const auto chosen = list_.buttons.event(input, session_.sounds);
  return chosen ? choose(*chosen) : Stay{};
}

Navigation ReplayList::choose(ButtonId button) {
  message_.clear();
  if (button == title) return ShowTitle{};
  if (button == paste) return take_pasted_replay();
  if (const auto page = list_.page_of(button)) {
    show_page(*page);
    return Stay{};
  }
  const Entry& entry = entries_[button];
  if (!entry.replay) {
    message_ = fault(entry);
    return Stay{};
  }
  return Watch{*entry.replay};
}

Navigation ReplayList::take_pasted_replay() {
  Pasted pasted = read_pasted(session_);
  if (pasted.replay) return Watch{std::move(*pasted.replay)};
  if (pasted.fault) message_ = words_(pasted_fault(*pasted.fault));
  return Stay{};
}

std::string ReplayList::fault(const Entry& entry) const {
  return words_(entry.fault == ReplayFault::other_version ? Text::old_replay : Text::bad_replay);
}

std::string ReplayList::describe(const Entry& entry) const {
  return entry.replay ? line_of(words_, session_.campaign, *entry.replay) : fault(entry);
}

std::string table_name(const Words& words, const replay::Replay& table) {
  if (table.occasion.computer == std::array{0, 0}) return words(Text::billiards);
  const Words named = words.with_computers(table.occasion.computer);
  return words(Text::versus, {named.player(0), named.player(1)});
}

std::string line_of(const Words& words, const Campaign& campaign, const replay::Replay& replay) {
  const auto turns = std::ranges::count_if(replay.moves, [](const replay::Move& move) {
    return std::holds_alternative<games::billiards::Shoot>(move.command) ||
           std::holds_alternative<games::angry_balls::Throw>(move.command);
  });
  const std::string points = words.number(replay.score[0]);
  return words(
      Text::replay_line,
      {replay.level ? shown_name(words, campaign.known(*replay.level)) : table_name(words, replay),
       words.count(Text::turns, static_cast<int>(turns)),
       replay.level ? words(Text::score) + " " + points
                    : words(Text::score_pair, {points, words.number(replay.score[1])})});
}

void ReplayList::draw(Canvas& canvas) const {
  const Rect all = canvas.view.area();
  draw_night(canvas.list, all, foot_.y - canvas.px(4));
  canvas.list.stand_still();
  Rect strip = all;
  strip = strip.cut_bottom(all.bottom() - foot_.y + canvas.px(4));
  fill_rounded(canvas.list, strip, 0,
               Paint::vertical(strip, palette::slate_top, palette::slate_bottom));
  Rect head = head_;
  head.cut_right(canvas.px(2 * (button_width + row_gap)));
  label(canvas, head, {Face::black, 32, palette::cream}, words_(Text::saved_replays));
  for (std::size_t i = 0; i < entries_.size(); ++i) draw_entry(canvas, i);
  list_.draw(canvas);
  if (names_.empty())
    paragraph(canvas, rows_.inset(canvas.px(24), canvas.px(24)),
              {Face::regular, 20, palette::cream, Align::center}, words_(Text::no_replays));
  const TextStyle style{Face::regular, 18,
                        message_.empty() ? palette::cream : canvas.list.palette->refused,
                        Align::center};
  label(canvas, message_box_, style,
        elided(canvas, style, message_.empty() ? words_(Text::hint_replays) : message_,
               message_box_.w));
}

void ReplayList::draw_entry(Canvas& canvas, ButtonId index) const {
  const Buttons& buttons = list_.buttons;
  const Entry& entry = entries_[index];
  DrawList& list = canvas.list;
  buttons.draw_one(canvas, index, 16);
  list.boxes.pop_back();  // the button's comes last, and with all texts
  const std::size_t own = list.boxes.size();
  Rect rest = buttons.box(index).inset(canvas.px(14), 0);
  const Color dim = rgb(0x9aa6ab);
  const TextStyle name{Face::bold, 18, entry.replay ? palette::brass_lit : dim};
  const bool narrow = canvas.view.narrow();
  if (narrow) rest = rest.inset(0, canvas.px(6));
  const Rect left = narrow ? rest.cut_top(rest.h / 2) : rest.cut_left(std::round(rest.w * 0.32f));
  if (!narrow) rest.cut_left(canvas.px(8));
  const TextStyle what{Face::regular, 17, entry.replay ? palette::cream : dim};
  label(canvas, left, name, elided(canvas, name, carom::display_text(entry.name), left.w));
  label(canvas, rest, what, elided(canvas, what, describe(entry), rest.w));
  std::string texts;
  for (std::size_t i = own; i < list.boxes.size(); ++i)
    texts += (texts.empty() ? "" : "\n") + list.boxes[i].text;
  buttons.list_box(list, index, std::move(texts));
}

std::string ReplayList::describe() const {
  return words_(Text::replays_state,
                {words_(Text::product), words_(Text::saved_replays),
                 words_.count(Text::replay_count, static_cast<int>(names_.size()))});
}

}  // namespace app
