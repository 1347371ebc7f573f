#include "app/app.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/hud/lesson.hpp"
#include "app/screens/dialog_screen.hpp"
#include "app/screens/make_screen.hpp"
#include "app/storage/links.hpp"
#include "app/widgets/level_fault.hpp"
#include "app/widgets/tip.hpp"
#include "carom/scene_file.hpp"
#include "replay/level_text.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace app {

namespace {

std::vector<Level> with_shipped(std::vector<Level> own) {
  std::vector<Level> levels = shipped_levels();
  for (Level& level : own) level.origin = Origin::own;
  std::ranges::move(own, std::back_inserter(levels));
  return levels;
}

// A player who does nothing is told what to do, and now and then the ball catches the eye.
constexpr nanoseconds nudge_after = seconds{20};
constexpr nanoseconds nudge_time = seconds{4};

float nudge_phase(nanoseconds quiet) {
  using Parts = std::chrono::duration<float>;
  return std::min(Parts(quiet % nudge_after).count() / Parts(nudge_time).count(), 1.0f);
}

}  // namespace

App::App(StartLanguage start, int width, int height, Store& store, Clipboard& clipboard,
         std::vector<Level> levels, HostEnvironment host)
    : words_(start.language),
      store_(store),
      session_(store, clipboard, with_shipped(std::move(levels)), std::move(host)),
      view_(View::of(width, height)),
      stack_(session_.sounds) {
  given_levels_ = session_.campaign.levels.size();
  session_.system_language = start.language;
  session_.system_reduced_motion = session_.host.reduced_motion;
  if (start.asked) session_.asked_language = start.language;
  speak(session_, words_);
  words_.name_players(session_.settings.get().names);
  session_.keyboard.bindings = session_.settings.get().keys;
  if (session_.host.touch) words_.take_hand(InputDevice::finger);
  laid_out_for_ = words_.hand();
  view_.touch = session_.host.touch;
  stack_.resize(view_);
  go(ShowTitle{});
}

void App::event(const Input& input) {
  if (const auto* resized = std::get_if<Resized>(&input)) {
    view_ = View::of(resized->width, resized->height, resized->density);
    view_.touch = words_.hand() == InputDevice::finger;
    atlas_.clear();  // the sizes in use have changed
    stack_.resize(view_);
    return;
  }
  quiet_ = nanoseconds{0};
  if (const auto* finger = std::get_if<Finger>(&input)) {
    for (const Input& meant : fingers_.event(*finger)) give(meant);
  } else if (std::holds_alternative<PadPressed>(input) ||
             std::holds_alternative<PadReleased>(input) ||
             std::holds_alternative<PadMoved>(input) ||
             std::holds_alternative<PadUnplugged>(input)) {
    for (const Input& meant : pad_.event(input, steers())) give(meant);
  } else if (screen().letters() == Letters::keys && std::holds_alternative<KeyPressed>(input)) {
    give(input);
  } else if (const auto meant = session_.keyboard.bindings.meaning(input)) {
    give(*meant);
  }
  note_hand(input);
}

bool App::back() {
  if (screen().is_first()) return false;
  event(KeyPressed{Key::escape});
  return true;
}

void App::take_texts(Language language, std::string file) {
  if (!load_texts(language, std::move(file))) return;
  speak(session_, words_);
  atlas_.clear();        // of what it has, little is needed any more
  stack_.resize(view_);  // buttons are written anew
}

void App::mute() {
  Settings settings = session_.settings.get();
  settings.mute = !settings.mute;
  session_.settings.set(settings);
  toast_.show(words_(settings.mute ? Text::sound_off : Text::sound_on,
                     {session_.keyboard.name(Command::mute)}));
}

/// Saves them with the settings, once they were changed.
void App::keep_keys() {
  if (session_.settings.get().keys == session_.keyboard.bindings) return;
  Settings settings = session_.settings.get();
  settings.keys = session_.keyboard.bindings;
  session_.settings.set(std::move(settings));
  stack_.resize(view_);  // buttons name keys
}

std::vector<SoundEvent> App::take_sounds() {
  auto sounds = session_.sounds.take();
  if (session_.settings.get().mute) sounds.clear();
  return sounds;
}

