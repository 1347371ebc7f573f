#include "app/dialog.hpp"

#include "app/label.hpp"
#include "app/markers.hpp"
#include "app/palette.hpp"
#include "app/shapes.hpp"

namespace app {
namespace {

// Units.
constexpr float padding = 32;
constexpr float title_height = 48;
constexpr float line_height = 40;
constexpr float button_height = 48;
constexpr float gap = 16;

}  // namespace

Dialog::Dialog(std::string title, std::vector<Line> lines, std::vector<std::string> buttons)
    : title_(std::move(title)), lines_(std::move(lines)), buttons_(std::move(buttons), 0) {}

void Dialog::resize(const View& view) {
  const float height = 2 * padding + title_height +
                       line_height * static_cast<float>(lines_.size()) + 2 * gap + button_height;
  panel_ = centered(view.area().center(),
                    std::min(view.px(buttons_.size() > 2 ? 560 : 480), view.width - view.px(16)),
                    view.px(height));
  Rect row = panel_.inset(view.px(padding));
  row = row.cut_bottom(view.px(button_height));
  const auto n = static_cast<float>(buttons_.size());
  const float width = (row.w - view.px(gap) * (n - 1)) / n;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_.place(i, row.cut_left(width));
    row.cut_left(view.px(gap));
  }
}

std::optional<std::size_t> Dialog::event(const Input& input) {
  if (is_key(input, Key::escape)) return buttons_.size() - 1;
  return buttons_.event(input);
}

void Dialog::draw(Canvas& canvas) const {
  fill_rounded(canvas.list, canvas.view.area(), 0, palette::scrim);
  const float radius = canvas.px(16);
  fill_rounded(canvas.list, panel_.moved({0, canvas.px(8)}), radius, palette::shadow,
               canvas.px(24));
  fill_rounded(canvas.list, panel_, radius,
               Paint::vertical(panel_, palette::panel, palette::slate_top));
  stroke_rounded(canvas.list, panel_, radius, canvas.px(2),
                 Paint::vertical(panel_, palette::brass, palette::brass_dark));

  Rect rest = panel_.inset(canvas.px(padding));
  label(canvas, rest.cut_top(canvas.px(title_height)),
        {Face::black, 32, palette::cream, Align::center}, title_);
  rest.cut_top(canvas.px(gap / 2));
  for (const Line& line : lines_) {
    const Rect row = rest.cut_top(canvas.px(line_height));
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
      accent = palette::accents[static_cast<std::size_t>(*line.player)];
    }
    label(canvas, column.cut_right(column.w / 2), {Face::black, 26, accent, Align::right},
          line.score);
    label(canvas, column, {Face::regular, 20, palette::cream}, line.text);
  }
  buttons_.draw(canvas, 20);
}

}  // namespace app
