#include "app/screens/timeline.hpp"

#include <algorithm>

#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"

namespace app {
namespace {

constexpr float least_mark_width = 3;  ///< units: narrower ones would only be a grey bar

std::uint64_t total_steps(const replay::Player& player) {
  const auto& turns = player.turns();
  return turns.empty() ? 0 : turns.back().first_step + turns.back().steps;
}

}  // namespace

std::size_t turn_at(const Rect& area, const replay::Player& player, Point at) {
  const auto part = static_cast<double>((at.x - area.x) / area.w);
  const double step = part * static_cast<double>(total_steps(player));
  const auto& turns = player.turns();
  const auto after = std::ranges::upper_bound(turns, step, {}, [](const replay::Turn& turn) {
    return static_cast<double>(turn.first_step);
  });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - turns.begin(), 1) - 1);
}

void draw_timeline(Canvas& canvas, const Rect& area, const Rect& within,
                   const replay::Player& player) {
  DrawList& list = canvas.list;
  fill_rounded(list, area, canvas.px(5), palette::panel);
  const auto& turns = player.turns();
  const auto total = static_cast<float>(std::max<std::uint64_t>(total_steps(player), 1));
  const auto x_of = [&](std::uint64_t step) {
    return area.x + area.w * static_cast<float>(step) / total;
  };
  const auto end_of = [&](std::size_t turn) {
    return x_of(turns[turn].first_step + turns[turn].steps);
  };
  const bool table = !player.replay().level;
  const float least = canvas.px(least_mark_width);
  for (std::size_t end = 0; end < turns.size();) {
    const std::size_t first = end;
    const float from = x_of(turns[first].first_step);
    bool scored = false;
    // Neighbours that would be too narrow to be told apart share a mark.
    do {
      scored = scored || (end < player.reached_turns() && turns[end].points > 0);
      ++end;
    } while (end < turns.size() && end_of(end - 1) - from < least &&
             end_of(end) - end_of(end - 1) < least);
    const float to = end_of(end - 1);
    const std::size_t last = end - 1;
    const auto& wrong = player.divergence();
    const Color accent = wrong && last >= wrong->turn ? list.palette->refused
                         : last > first               ? palette::muted
                         : table
                             ? list.palette->accents[static_cast<std::size_t>(turns[first].player)]
                             : list.palette->accents[first % 2];
    const Rect box{from, area.y, std::max(to - from - 1, 1.0f), area.h};
    const float radius = std::min(canvas.px(3), box.w / 4);
    fill_rounded(list, box, radius, faded(accent, last < player.reached_turns() ? 0.55f : 0.2f));
    // A turn that brought points has a lit top.
    if (scored) {
      Rect lit = box;
      fill_rounded(list, lit.cut_top(canvas.px(5)), radius, palette::brass_lit);
    }
  }
  const float x = x_of(player.steps());
  const Rect hand =
      kept_inside(centered({x, area.center().y}, canvas.px(5), area.h + canvas.px(6)), within);
  fill_rounded(list, hand, canvas.px(2.5f), palette::cream);
  stroke_rounded(list, hand, canvas.px(2.5f), 1, palette::ink);
}

}  // namespace app
