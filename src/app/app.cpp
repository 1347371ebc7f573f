#include "app/app.hpp"

#include <iterator>

#include "app/angry_balls_screen.hpp"
#include "app/billiards_screen.hpp"
#include "app/level_menu.hpp"
#include "app/title_screen.hpp"

namespace app {

App::App(Language language, int width, int height, Store& store, std::vector<Level> levels)
    : words_(language),
      campaign_{shipped_levels(), BestScores(store), 0},
      view_(View::of(width, height)) {
  std::ranges::move(levels, std::back_inserter(campaign_.levels));
  go(Transition::title);
}

void App::event(const Input& input) {
  if (const auto* resized = std::get_if<Resized>(&input)) {
    view_ = View::of(resized->width, resized->height);
    font_.clear();  // the sizes in use have changed
    screen_->resize(view_);
  } else {
    go(screen_->event(input));
  }
}

void App::iterate(nanoseconds elapsed) { screen_->iterate(elapsed); }

const DrawList& App::draw() {
  do {
    if (font_.full()) font_.grow();
    list_.clear();
    Canvas canvas{list_, font_, view_};
    screen_->draw(canvas);
  } while (font_.full());
  return list_;
}

void App::go(Transition transition) {
  switch (transition) {
    case Transition::stay:
      return;
    case Transition::quit:
      quit_requested_ = true;
      return;
    case Transition::title:
      screen_ = std::make_unique<TitleScreen>(words_);
      break;
    case Transition::billiards:
      screen_ = std::make_unique<BilliardsScreen>(words_);
      break;
    case Transition::levels:
      screen_ = std::make_unique<LevelMenu>(words_, campaign_);
      break;
    case Transition::level:
      screen_ = std::make_unique<AngryBallsScreen>(words_, campaign_);
      break;
  }
  screen_->resize(view_);
}

}  // namespace app
