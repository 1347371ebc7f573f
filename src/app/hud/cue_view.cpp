#include "app/hud/cue_view.hpp"

#include <array>

#include "app/graphics/crop.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

// World px.
constexpr double length_of_cue = 260;
constexpr double ferrule = 5;  ///< the white end

}  // namespace

void draw_cue(DrawList& list, const Rect& area, const Viewport& viewport, const carom::Ball& ball,
              const ComputerTurn::Cue& cue) {
  const std::size_t first = list.indices.size();
  const auto at = [&](double back) {
    return viewport.to_window(ball.position - (ball.radius + cue.back + back) * cue.way);
  };
  const Point tip = at(0);
  const Point butt = at(length_of_cue);
  const Point across = unit(turned(butt - tip));
  // It is thicker towards its end.
  const auto shaft = [&](double from, double to, float by, const Paint& paint) {
    const auto half = [&](double back) {
      return across * (by * viewport.px(1.6 + 2.2 * back / length_of_cue));
    };
    fill(list,
         std::array{at(from) + half(from), at(to) + half(to), at(to) - half(to),
                    at(from) - half(from)},
         paint);
  };
  shaft(0, length_of_cue, 1.5f, faded(palette::ink, 0.45f));
  shaft(ferrule, length_of_cue, 1, Paint(tip, palette::wood, butt, palette::wood_shade));
  shaft(0, ferrule, 1, palette::cream);
  shaft(length_of_cue * 0.6, length_of_cue * 0.63, 1, palette::brass_lit);
  crop(list, first, area);
}

}  // namespace app
