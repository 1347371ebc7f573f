#include "app/screens/place_ball.hpp"

#include <algorithm>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/balls.hpp"
#include "games/launch.hpp"

namespace app {
namespace {

using games::billiards::Obstruction;

constexpr double key_way = 5;      // px
constexpr double fine_way = 1;     // px
constexpr double stick_way = 250;  // px a second

Text reason(Obstruction obstruction) {
  switch (obstruction) {
    case Obstruction::ball:
      return Text::on_ball;
    case Obstruction::hole:
      return Text::on_hole;
    case Obstruction::cushion:
      return Text::on_cushion;
    case Obstruction::none:
      break;
  }
  return Text::hint_place;
}

}  // namespace

Obstruction PlaceBall::obstruction(const Stage& stage) {
  return stage.game.obstruction(games::on_grid(stage.viewport.to_world(stage.pointer)));
}

PlaceBall::Outcome PlaceBall::event(const Input& input, const Stage& stage) {
  to = stage.pointer;
  if (const auto* press = std::get_if<PointerPressed>(&input))
    return press->button == PointerButton::left && !stage.on_button ? Outcome::put
                                                                    : Outcome::untouched;
  carom::Vec2 by;
  if (const auto* key = std::get_if<KeyPressed>(&input)) {
    const double way = key->shift || key->ctrl ? fine_way : key_way;
    switch (key->key) {
      case Key::left:
        by.x = -way;
        break;
      case Key::right:
        by.x = way;
        break;
      case Key::up:
        by.y = way;
        break;
      case Key::down:
        by.y = -way;
        break;
      case Key::enter:
      case Key::space:
        return stage.focus_elsewhere ? Outcome::untouched : Outcome::put;
      default:
        return Outcome::untouched;
    }
  } else if (const auto* steered = std::get_if<Steered>(&input)) {
    const double way = stick_way * std::chrono::duration<double>(steered->time).count();
    by = {way * static_cast<double>(steered->across), way * static_cast<double>(steered->up)};
  } else {
    return Outcome::untouched;
  }
  const carom::Scene& table = stage.game.world().scene();
  const carom::Vec2 at = stage.viewport.to_world(stage.pointer) + stage.viewport.seen_as(by);
  to = stage.viewport.to_window(
      {std::clamp(at.x, 0.0, table.width), std::clamp(at.y, 0.0, table.height)});
  return Outcome::carried;
}

std::string PlaceBall::hint(const Words& words, const Stage& stage) {
  const Obstruction found = obstruction(stage);
  if (found == Obstruction::none) return words(Text::hint_place);
  return words(Text::hint_obstructed, {words(reason(found))});
}

Color PlaceBall::hint_color(const Palette& palette, const Stage& stage) {
  return obstruction(stage) == Obstruction::none ? palette.allowed : palette.refused;
}

void PlaceBall::draw(Canvas& canvas, const Words& words, const Stage& stage) {
  const Point at = stage.pointer;
  if (!stage.table.contains(at)) return;
  DrawList& list = canvas.list;
  const Viewport& viewport = stage.viewport;
  const float r = viewport.px(stage.game.world().ball(0).radius);
  const Obstruction found = obstruction(stage);
  if (found == Obstruction::none) {
    draw_ball_shadow(list, at, r);
    draw_ball(list, at, r, BallKind::ivory);
    stroke_circle(list, at, r * 1.8f, viewport.px(2), list.palette->allowed);
    return;
  }
  // A dark ground first: the sign must stand out among red balls.
  fill_disc(list, at, r * 2.1f, faded(palette::ink, 0.75f));
  draw_ball(list, at, r, look_of(BallKind::ivory, *list.palette), 0.6f);
  dashed_circle(list, at, r * 1.7f, viewport.px(2.6), 8, list.palette->refused);
  const float arm = r * 0.8f;
  for (const float side : {-1.0f, 1.0f})
    line(list, at + Point{-arm, -arm * side}, at + Point{arm, arm * side}, viewport.px(3.4),
         rgb(0xc22a1c));
  const TextStyle style{Face::bold, 16, list.palette->refused};
  const std::string why = words(reason(found));
  const Point above = at - Point{0, r * 1.8f + canvas.px(22)};
  pill(canvas, pill_box(canvas, above, stage.table, style, why), style, why);
}

}  // namespace app
