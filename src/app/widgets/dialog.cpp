#include "app/widgets/dialog.hpp"

#include <algorithm>
#include <cmath>

#include "app/graphics/label.hpp"
#include "app/graphics/markers.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

// Units.
constexpr float padding = 32;
constexpr float title_height = 48;
constexpr float line_height = 40;
constexpr float least_line_height = 26;
constexpr float button_height = 48;
constexpr float button_gap = 16;
constexpr float letter_width = 10;  ///< on average, of a line's and a button's text
constexpr std::size_t most_rows = 4;

/// The number of rows to reserve for a text.
std::size_t rows_of(const Dialog::Line& line, float width) {
  if (line.columns || !line.score.empty()) return 1;
  const float lines = letter_width * static_cast<float>(line.text.size()) / std::max(width, 1.0f);
  if (lines <= 1.15f) return 1;  // if need be it is written a little smaller
  // Lines of a paragraph are closer than rows.
  return std::clamp(static_cast<std::size_t>(std::lround(lines * 0.65f)), std::size_t{2},
                    most_rows);
}

}  // namespace

Dialog::Dialog(std::string title, std::vector<Line> lines, std::vector<Button> buttons)
    : title_(std::move(title)), lines_(std::move(lines)) {
  const ButtonId primary = buttons.front().id;
  buttons_ = Buttons(std::move(buttons), primary);
}

void Dialog::resize(const View& view) {
  const float panel_width =
      std::min(view.px(buttons_.size() > 2 ? 560 : 480), view.width - view.px(16));
  const float inner = (panel_width - view.px(2 * padding)) / view.scale;  // units
  std::size_t columns = buttons_.size() > 3 ? 2 : buttons_.size();
  // On a phone held upright long words stand below each other.
  for (const Button& button : buttons_.all()) {
    const float needed = letter_width * static_cast<float>(button.label.size()) + 2 * button_gap;
    if (view.height > view.width && needed * static_cast<float>(columns) > inner) columns = 1;
  }
  const std::size_t rows = (buttons_.size() + columns - 1) / columns;
  buttons_.set_columns(columns);
  const float space = view.px(button_gap);
  const float height = view.button(button_height);
  const float buttons_height = static_cast<float>(rows) * (height + space) - space;
  const float rest = view.px(2 * padding + title_height + 2 * button_gap) + buttons_height;
  std::size_t text_rows = 0;
  for (const Line& line : lines_) text_rows += rows_of(line, inner);
  const auto lines = static_cast<float>(text_rows);
  // In a low window the lines move together.
  line_height_ = std::clamp((view.height - view.px(8) - rest) / std::max(lines, 1.0f),
                            view.px(least_line_height), view.px(line_height));
  panel_ = centered(view.area().center(), panel_width, rest + lines * line_height_);
  Rect area = panel_.inset(view.px(padding));
  area = area.cut_bottom(buttons_height);
  const float width =
      (area.w - space * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  Rect row;
  std::size_t placed = 0;
  for (const Button& button : buttons_.all()) {
    if (placed++ % columns == 0) {
      row = area.cut_top(height);
      area.cut_top(space);
    }
    buttons_.place(view, button.id, row.cut_left(width));
    row.cut_left(space);
  }
}

std::optional<ButtonId> Dialog::event(const Input& input, Sounds& sounds) {
  if (is_key(input, Key::escape)) return buttons_.all().back().id;
  return buttons_.event(input, sounds);
}

void Dialog::draw(Canvas& canvas) const {
  canvas.list.tip.reset();  // of what lies beneath
  fill_rounded(canvas.list, canvas.view.area(), 0, palette::scrim);
  canvas.list.covered = canvas.list.boxes.size();
  const float radius = canvas.px(16);
  fill_rounded(canvas.list, panel_.moved({0, canvas.px(8)}), radius, palette::shadow,
               canvas.px(24));
  fill_rounded(canvas.list, panel_, radius,
               Paint::vertical(panel_, palette::panel, palette::slate_top));
  stroke_rounded(canvas.list, panel_, radius, canvas.px(2),
                 Paint::vertical(panel_, palette::brass, palette::brass_dark));

  Rect rest = panel_.inset(canvas.px(padding));
  label_or_elide(canvas, rest.cut_top(canvas.px(title_height)),
                 {Face::black, 32, palette::cream, Align::center}, title_);
  rest.cut_top(canvas.px(button_gap / 2));
  for (const Line& line : lines_) {
    const std::size_t rows = rows_of(line, rest.w / canvas.view.scale);
    const Rect row = rest.cut_top(line_height_ * static_cast<float>(rows));
    if (rows > 1) {
      paragraph(canvas, row, {Face::regular, 18, palette::cream, Align::center}, line.text);
      continue;
    }
    if (line.columns) {
      draw_row(canvas, row, line);
      continue;
    }
    if (line.score.empty()) {
      label(canvas, row, {Face::regular, 20, palette::cream, Align::center}, line.text);
      continue;
    }
    Rect column = centered(row.center(), std::min(canvas.px(288), row.w), row.h);
    Color accent = palette::brass_lit;
    if (line.player) {
      draw_marker(canvas.list, *line.player, column.cut_left(canvas.px(28)).center(),
                  canvas.px(11));
      column.cut_left(canvas.px(12));
      accent = canvas.list.palette->accents[static_cast<std::size_t>(*line.player)];
    }
    label(canvas, column.cut_right(column.w / 2), {Face::black, 26, accent, Align::right},
          line.score);
    label(canvas, column, {Face::regular, 20, palette::cream}, line.text);
  }
  buttons_.draw(canvas, 20);
}

void Dialog::draw_row(Canvas& canvas, Rect row, const Line& line) const {
  row = centered(row.center(), std::min(canvas.px(440), row.w), row.h);
  label(canvas, row.cut_left(row.w * 0.36f), {Face::regular, 20, palette::muted}, line.text);
  for (std::size_t player = 0; player < 2; ++player) {
    Rect box = player == 0 ? row.cut_left(row.w / 2) : row;
    const std::string& value = (*line.columns)[player];
    if (!line.heads) {
      label(canvas, box, {Face::bold, 20, palette::cream, Align::center}, value);
      continue;
    }
    const Color accent = canvas.list.palette->accents[player];
    const TextStyle style{Face::bold, 20, accent};
    const float sign = canvas.px(30);
    const std::string name = elided(canvas, style, value, box.w - sign - canvas.px(8));
    box = centered(box.center(), sign + label_width(canvas, style, name) + 1, box.h);
    draw_marker(canvas.list, static_cast<int>(player), {box.x + canvas.px(11), box.center().y},
                canvas.px(11));
    box.cut_left(sign);
    label(canvas, box, style, name);
  }
}

}  // namespace app
