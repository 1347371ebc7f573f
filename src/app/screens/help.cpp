#include "app/screens/help.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

// Units.
constexpr float line_height = 22;
constexpr float title_height = 30;
constexpr float column_gap = 24;
constexpr float least_column = 300;
constexpr float button_height = 48;
constexpr float most_width = 1040;

constexpr float key_share = 0.36f;  ///< of a column

/// The section on playing by a hand.
Text own_section(InputDevice hand) {
  return hand == InputDevice::finger ? Text::help_touch
         : hand == InputDevice::pad  ? Text::help_pad
                                     : Text::help_aim;
}

}  // namespace

Help::Help(const Words& words, Session& session)
    : words_(words),
      session_(session),
      keyboard_(session.keyboard),
      buttons_({{keys, words(Text::change_keys), words(Text::tip_keys)},
                {close, words(Text::close), words(Text::tip_close_help)},
                {licences, words(Text::licences), words(Text::tip_licences)}},
               close),
      pager_({{previous, "‹", words(Text::tip_page)}, {next, "›", words(Text::tip_page)}}) {}

void Help::resize(const View& view) {
  view_ = view;
  frame_ = centered(view.area().center(), std::min(view.width - view.px(8), view.px(most_width)),
                    std::min(view.height - view.px(8), view.px(592)));
  Rect rest = frame_.inset(view.px(16), view.px(10));
  if (auto* keys_panel = std::get_if<KeysPanel>(&panel_)) keys_panel->resize(view, rest);
  if (auto* texts = std::get_if<LicencesPanel>(&panel_)) texts->resize(view, rest);
  head_ = rest.cut_top(view.button(44));
  page_label_ = head_.cut_right(view.px(110));
  buttons_.place(view, licences, head_.cut_right(view.px(116)));
  Rect row = rest.cut_bottom(view.button(button_height));
  const float gap = view.px(8);
  for (const auto& [button, width] : {std::pair{previous, 56.0f}, {next, 56.0f}}) {
    pager_.place(view, button, row.cut_left(view.px(width)));
    row.cut_left(gap);
  }
  const float half = std::min((row.w - gap) / 2, view.px(150));
  buttons_.place(view, close, row.cut_right(half));
  row.cut_right(gap);
  buttons_.place(view, keys, row.cut_right(half));
  lay_out();
}

void Help::lay_out() {
  std::array in_order{Section{Text::help_aim_title, Text::help_aim},
                      Section{Text::help_menu_title, Text::help_menu},
                      Section{Text::help_replay_title, Text::help_replay},
                      Section{Text::help_game_title, Text::help_game},
                      Section{Text::help_mouse_title, Text::help_mouse},
                      Section{Text::help_touch_title, Text::help_touch},
                      Section{Text::help_pad_title, Text::help_pad}};
  lay_out(in_order);
  if (pages_ == 1) return;
  // The part about the input device in use comes first.
  const auto own = std::ranges::find(in_order, own_section(words_.hand()), &Section::lines);
  std::rotate(in_order.begin(), own, own + 1);
  lay_out(in_order);
}

/// Sections in columns, columns on pages; a section stays together if a column can hold it.
void Help::lay_out(std::span<const Section> in_order) {
  lines_.clear();
  Rect area = frame_.inset(view_.px(16), view_.px(10));
  area.cut_top(view_.button(44));
  area.cut_bottom(view_.button(button_height) + view_.px(8));
  const float gap = view_.px(column_gap);
  const auto columns =
      static_cast<std::size_t>(std::max((area.w + gap) / (view_.px(least_column) + gap), 1.0f));
  const float width = (area.w + gap) / static_cast<float>(columns) - gap;
  const float line = view_.px(line_height);
  const float title = view_.px(title_height);
  std::size_t column = 0;
  float y = area.y;
  const auto place = [&](float height, std::string key, std::string what) {
    if (y + height > area.bottom() && y > area.y) {
      ++column;
      y = area.y;
    }
    const float x = area.x + static_cast<float>(column % columns) * (width + gap);
    lines_.push_back({column / columns, {x, y, width, height}, std::move(key), std::move(what)});
    y += height;
  };
  for (const Section& section : in_order) {
    const std::string text =
        words_(section.lines, {keyboard_.name(Command::again), keyboard_.name(Command::next),
                               keyboard_.name(Command::pause), keyboard_.name(Command::fast),
                               keyboard_.name(Command::mute), keyboard_.name(Command::hint)});
    const auto count = static_cast<float>(std::ranges::count(text, '\n') + 1);
    const float height = title + count * line;
    if (y + std::min(height, area.h) > area.bottom() + 0.5f) {
      ++column;
      y = area.y;
    }
    place(title, words_(section.title), {});
    for (std::string_view rest = text; !rest.empty();) {
      const std::string_view one = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(one.size() + 1, rest.size()));
      const std::size_t tab = one.find('\t');
      place(line, std::string(one.substr(0, tab)), std::string(one.substr(tab + 1)));
    }
    y += view_.px(8);
  }
  pages_ = lines_.back().page + 1;
  page_ = std::min(page_, pages_ - 1);
}

