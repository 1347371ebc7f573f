#include "app/screens/replay_list.hpp"

#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/landscape.hpp"

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
    : words_(words), session_(session), names_(session.saved.names()) {
  // The last ones saved are what a player looks for.
  page_ = names_.size();
}

std::size_t ReplayList::pages() const {
  return std::max<std::size_t>((names_.size() + per_page_ - 1) / per_page_, 1);
}

void ReplayList::resize(const View& view) {
  const std::size_t first = page_ * per_page_;
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
  show_page(std::min(first / per_page_, pages() - 1));
}

void ReplayList::show_page(std::size_t page) {
  page_ = page;
  entries_.clear();
  std::vector<std::string> labels;
  const std::size_t end = std::min((page + 1) * per_page_, names_.size());
  for (std::size_t i = page * per_page_; i < end; ++i) {
    auto read = session_.saved.load(names_[i]);
    Entry& entry = entries_.emplace_back(Entry{names_[i], {}, {}});
    if (read)
      entry.replay = std::move(read).value();
    else
      entry.fault = fault_of(read.errors());
    labels.emplace_back();
  }
  const bool several = pages() > 1;
  if (several) {
    labels.push_back(words_(Text::previous_page));
    labels.push_back(words_(Text::next_page));
  }
  labels.push_back(words_(Text::paste));
  labels.push_back(words_(Text::title_button));
  const Buttons before = std::exchange(buttons_, Buttons(std::move(labels)));
  buttons_.keep_focus(before, several ? 4 : 2);
  for (std::size_t i = 0; i < entries_.size(); ++i)
    buttons_.explain(i, entries_[i].replay ? words_(Text::tip_watch) : fault(entries_[i]));
  for (std::size_t i = entries_.size(); i + 2 < buttons_.size(); ++i)
    buttons_.explain(i, words_(Text::tip_page));
  buttons_.explain(buttons_.size() - 2, words_(Text::tip_paste));
  buttons_.explain(buttons_.size() - 1, words_(Text::tip_title));

  Rect rows = rows_;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    buttons_.place(view_, i, rows.cut_top(view_.button(view_.narrow() ? high_row : row_height)));
    rows.cut_top(view_.px(row_gap));
  }
  Rect head = head_.inset(0, view_.px(4));
  const float width = view_.px(button_width);
  buttons_.place(view_, buttons_.size() - 1, head.cut_right(width));
  head.cut_right(view_.px(row_gap));
  buttons_.place(view_, buttons_.size() - 2, head.cut_right(width));
  page_label_ = {};
  if (!several) return;
  Rect foot = foot_;
  Rect paging = view_.narrow() ? foot.cut_bottom(view_.button(40) + 2 * view_.px(2))
                               : foot.cut_right(std::min(view_.px(380), foot.w));
  paging = paging.inset(0, view_.px(2));
  buttons_.place(view_, entries_.size(), paging.cut_left(width));
  buttons_.place(view_, entries_.size() + 1, paging.cut_right(width));
  page_label_ = paging;
}

Transition ReplayList::event(const Input& input) {
  if (is_key(input, Key::escape)) return Transition::title;
  if (is_key(input, Key::paste)) return paste();
  const auto chosen = buttons_.event(input);
  return chosen ? choose(*chosen) : Transition::stay;
}

Transition ReplayList::choose(std::size_t button) {
  message_.clear();
  if (button < entries_.size()) {
    const Entry& entry = entries_[button];
    if (!entry.replay) {
      message_ = fault(entry);
      return Transition::stay;
    }
    session_.to_watch = entry.replay;
    return Transition::replay;
  }
  if (button + 1 == buttons_.size()) return Transition::title;
  if (button + 2 == buttons_.size()) return paste();
  const std::size_t n = pages();
  show_page((page_ + (button == entries_.size() ? n - 1 : 1)) % n);
  return Transition::stay;
}

