#include "app/screens/licences_panel.hpp"

#include <algorithm>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"

namespace app {
namespace {

// Units.
constexpr float text_size = 16;
constexpr float line_height = 20;
constexpr float most_width = 720;

/// Of a letter, in sizes of the text and rather more than it takes: the font can be asked only when
/// something is drawn.
float width_of(char letter) {
  if (letter == ' ') return 0.25f;
  if (letter >= 'A' && letter <= 'Z') return 0.72f;
  return (static_cast<unsigned char>(letter) & 0xc0) == 0x80 ? 0 : 0.58f;
}

/// Lines of at most `width` sizes of the text, broken at spaces where there are any.
std::vector<std::string_view> wrapped(std::string_view text, float width) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    std::size_t end = 0;
    std::size_t space = 0;  // the last one, but for those that the line begins with
    bool begun = false;
    float x = 0;
    for (; end < text.size() && text[end] != '\n' && (x += width_of(text[end])) <= width; ++end) {
      if (text[end] != ' ') begun = true;
      if (text[end] == ' ' && begun) space = end;
    }
    const bool full = end < text.size() && text[end] != '\n';
    if (full && text[end] != ' ' && space > 0) end = space;
    lines.push_back(text.substr(0, end));
    const bool skip = end < text.size() && (text[end] == '\n' || text[end] == ' ');
    text.remove_prefix(end + (skip ? 1 : 0));
  }
  return lines;
}

}  // namespace

LicencesPanel::LicencesPanel(const Words& words, std::string_view text)
    : words_(words),
      text_(text),
      buttons_({{previous, "‹", words(Text::tip_page)},
                {next, "›", words(Text::tip_page)},
                {back, words(Text::help_back), words(Text::tip_close_help)}}) {}

void LicencesPanel::resize(const View& view, const Rect& area) {
  Rect rest = centered(area.center(), std::min(area.w, view.px(most_width)), area.h);
  head_ = rest.cut_top(view.px(view.height < view.px(480) ? 36 : 48));
  page_label_ = head_.cut_right(view.px(130));
  Rect row = rest.cut_bottom(view.button(48));
  rest.cut_bottom(view.px(8));
  for (const Button button : {previous, next}) {
    buttons_.place(view, button, row.cut_left(view.px(56)));
    row.cut_left(view.px(8));
  }
  buttons_.place(view, back, row.cut_right(std::min(row.w, view.px(150))));
  page_ = rest;
  line_ = view.px(line_height);
  rows_ = static_cast<std::size_t>(std::max(rest.h / line_, 1.0f));
  // The line at the top stays there.
  const char* const at = lines_.empty() ? text_.data() : lines_[top_].data();
  lines_ = wrapped(text_, std::max(rest.w / view.px(text_size), 10.0f));
  const auto same = std::ranges::upper_bound(lines_, at, {}, &std::string_view::data);
  top_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(same - lines_.begin() - 1, 0));
  scroll(0);
}

void LicencesPanel::scroll(std::ptrdiff_t lines) {
  const auto top = static_cast<std::ptrdiff_t>(top_) + lines;
  top_ = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(top, 0, static_cast<std::ptrdiff_t>(last_top())));
}

bool LicencesPanel::event(const Input& input, Sounds& sounds) {
  if (is_key(input, Key::escape) || is_key(input, Key::help)) return false;
  const auto page = static_cast<std::ptrdiff_t>(rows_ > 1 ? rows_ - 1 : 1);
  if (const auto* wheel = std::get_if<WheelTurned>(&input))
    scroll(static_cast<std::ptrdiff_t>(wheel->notches * -3));
  else if (is_key(input, Key::down) || is_key(input, Key::up))
    scroll(is_key(input, Key::down) ? 1 : -1);
  else if (is_key(input, Key::right) || is_key(input, Key::left))
    scroll(is_key(input, Key::right) ? page : -page);
  else if (const auto chosen = buttons_.event(input, sounds)) {
    if (*chosen == back) return false;
    scroll(*chosen == next ? page : -page);
  }
  return true;
}

void LicencesPanel::draw(Canvas& canvas) const {
  label(canvas, head_, {Face::black, 28, palette::cream}, words_(Text::licences));
  const auto number = [&](std::size_t value) { return words_.number(static_cast<int>(value)); };
  const std::size_t page = rows_ > 1 ? rows_ - 1 : 1;
  const std::size_t pages = (last_top() + page - 1) / page + 1;
  label(canvas, page_label_, {Face::regular, 16, palette::muted, Align::right},
        words_(Text::page, {number((top_ + page - 1) / page + 1), number(pages)}));
  Rect rest = page_;
  for (std::size_t i = top_; i < std::min(top_ + rows_, lines_.size()); ++i)
    label(canvas, rest.cut_top(line_), {Face::regular, text_size, palette::cream}, lines_[i]);
  buttons_.draw(canvas, 18);
}

}  // namespace app
