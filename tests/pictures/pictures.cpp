// Takes a picture of every screen, at the sizes that count and in both languages, to be looked at:
//   pictures FOLDER [WxH...]
// FOLDER/WxH/LANGUAGE/NN-name.png, and in FOLDER/figures.txt what each costs to draw.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "app/screens/billiards_screen.hpp"
#include "app/screens/review_screen.hpp"
#include "app/screens/screen_stack.hpp"
#include "platform/null_platform.hpp"
#include "platform/png.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;

struct Size {
  int width, height;
  bool phone = false;  ///< played by fingers
};
constexpr Size sizes[] = {
    {1280, 720}, {800, 600}, {1920, 1080}, {390, 844, true}, {844, 390, true}};

std::string read(const std::string& path) {
  std::ifstream file(SOURCE_DIR "/" + path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "cannot read %s\n", path.c_str());
    std::exit(1);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

/// How often a pixel is drawn over, on average.
double layers(const app::DrawList& list, Size size) {
  double area = 0;
  for (std::size_t i = 0; i + 2 < list.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      return list.vertices[static_cast<std::size_t>(list.indices[i + k])].position;
    };
    area += 0.5 * std::abs(static_cast<double>(dot(turned(at(1) - at(0)), at(2) - at(0))));
  }
  return area / (static_cast<double>(size.width) * static_cast<double>(size.height));
}

class Visitor {
 public:
  Visitor(const std::filesystem::path& folder, Size size, app::Language language,
          std::ofstream& figures)
      : folder_(folder / (std::to_string(size.width) + "x" + std::to_string(size.height)) /
                std::string(app::code_of(language))),
        size_(size),
        words_(language),
        figures_(figures) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  void visit() {
    titles();
    billiards();
    end_of_billiards();
    ways_of_aiming();
    new_game();
    computer();
    hints();
    practice();
    levels();
    replays();
    settings();
    palettes();
    troubles();
  }

 private:
  /// A program just started, with what is kept in `store`.
  struct Game : platform::NullPlatform {
    Game(const Visitor& visitor, app::Store& store)
        : NullPlatform(visitor.words_.language(), visitor.size_.width, visitor.size_.height, {},
                       store),
          fingers(visitor.size_.phone) {
      if (fingers) click({1, 1});
    }
    /// With a finger, on a telephone.
    void click(app::Point at) {
      if (!fingers) return NullPlatform::click(at);
      for (const auto phase : {app::Finger::Phase::down, app::Finger::Phase::up})
        app().event(app::Finger{0, phase, at});
    }
    void key(Key key) {
      app().event(app::KeyPressed{key});
      app().event(app::KeyReleased{key});
    }
    /// The button whose label has `text` in it; of several, the one on top.
    void press(const std::string& text) {
      const app::Box* found = nullptr;
      const app::DrawList& list = app().draw();
      for (const app::Box& box : list.boxes)
        if (box.kind == app::Box::Kind::button && box.text.find(text) != std::string::npos)
          found = &box;
      if (found)
        click(found->area.center());
      else
        std::fprintf(stderr, "no button %s in %s\n", text.c_str(), app().describe().c_str());
    }
    /// Pulls the ball that waits; `back`: in its radii.
    bool pull(app::Point back) {
      const auto call = app().screen().aim_prompt();
      if (!call) {
        std::fprintf(stderr, "no ball to pull in %s\n", app().describe().c_str());
        return false;
      }
      held_ = call->at + back * call->radius;
      if (fingers) {
        app().event(app::Finger{0, app::Finger::Phase::down, call->at});
        app().event(app::Finger{0, app::Finger::Phase::moved, held_});
        return true;
      }
      app().event(app::PointerMoved{call->at});
      app().event(app::PointerPressed{call->at});
      app().event(app::PointerMoved{held_});
      return true;
    }
    void let_go() {
      if (fingers)
        app().event(app::Finger{0, app::Finger::Phase::up, held_});
      else
        app().event(app::PointerReleased{held_});
    }
    /// Angle in degrees, speed in px/s, as typed in.
    void shoot(const std::string& angle, const std::string& speed) {
      for (const std::string& number : {angle, speed}) {
        for (const char sign : number) app().event(app::TextTyped{{sign}});
        key(number == angle ? Key::tab : Key::enter);
      }
      key(Key::enter);
    }
    void wait_for(const std::string& text) {
      for (int i = 0; i < 6000 && app().describe().find(text) == std::string::npos; ++i) pass(10ms);
      if (app().describe().find(text) == std::string::npos)
        std::fprintf(stderr, "no %s in %s\n", text.c_str(), app().describe().c_str());
    }
    bool fingers;
    app::Point held_;
  };

  std::string say(app::Text text) const { return words_(text); }

  void take(Game& game, const std::string& name) { save(name, game.app().draw(), game.picture()); }

