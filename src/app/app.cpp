#include "app/app.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/angry_balls_screen.hpp"
#include "app/billiards_screen.hpp"
#include "app/level_menu.hpp"
#include "app/load_screen.hpp"
#include "app/replay_list.hpp"
#include "app/replay_screen.hpp"
#include "app/settings_screen.hpp"
#include "app/title_screen.hpp"

namespace app {

namespace {

std::vector<Level> with_shipped(std::vector<Level> own) {
  std::vector<Level> levels = shipped_levels();
  std::ranges::move(own, std::back_inserter(levels));
  return levels;
}

}  // namespace

App::App(StartLanguage start, int width, int height, Store& store, Clipboard& clipboard,
         std::vector<Level> levels)
    : words_(start.language),
      session_(store, clipboard, with_shipped(std::move(levels))),
      view_(View::of(width, height)) {
  session_.system_language = start.language;
  if (start.asked) session_.asked_language = start.language;
  words_.speak(language_of(session_));
  words_.name_players(session_.settings.get().names);
  go(Transition::title);
}

void App::event(const Input& input) {
  if (const auto* resized = std::get_if<Resized>(&input)) {
    view_ = View::of(resized->width, resized->height);
    font_.clear();  // the sizes in use have changed
    screen_->resize(view_);
  } else if (is_key(input, Key::m) && !screen_->typing()) {
    mute();
  } else {
    if (presses_button(input)) session_.sounds.note({SoundKind::click});
    go(screen_->event(input));
  }
}

/// By what was drawn last, which is what the player sees.
bool App::presses_button(const Input& input) const {
  std::span<const Box> open = std::span(list_.boxes).subspan(list_.covered);
  if (const auto* press = std::get_if<PointerPressed>(&input))
    return press->button == PointerButton::left && std::ranges::any_of(open, [&](const Box& box) {
             return box.kind == Box::Kind::button && box.area.contains(press->at);
           });
  const bool enter = is_key(input, Key::enter);
  if (!enter && !is_key(input, Key::space)) return false;
  return std::ranges::any_of(open, &Box::focused) ||
         (enter && std::ranges::any_of(open, &Box::primary));
}

void App::mute() {
  Settings settings = session_.settings.get();
  settings.mute = !settings.mute;
  session_.settings.set(settings);
  toast_.show(words_(settings.mute ? Text::sound_off : Text::sound_on));
}

std::vector<SoundEvent> App::take_sounds() {
  auto sounds = session_.sounds.take();
  if (session_.settings.get().mute) sounds.clear();
  return sounds;
}

void App::iterate(nanoseconds elapsed) {
  toast_.advance(elapsed);
  go(screen_->iterate(elapsed));
}

void App::watch(replay::Replay replay) {
  session_.to_watch = std::move(replay);
  go(Transition::replay);
}

const DrawList& App::draw() {
  do {
    if (font_.full()) font_.grow();
    list_.clear();
    list_.palette = &Palette::of(session_.settings.get().colours);
    const bool calm = session_.calm();
    Canvas canvas{list_, font_, view_, calm, session_.settings.get().screen_shake && !calm};
    screen_->draw(canvas);
    toast_.draw(canvas);
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
      screen_ = std::make_unique<TitleScreen>(words_, session_);
      break;
    case Transition::billiards:
      screen_ = std::make_unique<BilliardsScreen>(words_, session_);
      break;
    case Transition::practice_table:
      screen_ =
          std::make_unique<BilliardsScreen>(words_, session_, BilliardsScreen::Mode::practice);
      break;
    case Transition::levels:
      screen_ = std::make_unique<LevelMenu>(words_, session_.campaign);
      break;
    case Transition::level:
      screen_ = std::make_unique<AngryBallsScreen>(words_, session_);
      break;
    case Transition::load:
      screen_ = std::make_unique<LoadScreen>(words_, session_);
      break;
    case Transition::resume:
      resume();
      break;
    case Transition::replays:
      screen_ = std::make_unique<ReplayList>(words_, session_);
      break;
    case Transition::replay: {
      auto player = replay::Player::create(*std::exchange(session_.to_watch, {}));
      if (!player) return;  // a game that has outgrown every limit
      below_ = std::exchange(
          screen_, std::make_unique<ReplayScreen>(words_, session_, std::move(player).value()));
      break;
    }
    case Transition::settings:
      below_ = std::exchange(screen_, std::make_unique<SettingsScreen>(words_, session_));
      break;
    case Transition::back:
      screen_ = std::move(below_);
      break;
  }
  screen_->resize(view_);
}

void App::resume() {
  auto loaded = *std::exchange(session_.loaded, {});
  if (auto* table = std::get_if<BilliardsRecorder>(&loaded))
    screen_ = std::make_unique<BilliardsScreen>(words_, session_, std::move(*table));
  else
    screen_ = std::make_unique<AngryBallsScreen>(words_, session_,
                                                 std::move(std::get<LevelRecorder>(loaded)));
}

}  // namespace app
