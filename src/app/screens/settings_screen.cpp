#include "app/screens/settings_screen.hpp"

#include <algorithm>
#include <utility>

#include "app/base/utf8.hpp"
#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/landscape.hpp"

namespace app {
namespace {

using Kind = SettingsRow::Kind;

// Units.
constexpr float most_width = 720;
constexpr float line_height = 46;
constexpr float stacked_height = 76;
constexpr float line_gap = 6;
constexpr float hint_height = 64;
constexpr float arrow_width = 44;
constexpr float stacked_below = 500;  ///< narrower windows have no room for label and value

/// A triangle that points to the left or right.
void draw_arrow(DrawList& list, Point center, float size, bool right, Color color) {
  const float way = right ? size : -size;
  std::array corners{center + Point{-way * 0.5f, -size}, center + Point{way * 0.6f, 0},
                     center + Point{-way * 0.5f, size}};
  if (!right) std::swap(corners[0], corners[2]);
  fill(list, corners, color);
}

/// The ground of a control, and the ring of the focus.
void draw_ground(Canvas& canvas, const Rect& box, Color color, bool focused) {
  const float radius = canvas.px(8);
  if (focused)
    stroke_rounded(canvas.list, box.inset(-canvas.px(2)), radius + canvas.px(2), canvas.px(2),
                   palette::cream);
  fill_rounded(canvas.list, box, radius,
               Paint::vertical(box, mix(color, palette::cream, 0.06f), color));
  stroke_rounded(canvas.list, box.inset(0.5f), radius, 1, faded(palette::cream, 0.22f));
}

}  // namespace

SettingsScreen::SettingsScreen(const Words& words, Session& session, std::size_t page)
    : words_(words), session_(session), page_(page) {}

const SettingsRow* SettingsScreen::row_of(Control control) const {
  return control < pages || control >= help() ? nullptr : &rows()[control - pages];
}

/// The row with the focus, if it is a name: that is what is typed.
const SettingsRow* SettingsScreen::named() const {
  const SettingsRow* row = focused_ ? row_of(*focused_) : nullptr;
  return row && row->kind == Kind::name ? row : nullptr;
}

Rect SettingsScreen::box_of(Control control) const {
  if (control < pages) return page_boxes_[control];
  if (control == help()) return help_;
  return control == close() ? close_ : line_boxes_[control - pages];
}

Rect SettingsScreen::value_box(Control control) const {
  Rect box = box_of(control);
  // The middle of a line is not in it: a click there means the next value.
  return stacked_ ? box.cut_bottom(box.h * 0.58f) : box.cut_right(box.w * 0.48f);
}

std::optional<SettingsScreen::Control> SettingsScreen::find(Point at) const {
  for (Control control = 0; control < controls(); ++control)
    if (box_of(control).contains(at)) return control;
  return std::nullopt;
}

void SettingsScreen::resize(const View& view) {
  stacked_ = view.width < view.px(stacked_below) && view.height > view.width;
  Rect rest = view.area();
  const float gap = view.px(line_gap);
  const float height = view.button(stacked_ ? stacked_height : line_height);
  const float tab = view.button(44);
  const float head_height = tab + view.px(4);
  const float whole =
      head_height + tab + view.px(hint_height + 2 * 8) + most_lines * height + 9 * gap;
  rest = centered(rest.center(), std::min(rest.w, view.px(most_width)), std::min(rest.h, whole))
             .inset(view.px(12), view.px(8));
  arrow_ = std::min(view.px(arrow_width), rest.w / 4);
  Rect head = rest.cut_top(head_height);
  close_ = head.cut_right(view.px(112)).inset(0, view.px(2));
  head.cut_right(gap);
  help_ = head.cut_right(view.px(88)).inset(0, view.px(2));
  head.cut_right(gap);
  title_ = head;
  rest.cut_top(gap);
  Rect row = rest.cut_top(tab);
  const float width = (row.w - gap * static_cast<float>(pages - 1)) / static_cast<float>(pages);
  for (Rect& box : page_boxes_) {
    box = row.cut_left(width);
    row.cut_left(gap);
  }
  rest.cut_top(gap * 2);
  for (Rect& box : line_boxes_) {
    box = rest.cut_top(height);
    rest.cut_top(gap);
  }
  rest.cut_top(gap);
  hint_ = rest;
}

Navigation SettingsScreen::event(const Input& input) {
  if (const auto* moved = std::get_if<PointerMoved>(&input)) {
    hovered_ = find(moved->at);
  } else if (const auto* down = std::get_if<PointerPressed>(&input)) {
    if (down->button != PointerButton::left) return Stay{};
    hovered_ = pressed_ = find(down->at);
    if (pressed_) session_.sounds.note({SoundKind::click});
    const SettingsRow* row = pressed_ ? row_of(*pressed_) : nullptr;
    focus(row && row->kind == Kind::name ? pressed_ : std::nullopt);
  } else if (const auto* up = std::get_if<PointerReleased>(&input)) {
    const auto pressed = std::exchange(pressed_, std::nullopt);
    if (up->button == PointerButton::left && pressed && pressed == find(up->at))
      return press(*pressed, up->at);
  } else if (std::holds_alternative<PointerLeft>(input) ||
             std::holds_alternative<PointerCancelled>(input)) {
    hovered_.reset();
    pressed_.reset();
  } else if (const auto* typed = std::get_if<TextTyped>(&input)) {
    type(typed->text);
  } else if (const auto* down_key = std::get_if<KeyPressed>(&input)) {
    return key(down_key->key);
  }
  return Stay{};
}

Navigation SettingsScreen::key(Key key) {
  const SettingsRow* row = focused_ ? row_of(*focused_) : nullptr;
  const bool naming = named() != nullptr;
  const auto step = [&](std::size_t by) {
    const std::size_t from = focused_.value_or(by == 1 ? controls() - 1 : 0);
    focus((from + by) % controls());
  };
  switch (key) {
    case Key::escape:
    case Key::settings:
      focus(std::nullopt);
      return Back{};
    case Key::tab:
    case Key::down:
      step(1);
      break;
    case Key::back_tab:
    case Key::up:
      step(controls() - 1);
      break;
    case Key::left:
    case Key::right: {
      const int by = key == Key::right ? 1 : -1;
      if (row) {
        change(*row, by);
      } else if (focused_ && *focused_ < pages) {
        show((*focused_ + pages + static_cast<std::size_t>(by)) % pages);
        focus(page_);
      }
      break;
    }
    case Key::backspace:
      if (naming) typed_.resize(without_last_code_point(typed_).size());
      break;
    case Key::space:
      if (naming) break;  // it is typed
      [[fallthrough]];
    case Key::enter:
      if (naming)
        focus(std::nullopt);
      else if (focused_) {
        session_.sounds.note({SoundKind::click});
        return press(*focused_, box_of(*focused_).center());
      }
      break;
    default:
      break;
  }
  return Stay{};
}

Navigation SettingsScreen::press(Control control, Point at) {
  if (control == close()) return Back{};
  if (control == help()) return ShowHelp{};
  if (control < pages) {
    show(control);
    return Stay{};
  }
  Rect value = value_box(control);
  change(*row_of(control), value.cut_left(arrow_).contains(at) ? -1 : 1);
  return Stay{};
}

/// A name that was typed holds when its line is left.
void SettingsScreen::focus(std::optional<Control> control) {
  if (control == focused_) return;
  if (const SettingsRow* left = named()) {
    Settings settings = session_.settings.get();
    settings.names[left->player] = typed_;
    set(std::move(settings));
  }
  focused_ = control;
  if (const SettingsRow* row = named()) typed_ = session_.settings.get().names[row->player];
}

void SettingsScreen::show(std::size_t page) {
  focus(focused_ && *focused_ < pages ? focused_ : std::nullopt);
  page_ = page;
}

/// `by`: 1 to the next value, -1 to the one before.
void SettingsScreen::change(const SettingsRow& row, int by) {
  if (row.kind == Kind::name) return ask_name(row);
  Settings settings = session_.settings.get();
  row.set(settings, by);
  if (settings.language != session_.settings.get().language) session_.asked_language.reset();
  set(std::move(settings));
}

/// A name is typed; a phone has no keys to do so.
void SettingsScreen::ask_name(const SettingsRow& row) {
  const auto& ask = session_.host.ask_text;
  if (words_.hand() != InputDevice::finger || !ask) return;
  if (const auto name = ask(row.label_in(words_), typed_)) typed_ = name_of(*name, true);
  focus(std::nullopt);
}

void SettingsScreen::set(Settings settings) {
  if (settings == session_.settings.get()) return;
  session_.settings.set(std::move(settings));
  speak(session_, words_);
  words_.name_players(session_.settings.get().names);
}

void SettingsScreen::type(std::string_view text) {
  if (named()) typed_ = name_of(typed_ + std::string(text), true);
}

std::string SettingsScreen::value_of(const SettingsRow& row) const {
  return &row == named() ? typed_ : row.get(words_, session_.settings.get());
}

/// A control's purpose; of a page, its rows.
std::string SettingsScreen::tip(Control control) const {
  if (control == close()) return words_(Text::tip_close_help);
  if (control == help()) return words_(Text::tip_help);
  if (const SettingsRow* row = row_of(control)) return row->about_in(words_);
  std::string all;
  for (const SettingsRow& row : settings_page(control).rows)
    all += (all.empty() ? "" : "\u00a0· ") + row.label_in(words_);
  return all;
}

std::string SettingsScreen::hint() const {
  for (const auto& control : {hovered_, focused_})
    if (control && *control < controls()) return tip(*control);
  return words_(session_.settings.trouble() == KeptSettings::Trouble::not_kept
                    ? Text::settings_not_kept
                    : Text::hint_settings);
}

void SettingsScreen::list_box(DrawList& list, Control control, std::string text) const {
  list.boxes.push_back({.kind = Box::Kind::button,
                        .area = box_of(control),
                        .text = std::move(text),
                        .focused = focused_ == control,
                        .tip = tip(control)});
}

void SettingsScreen::draw(Canvas& canvas) const {
  draw_night(canvas.list, canvas.view.area(), canvas.view.height);
  canvas.list.stand_still();
  label(canvas, title_, {Face::black, 32, palette::cream}, words_(Text::settings));
  draw_button(canvas, help(), Text::help);
  draw_button(canvas, close(), Text::close);
  for (std::size_t page = 0; page < pages; ++page) draw_page_button(canvas, page);
  for (std::size_t i = 0; i < rows().size(); ++i) draw_line(canvas, pages + i);
  paragraph(canvas, hint_, {Face::regular, 18, palette::muted, Align::center}, hint());
}

void SettingsScreen::draw_button(Canvas& canvas, Control control, Text text) const {
  const Rect box = box_of(control);
  const bool lit = hovered_ == control;
  draw_ground(canvas, box, lit ? palette::panel_edge : palette::panel_lit, focused_ == control);
  label(canvas, box.inset(canvas.px(8), 0), {Face::bold, 18, palette::cream, Align::center},
        words_(text));
  list_box(canvas.list, control, words_(text));
}

void SettingsScreen::draw_page_button(Canvas& canvas, std::size_t page) const {
  const Rect& box = page_boxes_[page];
  const bool shown = page == page_;
  const Color plain = hovered_ == page ? palette::panel_edge : palette::panel;
  draw_ground(canvas, box, shown ? palette::brass : plain, focused_ == page);
  const std::string text = words_(settings_page(page).title);
  label(canvas, box.inset(canvas.px(4), 0),
        {Face::bold, 18, shown ? palette::ink : palette::cream, Align::center}, text);
  list_box(canvas.list, page, text);
}

void SettingsScreen::draw_line(Canvas& canvas, Control control) const {
  const SettingsRow& row = *row_of(control);
  const Rect whole = box_of(control);
  const bool focused = focused_ == control;
  draw_ground(canvas, whole, hovered_ == control ? palette::panel_lit : palette::panel, focused);
  const std::string name = row.label_in(words_);
  const std::string value = value_of(row);
  Rect right = value_box(control);
  Rect left = whole.inset(canvas.px(12), 0);
  if (stacked_)
    left.h = right.y - left.y;
  else
    left.w = right.x - left.x;
  label(canvas, left, {Face::bold, 18, palette::cream}, name);
  if (row.kind == Kind::name) {
    draw_name(canvas, right.inset(canvas.px(6), canvas.px(4)), row, focused);
  } else {
    const bool volume = row.kind == Kind::amount;
    const int now = session_.settings.get().volume;
    for (const bool next : {false, true}) {
      const Rect side = next ? right.cut_right(arrow_) : right.cut_left(arrow_);
      const bool at_end = volume && now == (next ? most_volume : 0);
      draw_arrow(canvas.list, side.center(), canvas.px(7), next,
                 faded(palette::brass_lit, at_end ? 0.3f : 1.0f));
    }
    if (volume) {
      Rect bar = centered({right.center().x, right.bottom() - canvas.px(7)}, right.w, canvas.px(4));
      fill_rounded(canvas.list, bar, bar.h / 2, palette::ink);
      bar.w *= static_cast<float>(now) / static_cast<float>(most_volume);
      if (now > 0) fill_rounded(canvas.list, bar, bar.h / 2, palette::brass);
      right.h -= canvas.px(6);
    }
    const TextStyle style{Face::regular, 18, palette::brass_lit, Align::center};
    label(canvas, right, style, elided(canvas, style, value, right.w));
  }
  list_box(canvas.list, control, name + '\n' + value);
}

/// A field to type in; the end of a name too long for it is what is shown.
void SettingsScreen::draw_name(Canvas& canvas, const Rect& box, const SettingsRow& row,
                               bool focused) const {
  const float radius = canvas.px(6);
  fill_rounded(canvas.list, box, radius, focused ? palette::ink : palette::slate_bottom);
  stroke_rounded(canvas.list, box.inset(0.5f), radius, 1,
                 focused ? palette::brass_lit : palette::panel_edge);
  const bool empty = session_.settings.get().names[row.player].empty();
  const TextStyle style{Face::regular, 18, focused || !empty ? palette::brass_lit : palette::muted};
  const Rect inside = box.inset(canvas.px(10), 0);
  const std::string value = value_of(row);
  std::string_view shown = value;
  if (!focused) {
    label(canvas, inside, style, elided(canvas, style, value, inside.w));
    return;
  }
  while (label_width(canvas, style, shown) > inside.w - canvas.px(4)) take_code_point(shown);
  label(canvas, inside, style, shown);
  const float x = inside.x + label_width(canvas, style, shown) + canvas.px(2);
  line(canvas.list, {x, inside.center().y - canvas.px(10)}, {x, inside.center().y + canvas.px(10)},
       canvas.px(2), palette::cream);
}

std::string SettingsScreen::describe() const {
  const SettingsRow* row = focused_ ? row_of(*focused_) : nullptr;
  const std::string now =
      row ? row->label_in(words_) + ": " + value_of(*row) : words_(settings_page(page_).title);
  return words_(Text::settings_state, {words_(Text::product), words_(Text::settings), now});
}

}  // namespace app