  void save(const std::string& name, const app::DrawList& list, const app::Image& picture) {
    char number[16];
    std::snprintf(number, sizeof number, "%02d-", ++taken_);
    const std::filesystem::path path = folder_ / (number + name + ".png");
    if (const carom::Status written = platform::write_png(path, picture); !written) {
      std::fprintf(stderr, "cannot write %s\n", path.c_str());
      std::exit(1);
    }
    char line[160];
    std::snprintf(line, sizeof line, "%dx%d %s %-28s %6zu vertices %5.2f layers\n", size_.width,
                  size_.height, app::code_of(words_.language()).data(), name.c_str(),
                  list.vertices.size(), layers(list, size_));
    figures_ << line;
  }

  void titles() {
    app::MemoryStore store;
    Game game(*this, store);
    take(game, "title");
    game.key(Key::tab);
    game.key(Key::tab);
    take(game, "title-focus");
    game.key(Key::help);
    take(game, "help");
    game.key(Key::right);
    take(game, "help-2");
    game.press(say(app::Text::change_keys));
    take(game, "keys");
    game.key(Key::escape);
    game.press(say(app::Text::licences));
    take(game, "licences");
    game.key(Key::escape);
    game.key(Key::escape);
    game.key(Key::paste);
    take(game, "title-nothing-to-paste");

    app::MemoryStore kept;
    (void)kept.save("continue-billiards.json",
                    read("tests/replays/billiards-left-in-the-middle.json"));
    (void)kept.save("continue-level.json", read("tests/replays/level-random-lost.json"));
    Game later(*this, kept);
    take(later, "title-later");
    later.press(say(app::Text::kept_games));
    take(later, "games-kept");
    later.press(say(app::Text::delete_game));
    take(later, "games-kept-delete");
    later.key(Key::escape);
    later.key(Key::escape);
    later.press(say(app::Text::continue_table));
    take(later, "loading");
    later.pass(2s);
    take(later, "billiards-continued");
  }

  void billiards() {
    app::MemoryStore store;
    Game game(*this, store);
    game.app().teach_beginners();
    game.press(say(app::Text::billiards));
    game.pass(600ms);
    take(game, "billiards-first-turn");
    game.pass(2400ms);
    take(game, "billiards-lesson");
    if (game.pull({-9, 1})) take(game, "aim-pull");
    game.key(Key::escape);
    game.let_go();
    game.app().rest(30s);
    game.pass(1500ms);
    take(game, "billiards-reminder");
    for (int i = 0; i < 30; ++i) game.key(Key::up);
    take(game, "aim-keys");
    game.app().event(app::TextTyped{"1"});
    game.app().event(app::TextTyped{"2"});
    take(game, "aim-numbers");
    game.key(Key::escape);
    game.key(Key::up);
    game.shoot("-2.5", "1500");
    game.pass(420ms);
    take(game, "billiards-rolling");
    game.key(Key::p);
    take(game, "billiards-pause");
    game.key(Key::p);
    game.pass(15s);
    take(game, "billiards-second-player");
    game.key(Key::escape);
    take(game, "pause-menu");
    game.key(Key::escape);
    // Into a corner hole.
    game.key(Key::up);
    game.shoot("135.5", "900");
    game.pass(15s);
    take(game, "billiards-after-two-shots");
  }

  /// A whole game as a replay, and what its end tells.
  void end_of_billiards() {
    app::MemoryStore store;
    Game game(*this, store);
    (void)game.clipboard().set_text(read("tests/replays/billiards-whole.json"));
    game.key(Key::paste);
    game.pass(1500ms);
    take(game, "replay-start");
    for (int i = 0; i < 12; ++i) game.key(Key::right);
    game.pass(700ms);
    take(game, "replay-middle");
    game.press(say(app::Text::save_replay));
    take(game, "replay-saved");
    for (int i = 0; i < 200; ++i) game.key(Key::right);
    game.pass(20s);
    take(game, "replay-end");

    const replay::Replay whole =
        replay::read_replay(read("tests/replays/billiards-whole.json")).value();
    auto player = replay::Player::create(whole).value();
    std::uint64_t steps = 0;
    for (const replay::Move& move : whole.moves) steps += move.steps;
    while (player.steps() + 1 < steps) (void)player.step();
    app::Session session(store, game.clipboard(), {});
    app::ScreenStack screens(session.sounds);
    const app::View view = app::View::of(size_.width, size_.height);
    screens.resize(view);
    screens.show(std::make_unique<app::BilliardsScreen>(
        words_, session,
        app::BilliardsRecorder(std::get<games::billiards::Game>(player.game()), whole)));
    for (int i = 0; i < 500; ++i) screens.iterate(20ms);
    app::Atlas atlas;
    app::Font font{atlas};
    app::DrawList list;
    app::Canvas canvas{list, font, view};
    screens.draw(canvas);
    app::Image picture(size_.width, size_.height, {0, 0, 0, 255});
    app::rasterize(list, atlas, picture);
    save("billiards-over", list, picture);
  }

