#include "app/screens/kept_list.hpp"

#include <algorithm>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/screens/replay_list.hpp"
#include "app/view/landscape.hpp"

namespace app {
namespace {

// Units.
constexpr float margin = 16;
constexpr float row_height = 44;
constexpr float row_gap = 8;
constexpr float button_width = 104;
constexpr float most_width = 900;

}  // namespace

KeptList::KeptList(const Words& words, Session& session)
    : words_(words), session_(session), names_(session.kept.names()), list_(words) {}

void KeptList::resize(const View& view) {
  const std::size_t first = page_ * per_page_;
  view_ = view;
  Rect rest = view.area().inset(view.px(margin), view.px(4));
  rest = centered(rest.center(), std::min(rest.w, view.px(most_width)), rest.h);
  head_ = rest.cut_top(view.button(44) + 2 * view.px(4));
  rest.cut_top(view.px(8));
  foot_ = rest.cut_bottom(view.button(40) + view.px(view.narrow() ? 52 : 12));
  rest.cut_bottom(view.px(8));
  rows_ = rest;
  const float pitch = view.button(row_height) + view.px(row_gap);
  per_page_ = static_cast<std::size_t>(std::max((rows_.h + view.px(row_gap)) / pitch, 1.0f));
  show_page(first / per_page_);
}

void KeptList::show_page(std::size_t page) {
  list_.show(page, 2 * names_.size(), 2 * per_page_,
             {{title, words_(Text::title_button), words_(Text::tip_title)}});
  const std::size_t first = list_.first() / 2;
  page_ = first / per_page_;
  entries_.clear();
  Buttons& buttons = list_.buttons;
  Rect rows = rows_;
  const float width = view_.px(button_width);
  for (std::size_t i = 0; i < list_.count() / 2; ++i) {
    auto read = session_.kept.load(names_[first + i]);
    Entry& entry = entries_.emplace_back(Entry{names_[first + i], {}, {}});
    if (read)
      entry.kept = std::move(read).value();
    else
      entry.fault = fault_of(read.errors());
    Rect row = rows.cut_top(view_.button(row_height));
    rows.cut_top(view_.px(row_gap));
    buttons.place(view_, 2 * i + 1, row.cut_right(width));
    row.cut_right(view_.px(row_gap));
    buttons.place(view_, 2 * i, row);
    buttons.relabel(2 * i, describe(entry));
    buttons.relabel(2 * i + 1, words_(Text::delete_game));
    buttons.explain(2 * i, words_(entry.kept ? Text::tip_continue : Text::bad_replay));
    buttons.explain(2 * i + 1, words_(Text::tip_delete_game));
  }
  Rect head = head_.inset(0, view_.px(4));
  buttons.place(view_, title, head.cut_right(width));
  list_.place_pager(view_, foot_);
}

Navigation KeptList::event(const Input& input) {
  if (is_key(input, Key::escape)) return ShowTitle{};
  const auto chosen = list_.buttons.event(input, session_.sounds);
  return chosen ? choose(*chosen) : Stay{};
}

Navigation KeptList::answered(ButtonId button) {
  if (button == yes) {
    static_cast<void>(session_.kept.remove(doomed_));  // one that stays is listed again
    names_ = session_.kept.names();
    show_page(page_);
  }
  return Stay{};
}

Navigation KeptList::choose(ButtonId button) {
  if (button == title) return ShowTitle{};
  if (const auto page = list_.page_of(button)) {
    show_page(*page);
    return Stay{};
  }
  Entry& entry = entries_[button / 2];
  if (button % 2 == 1) return ask(entry);
  if (!entry.kept) return Stay{};
  return Load{std::move(*entry.kept)};
}

Navigation KeptList::ask(const Entry& entry) {
  doomed_ = entry.name;
  const std::string question = words_(Text::ask_delete_game);
  return Ask{.dialog = Dialog(question, {{describe(entry), {}, {}}},
                              {{yes, words_(Text::delete_game), words_(Text::tip_delete_game)},
                               {no, words_(Text::cancel), words_(Text::tip_close_help)}}),
             .line = described(question)};
}

/// "Billiards · 12 turns · 300 : 200".
std::string KeptList::describe(const Entry& entry) const {
  return entry.kept ? line_of(words_, session_.campaign, entry.kept->game)
                    : words_(entry.fault == ReplayFault::other_version ? Text::old_replay
                                                                       : Text::bad_replay);
}

void KeptList::draw(Canvas& canvas) const {
  draw_night(canvas.list, canvas.view.area(), foot_.y - canvas.px(4));
  canvas.list.stand_still();
  Rect head = head_;
  head.cut_right(canvas.px(button_width + row_gap));
  label(canvas, head, {Face::black, 32, palette::cream}, words_(Text::kept_games));
  for (ButtonId i = 0; i < entries_.size(); ++i) {
    draw_entry(canvas, 2 * i);
    list_.buttons.draw_one(canvas, 2 * i + 1, 17);
  }
  list_.draw(canvas);
}

/// On two lines where one is too long.
void KeptList::draw_entry(Canvas& canvas, ButtonId button) const {
  const Buttons::Look look = list_.buttons.draw_face(canvas, button);
  const std::string& text = list_.buttons.label_of(button);
  const TextStyle style{Face::bold, 17, look.ink, Align::center};
  const Rect inside = look.box.inset(canvas.px(10), 0);
  if (label_width(canvas, style, text) <= inside.w)
    label(canvas, inside, style, text);
  else
    paragraph(canvas, centered(inside.center(), inside.w, canvas.px(43)), style, text);
  list_.buttons.list_box(canvas.list, button, text);
}

std::string KeptList::describe() const { return described(words_(Text::kept_games)); }

std::string KeptList::described(const std::string& what) const {
  return words_(Text::kept_games_state,
                {words_(Text::product), what, words_.number(static_cast<int>(names_.size()))});
}

}  // namespace app
