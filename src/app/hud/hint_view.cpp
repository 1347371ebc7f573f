#include "app/hud/hint_view.hpp"

#include <cmath>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

// Units.
constexpr float most_width = 680;
constexpr float line_height = 24;
constexpr float text_size = 17;

constexpr double way_length = 150;  // world px

std::string per_cent(const Words& words, double rate) {
  return words.number(std::lround(100 * rate));
}

}  // namespace

std::string hint_in_words(const Words& words, const Hint& hint, bool level) {
  if (hint.searching()) return words(Text::hint_searching);
  if (!hint.tells(Hint::Step::way)) return words(hint.ball() ? Text::hint_ball : Text::hint_way);
  if (!hint.tells(Hint::Step::aim)) return words(Text::hint_way);
  const search::Aim& aim = hint.shot().shot.aim;
  const search::Record& record = hint.shot().fresh;
  const std::string angle = words.tenths(aim.tenths / 10.0);
  const std::string speed = words.number(aim.speed);
  if (hint.error() == 0)
    return words(level ? Text::hint_exact_out : Text::hint_exact,
                 {angle, speed, words.number(level ? record.enemies_out : record.points)});
  const search::Estimate rate = level ? record.cleared_estimate() : record.scored_estimate();
  const std::string hand = hint.error() < 1 ? words.tenths(hint.error())
                                            : words.number(static_cast<std::int64_t>(hint.error()));
  return words(level ? Text::hint_clears : Text::hint_scores,
               {angle, speed, hand, per_cent(words, rate.mean), per_cent(words, rate.low),
                per_cent(words, rate.high)});
}

void draw_hint(Canvas& canvas, const Rect& area, const Viewport& viewport,
               const carom::World& world, const Hint& hint, const Words& words) {
  DrawList& list = canvas.list;
  if (!hint.searching() && !hint.tells(Hint::Step::aim)) {
    const auto index = hint.ball() ? world.index_of(*hint.ball()) : std::nullopt;
    if (index) {
      const carom::Ball ball = world.ball(*index);
      const Point at = viewport.to_window(ball.position);
      const float radius = viewport.px(ball.radius) * 1.6f;
      stroke_circle(list, at, radius, canvas.px(5), faded(palette::ink, 0.6f));
      stroke_circle(list, at, radius, canvas.px(3), palette::brass_lit);
    }
    if (hint.tells(Hint::Step::way)) {
      const carom::Ball lead = world.ball(0);
      const carom::Vec2 way = carom::unit(hint.aim().drag());
      dashed_line(list, viewport.to_window(lead.position + 1.5 * lead.radius * way),
                  viewport.to_window(lead.position + way_length * way), canvas.px(3), canvas.px(8),
                  palette::brass_lit);
    }
  }
  const std::string text = hint_in_words(words, hint, world.scene().gravity > 0);
  const TextStyle style{Face::bold, text_size, palette::cream, Align::center};
  const float most = std::min(area.w - canvas.px(16), canvas.px(most_width));
  const float wanted = label_width(canvas, style, text) + canvas.px(28);
  const int lines = wanted <= most ? 1 : 2;
  Rect box = area.inset(canvas.px(8), canvas.px(6));
  box = centered(
      {area.center().x, box.y + canvas.px(line_height * static_cast<float>(lines) + 8) / 2},
      std::min(wanted, most), canvas.px(line_height * static_cast<float>(lines) + 8));
  fill_rounded(list, box, canvas.px(8), faded(palette::ink, 0.88f));
  stroke_rounded(list, box, canvas.px(8), canvas.px(1), palette::brass_dark);
  const Rect inside = box.inset(canvas.px(12), canvas.px(4));
  if (lines == 1)
    label(canvas, inside, style, text);
  else
    paragraph(canvas, inside, style, text);
}

}  // namespace app