void Help::turn(std::size_t by) { page_ = (page_ + by) % pages_; }

Navigation Help::event(const Input& input) {
  if (panel_.index() != 0) {
    auto* const keys_panel = std::get_if<KeysPanel>(&panel_);
    if (!(keys_panel ? keys_panel->event(input, session_.sounds)
                     : std::get<LicencesPanel>(panel_).event(input, session_.sounds))) {
      panel_.emplace<std::monostate>();
      lay_out();
    }
    return Stay{};
  }
  const auto* typed = std::get_if<TextTyped>(&input);
  if (is_key(input, Key::escape) || is_key(input, Key::help) || (typed && typed->text == "?"))
    return Back{};
  if (is_key(input, Key::left) || is_key(input, Key::right)) {
    turn(is_key(input, Key::right) ? 1 : pages_ - 1);
    return Stay{};
  }
  const bool several = pages_ > 1;
  if (Buttons::move_focus({several ? &pager_ : nullptr, &buttons_}, input)) return Stay{};
  const auto* released = std::get_if<PointerReleased>(&input);
  const bool beside = released && !buttons_.cover(released->at, true) &&
                      !(several && pager_.cover(released->at, true));
  if (const auto turned = several ? pager_.event(input, session_.sounds) : std::nullopt) {
    turn(*turned == next ? 1 : pages_ - 1);
    return Stay{};
  }
  if (several && pager_.has_focus() && is_key(input, Key::enter)) return Stay{};
  const auto chosen = buttons_.event(input, session_.sounds);
  if (chosen ? *chosen == close : beside) return Back{};
  if (!chosen) return Stay{};
  if (*chosen == keys)
    panel_.emplace<KeysPanel>(words_, keyboard_);
  else if (session_.host.licences.empty() && session_.host.show_licences)
    session_.host.show_licences();
  else
    panel_.emplace<LicencesPanel>(words_, session_.host.licences);
  resize(view_);
  return Stay{};
}

void Help::draw(Canvas& canvas) const {
  canvas.list.tip.reset();  // of what lies beneath
  canvas.list.covered = canvas.list.boxes.size();
  fill_rounded(canvas.list, canvas.view.area(), 0, palette::scrim);
  const float radius = canvas.px(14);
  fill_rounded(canvas.list, frame_, radius,
               Paint::vertical(frame_, palette::panel, palette::slate_top));
  stroke_rounded(canvas.list, frame_, radius, canvas.px(2),
                 Paint::vertical(frame_, palette::brass, palette::brass_dark));
  if (const auto* panel = std::get_if<KeysPanel>(&panel_)) return panel->draw(canvas);
  if (const auto* panel = std::get_if<LicencesPanel>(&panel_)) return panel->draw(canvas);
  label(canvas, head_, {Face::black, 28, palette::cream}, words_(Text::help));
  if (pages_ > 1)
    label(canvas, page_label_, {Face::regular, 16, palette::muted, Align::right},
          words_(Text::page, {words_.number(static_cast<int>(page_) + 1),
                              words_.number(static_cast<int>(pages_))}));
  for (const Line& line : lines_) {
    if (line.page != page_) continue;
    if (line.what.empty()) {
      label(canvas, line.box, {Face::bold, 19, palette::brass_lit}, line.key);
      continue;
    }
    Rect rest = line.box;
    label(canvas, rest.cut_left(std::round(rest.w * key_share)).inset(canvas.px(3), 0),
          {Face::bold, 16, palette::cream}, line.key);
    label(canvas, rest, {Face::regular, 16, palette::muted}, line.what);
  }
  if (pages_ > 1) pager_.draw(canvas, 18);
  buttons_.draw(canvas, 18);
}

std::string Help::describe() const {
  return words_(Text::product) + " · " +
         words_(std::holds_alternative<KeysPanel>(panel_)       ? Text::keys_title
                : std::holds_alternative<LicencesPanel>(panel_) ? Text::licences
                                                                : Text::help);
}

}  // namespace app
