#include "app/screens/load_screen.hpp"

#include <utility>

#include "app/graphics/label.hpp"
#include "app/graphics/palette.hpp"
#include "app/graphics/shapes.hpp"
#include "app/view/landscape.hpp"

namespace app {
namespace {

// Of all balls together; some hundredths of a second.
constexpr std::uint64_t ball_steps_at_once = 200'000;

}  // namespace

std::uint64_t steps_at_once(const replay::Player& player) {
  const carom::World& world = replay::world(player.game());
  const std::size_t things =
      world.size() + world.scene().holes.size() + world.scene().obstacles.size();
  return std::max<std::uint64_t>(ball_steps_at_once / (things + 1), 1);
}

LoadScreen::LoadScreen(const Words& words, Session& session, KeptGames::Kept kept)
    : words_(words),
      session_(session),
      kept_(std::move(kept)),
      buttons_({{0, words(Text::cancel)}}, 0) {
  auto player = replay::Player::create(kept_.game);
  if (player) player_ = std::move(player).value();
}

void LoadScreen::resize(const View& view) {
  buttons_.explain(0, words_(Text::tip_title));
  panel_ = centered(view.area().center(), std::min(view.px(480), view.width - view.px(16)),
                    view.px(200));
  buttons_.place(
      view, 0,
      centered({panel_.center().x, panel_.bottom() - view.px(56)}, view.px(200), view.button(48)));
}

Navigation LoadScreen::event(const Input& input) {
  const bool cancelled = is_key(input, Key::escape) || buttons_.event(input, session_.sounds);
  if (cancelled) return ShowTitle{};
  return Stay{};
}

Navigation LoadScreen::iterate(nanoseconds) {
  if (!player_) return refuse(ReplayFault::damaged);
  if (player_->look_ahead(steps_at_once(*player_))) return Stay{};
  return player_->divergence() ? refuse(ReplayFault::diverged) : finish();
}

Navigation LoadScreen::refuse(ReplayFault fault) {
  session_.kept.refuse(kept_.place.name, fault);
  return ShowTitle{};
}

Navigation LoadScreen::finish() {
  player_->seek(player_->turns().size());
  if (replay::over(player_->game())) return refuse(ReplayFault::finished);
  if (const auto* table = std::get_if<games::billiards::Game>(&player_->game()))
    return Resume{BilliardsRecorder(*table, player_->replay()), std::move(kept_.place)};
  const auto& level = std::get<games::angry_balls::Game>(player_->game());
  Campaign& campaign = session_.campaign;
  const Level played = level_of(level.level());
  const auto index = campaign.find(played.identity);
  campaign.current = index.value_or(campaign.levels.size());
  // A level whose file has changed or gone can still be played to its end.
  if (!index) campaign.levels.push_back(played);
  return Resume{LevelRecorder(level, player_->replay()), std::move(kept_.place)};
}

void LoadScreen::draw(Canvas& canvas) const {
  draw_night(canvas.list, canvas.view.area(), canvas.view.height);
  canvas.list.stand_still();
  Rect rest = panel_.inset(canvas.px(16));
  label(canvas, rest.cut_top(canvas.px(56)), {Face::black, 28, palette::cream, Align::center},
        words_(Text::loading));
  if (player_)
    label(canvas, rest.cut_top(canvas.px(36)), {Face::regular, 20, palette::muted, Align::center},
          words_(Text::turns_loaded, {words_.number(static_cast<int>(player_->reached_turns())),
                                      words_.number(static_cast<int>(player_->turns().size()))}));
  buttons_.draw(canvas, 20);
}

}  // namespace app