Transition ReplayList::paste() {
  const Pasted pasted = take_pasted(session_);
  if (pasted == Pasted::replay) return Transition::replay;
  if (pasted != Pasted::later)
    message_ =
        words_(pasted == Pasted::other_version ? Text::paste_other_version : Text::paste_damaged);
  return Transition::stay;
}

std::string ReplayList::fault(const Entry& entry) const {
  return words_(entry.fault == ReplayFault::other_version ? Text::old_replay : Text::bad_replay);
}

/// "Billiards · 12 turns · 300 : 200".
std::string ReplayList::describe(const Entry& entry) const {
  if (!entry.replay) return fault(entry);
  const replay::Replay& replay = *entry.replay;
  const auto turns = std::ranges::count_if(replay.moves, [](const replay::Move& move) {
    return std::holds_alternative<games::billiards::Shoot>(move.command) ||
           std::holds_alternative<games::angry_balls::Throw>(move.command);
  });
  const std::string points = words_.number(replay.score[0]);
  return words_(
      Text::replay_line,
      {replay.level ? words_.level_name(replay.level->name) : words_(Text::billiards),
       words_.count(Text::turns, static_cast<int>(turns)),
       replay.level ? words_(Text::score) + " " + points
                    : words_(Text::score_pair, {points, words_.number(replay.score[1])})});
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
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    if (i < entries_.size())
      draw_entry(canvas, i);
    else
      buttons_.draw_one(canvas, i, 18);
  }
  if (pages() > 1)
    label(canvas, page_label_, {Face::bold, 16, palette::cream, Align::center},
          words_(Text::page, {words_.number(static_cast<int>(page_) + 1),
                              words_.number(static_cast<int>(pages()))}));
  if (names_.empty())
    paragraph(canvas, rows_.inset(canvas.px(24), canvas.px(24)),
              {Face::regular, 20, palette::cream, Align::center}, words_(Text::no_replays));
  Rect foot = foot_;
  if (pages() > 1) {
    if (view_.narrow())
      foot.cut_bottom(view_.button(40) + 2 * canvas.px(2));
    else
      foot.cut_right(std::min(canvas.px(380), foot.w) + canvas.px(row_gap));
  }
  const TextStyle style{Face::regular, 18,
                        message_.empty() ? palette::cream : canvas.list.palette->refused,
                        Align::center};
  label(canvas, foot, style,
        elided(canvas, style, message_.empty() ? words_(Text::hint_replays) : message_, foot.w));
}

void ReplayList::draw_entry(Canvas& canvas, std::size_t index) const {
  const Entry& entry = entries_[index];
  DrawList& list = canvas.list;
  buttons_.draw_one(canvas, index, 16);
  list.boxes.pop_back();  // the button's comes last, and with all texts
  const std::size_t own = list.boxes.size();
  Rect rest = buttons_.box(index).inset(canvas.px(14), 0);
  const Color dim = rgb(0x9aa6ab);
  const TextStyle name{Face::bold, 18, entry.replay ? palette::brass_lit : dim};
  const bool narrow = canvas.view.narrow();
  if (narrow) rest = rest.inset(0, canvas.px(6));
  const Rect left = narrow ? rest.cut_top(rest.h / 2) : rest.cut_left(std::round(rest.w * 0.32f));
  if (!narrow) rest.cut_left(canvas.px(8));
  const TextStyle what{Face::regular, 17, entry.replay ? palette::cream : dim};
  label(canvas, left, name, elided(canvas, name, entry.name, left.w));
  label(canvas, rest, what, elided(canvas, what, describe(entry), rest.w));
  std::string texts;
  for (std::size_t i = own; i < list.boxes.size(); ++i)
    texts += (texts.empty() ? "" : "\n") + list.boxes[i].text;
  buttons_.list_box(list, index, std::move(texts));
}

std::string ReplayList::describe() const {
  return words_(Text::replays_state,
                {words_(Text::product), words_(Text::saved_replays),
                 words_.count(Text::replay_count, static_cast<int>(names_.size()))});
}

}  // namespace app