/// Texts and buttons are for the hand used last. Buttons grow for fingers as soon as the first is
/// lifted, and shrink once the mouse lets go: nothing moves beneath either.
void App::note_hand(const Input& input) {
  const auto* moved = std::get_if<PadMoved>(&input);
  if (std::holds_alternative<Finger>(input))
    words_.take_hand(InputDevice::finger);
  else if (std::holds_alternative<PadPressed>(input) || (moved && std::abs(moved->value) > 0.5f))
    words_.take_hand(InputDevice::pad);
  else if (std::holds_alternative<PointerPressed>(input) ||
           // A finger may press keys too: those of the screen's keyboard.
           (std::holds_alternative<KeyPressed>(input) && words_.hand() == InputDevice::pad))
    words_.take_hand(InputDevice::mouse);
  if (std::holds_alternative<PointerPressed>(input)) mouse_held_ = true;
  if (std::holds_alternative<PointerReleased>(input)) mouse_held_ = false;
  if (words_.hand() == laid_out_for_ || mouse_held_ || !fingers_.none()) return;
  laid_out_for_ = words_.hand();
  view_.touch = laid_out_for_ == InputDevice::finger;
  stack_.resize(view_);
}

void App::give(const Input& input) {
  const Letters letters = screen().letters();
  if (letters == Letters::keys) {
    go(stack_.event(input));
    return keep_keys();
  }
  const auto* typed = std::get_if<TextTyped>(&input);
  const bool asks = typed && typed->text == "?" && letters == Letters::commands;
  if (is_key(input, Key::help) || asks) {
    go(stack_.event(PointerCancelled{}));  // nothing is held meanwhile
    return go(ShowHelp{});
  }
  if (std::holds_alternative<CommandPressed>(input) && letters == Letters::text) return;
  if (is_command(input, Command::mute))
    mute();
  else
    give_to_screen(input);
}

void App::give_to_screen(const Input& input) {
  const bool does = std::holds_alternative<PointerPressed>(input) || is_press_of_key(input) ||
                    std::holds_alternative<TextTyped>(input) ||
                    std::holds_alternative<WheelTurned>(input) ||
                    std::holds_alternative<Steered>(input);
  if (does && session_.teach && screen().aim_prompt()) {
    session_.teach = false;
    Settings settings = session_.settings.get();
    settings.taught = true;
    session_.settings.set(std::move(settings));
  }
  go(stack_.event(input));
}

void App::iterate(nanoseconds elapsed) {
  toast_.advance(elapsed);
  quiet_ += elapsed;
  for (const Input& meant : pad_.advance(elapsed, steers())) {
    quiet_ = nanoseconds{0};
    give(meant);
  }
  go(stack_.iterate(elapsed));
}

bool App::animating() const {
  if (pad_.held() || toast_.active()) return true;
  const bool calls = quiet_ >= nudge_after && quiet_ % nudge_after < nudge_time;
  return stack_.animating() || (calls && session_.settings.get().hints && screen().aim_prompt());
}

void App::teach_beginners() {
  const Campaign& campaign = session_.campaign;
  session_.teach = !session_.settings.get().taught && session_.kept.names().empty() &&
                   session_.saved.names().empty() &&
                   std::ranges::none_of(campaign.levels, [&](const Level& level) {
                     return campaign.best.of(level.identity).has_value();
                   });
}

void App::watch(replay::Replay replay) {
  go(stack_.event(PointerCancelled{}));
  go(Watch{std::move(replay)});
}

void App::open_link(std::string_view link) {
  if (const auto text = behind(links::replay, link)) {
    auto read = replay::read_text(*text);
    if (read) return watch(std::move(read).value());
    refuse(Text::link_refused,
           words_(fault_of(read.errors()) == ReplayFault::other_version ? Text::paste_other_version
                                                                        : Text::link_damaged));
  } else if (const auto level = behind(links::level, link)) {
    const auto read = replay::read_level_text(*level);
    if (!read) return refuse(Text::link_refused, words_(Text::link_damaged));
    Level sound = read_level({}, carom::write_scene(read.value()));
    if (!sound.scene) return refuse(Text::link_refused, problem_of(words_, sound));
    play(std::move(sound));
  }
}

