#include "app/hud/shot_view.hpp"

#include "app/hud/aim_view.hpp"

namespace app {

void draw_shot(DrawList& list, const Viewport& viewport, games::billiards::Game game,
               const search::Shot& shot, Previewer& previewer) {
  if (shot.place && !game.apply(games::billiards::Place{*shot.place})) return;
  Aim aim;
  aim.set(search::drag(shot.aim));
  draw_aim(list, viewport, game.world(), aim,
           previewer.of(game.world(), aim, {.preview = PreviewLength::brief}, false));
}

}  // namespace app