  void ways_of_aiming() {
    for (const auto& [way, name] : {std::pair{app::AimWay::clicks, "aim-clicks"},
                                    {app::AimWay::turn, "aim-turn-then-power"},
                                    {app::AimWay::apart, "aim-turn-and-slide"}}) {
      app::MemoryStore store;
      Game game(*this, store);
      app::Settings settings = game.app().settings().get();
      settings.aiming.way = way;
      game.app().settings().set(settings);
      game.press(say(app::Text::billiards));
      game.pass(3s);
      const auto call = game.app().screen().aim_prompt();
      if (!call) continue;
      if (way == app::AimWay::clicks) game.click(call->at);
      const app::Point to = call->at + app::Point{6, -2} * call->radius;
      if (way == app::AimWay::apart)
        game.click(call->at + app::Point{12, -2} * call->radius);
      else if (!game.fingers)
        game.app().event(app::PointerMoved{to});
      else if (way == app::AimWay::turn)
        game.click(to);  // a second tap by clicks shoots
      take(game, name);
    }
  }

  /// Of a whole game.
  void review() {
    app::MemoryStore store;
    Game game(*this, store);
    app::Session session(store, game.clipboard(), {});
    app::ScreenStack screens(session.sounds);
    const app::View view = app::View::of(size_.width, size_.height);
    screens.resize(view);
    screens.show(std::make_unique<app::ReviewScreen>(
        words_, session,
        app::GameReview::begin(
            replay::read_replay(read("tests/replays/billiards-whole.json")).value(), 4)
            .value()));
    for (const int frames : {200, 20'000}) {
      for (int i = 0; i < frames && screens.animating(); ++i) screens.iterate(20ms);
      app::Atlas atlas;
      app::Font font{atlas};
      app::DrawList list;
      app::Canvas canvas{list, font, view};
      screens.draw(canvas);
      app::Image picture(size_.width, size_.height, {0, 0, 0, 255});
      app::rasterize(list, atlas, picture);
      save(frames == 200 ? "review-begun" : "review", list, picture);
    }
  }

  void hints() {
    app::MemoryStore store;
    Game game(*this, store);
    game.press(say(app::Text::billiards));
    game.pass(3s);
    for (const char* name : {"hint-ball", "hint-way", "hint-aim"}) {
      game.key(Key::h);
      game.pass(5s);
      take(game, name);
    }
  }

  void computer() {
    app::MemoryStore store;
    Game game(*this, store);
    app::Settings settings = game.app().settings().get();
    settings.seats = app::Seats::computer;
    settings.opponent = 5;
    settings.match = app::BestOf::three;
    settings.breaks = app::Breaks::player_2;
    game.app().settings().set(settings);
    game.press(say(app::Text::billiards));
    game.pass(300ms);
    take(game, "computer-thinks");
    game.pass(800ms);
    take(game, "computer-aims");
    game.pass(2s);
    game.key(Key::escape);
    take(game, "computer-pause-menu");
    for (int i = 0; i < 2; ++i) game.press(say(app::Text::resign));
    take(game, "computer-wins");
    game.key(Key::escape);
    review();
  }

  void new_game() {
    app::MemoryStore store;
    Game game(*this, store);
    game.press(say(app::Text::new_game_more));
    take(game, "new-game");
    game.press(say(app::Text::who_plays));
    take(game, "new-game-computer");
    game.press(say(app::Text::set_opponent));
    take(game, "opponents");
    game.key(Key::escape);
    game.press(say(app::Text::who_plays));
    game.press(say(app::Text::set_rack));
    take(game, "new-game-alone");
    game.press(say(app::Text::start_game));
    game.pass(3s);
    take(game, "alone");
    game.shoot("0", "700");
    game.pass(6s);
    take(game, "alone-rolling");
  }

  void practice() {
    app::MemoryStore store;
    Game game(*this, store);
    game.press(say(app::Text::practice));
    game.pass(3s);
    take(game, "practice");
    game.key(Key::up);
    game.shoot("-3", "1400");
    game.pass(20s);
    take(game, "practice-after");
  }

  void levels() {
    {
      app::MemoryStore store;
      Game game(*this, store);
      game.press("Angry Balls");
      take(game, "levels");
      for (int i = 0; i < 3; ++i) game.key(Key::right);
      take(game, "levels-focus");
    }
    for (int number = 1; number <= 10; ++number) level(number);
  }

  void choose(Game& game, int number) {
    game.press("Angry Balls");
    for (int page = 0; page < 10; ++page) {
      const app::DrawList& list = game.app().draw();
      for (const app::Box& box : list.boxes) {
        if (box.kind != app::Box::Kind::button ||
            ("\n" + box.text).find("\n" + std::to_string(number) + "\n") == std::string::npos)
          continue;
        const app::Point at = box.area.center();
        return game.click(at);
      }
      game.press("›");
    }
    std::fprintf(stderr, "no level %d in %s\n", number, game.app().describe().c_str());
  }

  void level(int number) {
    const std::string name = "level-" + std::to_string(number);
    app::MemoryStore store;
    Game game(*this, store);
    if (number == 1) game.app().teach_beginners();
    choose(game, number);
    game.pass(600ms);
    if (number == 1) take(game, name + "-begins");
    game.pass(2400ms);
    if (number == 1) take(game, name + "-lesson");
    if (game.pull({-7, 4})) take(game, name + "-aim");
    game.key(Key::escape);
    game.let_go();
    game.key(Key::up);
    game.shoot(number == 1 ? "-5" : "35", number == 1 ? "650" : "900");
    game.pass(number == 1 ? 300ms : 900ms);
    take(game, name + "-flight");
    game.pass(12s);
    take(game, name + "-after");
    if (number != 5) return;
    game.key(Key::escape);
    take(game, name + "-leave");
    game.key(Key::escape);
    for (int i = 0; i < 2; ++i) {
      game.key(Key::n);
      game.pass(1s);
      game.key(Key::up);
      game.shoot("170", "900");
      game.pass(12s);
    }
    take(game, name + "-third-over");
    game.key(Key::n);
    take(game, name + "-lost");
  }

  void replays() {
    app::MemoryStore store;
    for (int i = 0; i < 6; ++i)
      (void)store.save(
          "replays/replay-" + std::to_string(i) + ".json",
          read(i % 2 ? "tests/replays/level-06-won.json" : "tests/replays/billiards-whole.json"));
    (void)store.save("replays/broken.json", "{");
    Game game(*this, store);
    game.press(say(app::Text::replays));
    take(game, "replays");
    game.key(Key::escape);
    (void)game.clipboard().set_text(read("tests/replays/level-09-won.json"));
    game.key(Key::paste);
    game.pass(3s);
    take(game, "replay-level");
    game.key(Key::escape);
    (void)game.clipboard().set_text(read("tests/replays/diverging/another-hash.json"));
    game.key(Key::paste);
    game.pass(20s);
    take(game, "replay-diverges");
    app::MemoryStore nothing;
    Game empty(*this, nothing);
    empty.press(say(app::Text::replays));
    take(empty, "replays-none");
  }

  void settings() {
    app::MemoryStore store;
    Game game(*this, store);
    for (int page = 0; page < 4; ++page) {
      game.key(Key::settings);
      game.key(Key::tab);
      for (int i = 0; i < page; ++i) game.key(Key::right);
      take(game, "settings-" + std::to_string(page + 1));
      game.key(Key::tab);
      game.key(Key::tab);
      take(game, "settings-" + std::to_string(page + 1) + "-focus");
      game.key(Key::escape);
    }
  }

  /// The colours, a table and a level in each.
  void palettes() {
    for (const app::Colours colours :
         {app::Colours::red_green, app::Colours::blue_yellow, app::Colours::high_contrast}) {
      const std::string name = "palette-" + std::to_string(static_cast<int>(colours));
      app::MemoryStore store;
      Game game(*this, store);
      app::Settings settings = game.app().settings().get();
      settings.colours = colours;
      game.app().settings().set(settings);
      take(game, name + "-title");
      game.press(say(app::Text::billiards));
      game.pass(3s);
      if (game.pull({-9, 1})) take(game, name + "-table");
      Game other(*this, store);
      choose(other, 9);
      other.pass(3s);
      if (other.pull({-7, 4})) take(other, name + "-level");
    }
  }

  void troubles() {
    app::MemoryStore store;
    (void)store.save("settings.json", "{");
    (void)store.save("continue-billiards.json", "{");
    Game game(*this, store);
    take(game, "settings-broken");
    game.key(Key::enter);
    take(game, "kept-broken");
    game.key(Key::enter);
    game.app().open_file("picture.txt", "hello");
    take(game, "wrong-file");
  }

  std::filesystem::path folder_;
  Size size_;
  app::Words words_;
  std::ofstream& figures_;
  int taken_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: pictures FOLDER [WxH...]\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::ofstream figures(folder / "figures.txt");
  for (const Size size : sizes) {
    const std::string name = std::to_string(size.width) + "x" + std::to_string(size.height);
    bool wanted = argc == 2;
    for (int i = 2; i < argc; ++i) wanted = wanted || name == argv[i];
    if (!wanted) continue;
    for (const app::Language language : app::all_languages())
      Visitor(folder, size, language, figures).visit();
  }
  return 0;
}