void App::open_file(const std::string& name, const std::string& bytes) {
  if (auto read = replay::read_replay(bytes)) return watch(std::move(read).value());
  Level level = read_level(name, bytes);
  if (!level.scene) return refuse(Text::file_refused, problem_of(words_, level));
  // Saved under a name that says what is in it: the same level again is not a second one.
  const std::string saved = own_levels + level.identity;
  const auto earlier = store_.load(saved + ".json");  // as earlier versions saved it
  const bool kept =
      (earlier && earlier.value()) || store_.save_new(saved + ".angry-level", bytes).ok();
  level.origin = Origin::own;
  play(std::move(level));
  if (!kept) go(message(words_, words_(Text::level_not_kept), {}));
}

void App::take_levels(std::vector<Level> own) {
  Campaign& campaign = session_.campaign;
  const std::string in_play = stack_.bottom().level_in_play();
  const Level current = campaign.current < campaign.levels.size()
                            ? campaign.levels[campaign.current]
                            : Level{{}, carom::Error{}, {}, {}};
  std::vector<Level> levels = with_shipped(std::move(own));
  const auto given = [count = levels.size(),
                      &levels](const Level& level) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < count; ++i) {
      const bool same_file = level.origin == Origin::own && levels[i].origin == Origin::own &&
                             levels[i].file == level.file;
      if (same_file || (level.scene && levels[i].identity == level.identity)) return i;
    }
    return std::nullopt;
  };
  const std::size_t given_levels = levels.size();
  for (std::size_t i = given_levels_; i < campaign.levels.size(); ++i)
    if (!given(campaign.levels[i])) levels.push_back(campaign.levels[i]);
  std::optional<std::size_t> index = given(current);
  campaign.levels = std::move(levels);
  given_levels_ = given_levels;
  if (!index && current.scene) index = campaign.find(current.identity);
  campaign.current = index.value_or(0);
  if (in_play.empty()) return go(stack_.bottom().levels_changed());
  if (index && !campaign.levels[*index].scene) {
    toast_.show(problem_of(words_, campaign.levels[*index]));
    index.reset();
  }
  if (!index) {  // what is being played stays
    campaign.levels.push_back(current);
    campaign.current = campaign.levels.size() - 1;
    return;
  }
  Navigation anew = stack_.bottom().levels_changed();
  if (std::holds_alternative<Stay>(anew)) return;
  go(std::move(anew));
  toast_.show(words_(Text::level_read_again));
}

void App::play(Level level) {
  Campaign& campaign = session_.campaign;
  const auto index = campaign.find(level.identity);
  const std::size_t at = index.value_or(campaign.levels.size());
  if (!index) campaign.levels.push_back(std::move(level));
  go(PlayLevel{at});
}

void App::refuse(Text title, std::string line) {
  go(ShowTitle{});
  go(message(words_, words_(title), {{std::move(line), {}, {}}}));
}

const DrawList& App::draw() {
  const Palette* const palette = &Palette::of(session_.settings.get().colours);
  if (palette != list_.palette) atlas_.clear();  // stamps are coloured
  list_.palette = palette;
  do {
    if (atlas_.full()) atlas_.grow();
    list_.clear();
    list_.stamps = &stamps_;
    const bool calm = session_.calm();
    Canvas canvas{list_, font_, view_, calm, session_.settings.get().screen_shake && !calm};
    stack_.draw(canvas);
    const bool hints = session_.settings.get().hints;
    if (const auto call = screen().aim_prompt()) {
      if (session_.teaches())
        draw_lesson(canvas, *call, words_);
      else if (quiet_ >= nudge_after && hints)
        draw_nudge(canvas, *call, nudge_phase(quiet_), words_);
    }
    draw_tip(canvas);
    toast_.draw(canvas);
  } while (atlas_.full());
  return list_;
}

void App::go(Navigation request) {
  request = stack_.apply(std::move(request));
  if (std::holds_alternative<Quit>(request)) quit_requested_ = true;
  const bool over = lies_over(request);
  auto screen = make_screen(words_, session_, std::move(request));
  if (!screen) return;
  if (over)
    stack_.cover(std::move(screen));
  else
    stack_.show(std::move(screen));
}

}  // namespace app
