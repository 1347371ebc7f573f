// What is written over a table leaves the rack, the cue ball and the pockets in sight.

#include <algorithm>
#include <array>

#include "app/player.hpp"
#include "app/view/clear_place.hpp"
#include "app/view/table_view.hpp"
#include "app/widgets/widgets.hpp"
#include "carom/world.hpp"

namespace {

using namespace std::chrono_literals;

constexpr std::array sizes{std::pair{800, 600},  std::pair{1024, 768},  std::pair{1280, 720},
                           std::pair{1366, 768}, std::pair{1920, 1080}, std::pair{2560, 1440}};

/// Balls and pockets of a game that begins.
std::vector<app::Rect> in_sight(const app::View& view) {
  const carom::World table = carom::World::create(games::billiards::rack()).value();
  const app::Rect world = app::GameLayout::of(view).world;
  return app::things_in(table, app::table_viewport(world.inset(view.px(8)), table.scene()));
}

/// What stands around the boxes with these texts.
app::Rect around(const std::vector<app::Box>& boxes, const std::vector<std::string>& texts) {
  std::optional<app::Rect> all;
  for (const app::Box& box : boxes)
    if (std::ranges::find(texts, box.text) != texts.end()) {
      if (!all) all = box.area;
      const float right = std::max(all->right(), box.area.right());
      const float bottom = std::max(all->bottom(), box.area.bottom());
      all->x = std::min(all->x, box.area.x);
      all->y = std::min(all->y, box.area.y);
      all->w = right - all->x;
      all->h = bottom - all->y;
    }
  return all.value_or(app::Rect{});
}

TEST(Lesson, CoversNeitherRackNorCueBallNorPocket) {
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(std::to_string(width) + "×" + std::to_string(height));
    Player game(app::Language::en, width, height);
    game.app().teach_beginners();
    game.key(app::Key::enter);
    game.pass(600ms);
    const app::View view = app::View::of(width, height);
    app::Rect words = around(game.boxes(), {"Click a target", "Set the strength", "Shoot!"});
    ASSERT_GT(words.w, 0) << "the lesson is not there";
    // Above the words of the panel are its pictures; it may be as low as this.
    const float panel = view.px(0.7f * 168) - view.px(16);
    words = {words.x, words.bottom() - panel, words.w, panel};
    for (const app::Rect& thing : in_sight(view))
      EXPECT_FALSE(words.overlaps(thing))
          << thing.x << ' ' << thing.y << ' ' << thing.w << " under " << words.x << ' ' << words.y
          << ' ' << words.w << ' ' << words.h;
  }
}

TEST(Announcement, OfTheFirstTurnCoversNeitherRackNorCueBallNorPocket) {
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(std::to_string(width) + "×" + std::to_string(height));
    Player game(app::Language::en, width, height);
    game.key(app::Key::enter);
    game.pass(600ms);
    const app::Rect words = around(game.boxes(), {"Player 1 to play"});
    ASSERT_GT(words.w, 0) << "nothing is announced";
    EXPECT_EQ(app::covered(words, in_sight(app::View::of(width, height))), 0U);
  }
}

}  // namespace
