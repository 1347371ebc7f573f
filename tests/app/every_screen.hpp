#pragma once

#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/staged.hpp"
#include "app/widgets/tip.hpp"
#include "project_file.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"

/// Walks through every screen and every window over one, by the mouse or by a finger.
namespace every_screen {

using app::Box;
using app::Key;
using app::Text;

/// The screen that is shown, and its input.
struct Shown {
  std::string where;
  std::function<const app::DrawList&()> draw;
  std::function<void(const app::Input&)> event;

  /// Those that nothing covers.
  std::vector<Box> buttons() const {
    const app::DrawList& list = draw();
    std::vector<Box> found;
    for (std::size_t i = list.covered; i < list.boxes.size(); ++i)
      if (list.boxes[i].kind == Box::Kind::button) found.push_back(list.boxes[i]);
    return found;
  }
};

struct How {
  app::Language language = app::Language::en;
  int width = 1280;  ///< points of the screen
  int height = 720;
  int density = 1;
  bool touch = false;
};

class Walk {
 public:
  Walk(How how, std::function<void(const Shown&)> check) : how_(how), check_(std::move(check)) {}

  void all() {
    title();
    billiards();
    end_of_billiards();
    levels();
    replays_and_settings();
  }

 private:
  using seconds = std::chrono::seconds;
  using milliseconds = std::chrono::milliseconds;

  std::string in(Text text) const { return app::Words(how_.language)(text); }
  app::Resized size() const {
    return {how_.width * how_.density, how_.height * how_.density,
            static_cast<float>(how_.density)};
  }
  void begin(app::App& app) const {
    app.event(size());
    if (!how_.touch) return;
    for (const auto phase : {app::Finger::Phase::down, app::Finger::Phase::up})
      app.event(app::Finger{0, phase, {1, 1}});
  }
  void begin(Player& game) const {
    game.touches = how_.touch;
    begin(game.app());
  }
  void check(Player& game, const std::string& where = {}) {
    check_({where.empty() ? game.title() : where,
            [&]() -> const app::DrawList& { return game.app().draw(); },
            [&](const app::Input& input) { game.app().event(input); }});
  }
  /// Presses a button, on whatever page it is.
  void find(Player& game, const std::string& label) const {
    for (int page = 0; page < 9; ++page) {
      for (const Box& box : game.boxes())
        if (box.kind == Box::Kind::button && box.text.find(label) != std::string::npos)
          return game.press(label);
      game.press("›");
    }
    FAIL() << label;
  }

  void title() {
    Player game(how_.language, how_.width, how_.height);
    begin(game);
    check(game);
    game.key(Key::paste);
    check(game);
    game.key(Key::escape);
    game.press(in(Text::new_game_more));
    check(game);
    game.press(in(Text::who_plays));
    check(game);
    game.press(in(Text::set_opponent));
    check(game);
    for (const Key by : {Key::escape, Key::escape}) game.key(by);
    game.press(in(Text::billiards));
    check(game);
    game.key(Key::escape);
    check(game);
    for (int i = 0; i < 2; ++i) game.press(in(Text::resign));
    check(game);
    game.press(in(Text::review));
    check(game);
    for (const Key by : {Key::escape, Key::escape}) game.key(by);
    game.key(Key::help);
    check(game);
    game.press(in(Text::change_keys));
    check(game);

    app::MemoryStore store;
    ASSERT_TRUE(
        store.save("continue-billiards.json", replay_file("billiards-left-in-the-middle.json")));
    ASSERT_TRUE(store.save("continue-level.json", replay_file("level-random-lost.json")));
    ASSERT_TRUE(store.save("settings.json", "{"));
    Player kept(how_.language, how_.width, how_.height, {}, store);
    begin(kept);
    check(kept);
    kept.key(Key::escape);
    check(kept, "games kept");
    kept.press(in(Text::kept_games));
    check(kept);
    kept.press(in(Text::delete_game));
    check(kept);
    kept.key(Key::escape);
    kept.key(Key::escape);
    kept.press(in(Text::continue_table));
    check(kept, "loading");

    app::MemoryClipboard clipboard;
    app::HostEnvironment page;
    page.can_quit = false;
    app::App web(how_.language, how_.width, how_.height, store, clipboard, {}, page);
    begin(web);
    check_({"the page", [&]() -> const app::DrawList& { return web.draw(); },
            [&](const app::Input& input) { web.event(input); }});
  }

  void billiards() {
    Player game(how_.language, how_.width, how_.height);
    begin(game);
    for (const bool practice : {false, true}) {
      game.press(practice ? in(Text::practice) : in(Text::billiards));
      check(game);
      for (int i = 0; i < 2; ++i) game.key(Key::enter);
      game.pass(milliseconds{100});
      if (!practice) {
        game.key(Key::r);
        check(game);
        game.key(Key::escape);
      }
      game.key(Key::escape);
      check(game);
      for (const Key by : {Key::back_tab, Key::back_tab, Key::enter}) game.key(by);
      check(game);
    }
  }

  void end_of_billiards() {
    const replay::Replay whole = replay::read_replay(replay_file("billiards-whole.json")).value();
    auto player = replay::Player::create(whole).value();
    player.look_ahead(1'000'000);
    player.seek(player.turns().size());
    app::MemoryStore store;
    app::MemoryClipboard clipboard;
    app::Session session(store, clipboard, {});
    Staged<app::BilliardsScreen> screen(
        app::Words(how_.language), session,
        app::BilliardsRecorder(std::get<games::billiards::Game>(player.game()), whole));
    app::View view = app::View::of(size().width, size().height, size().density);
    view.touch = how_.touch;
    screen.resize(view);
    ASSERT_EQ(screen.game().phase(), games::billiards::Phase::over);
    app::Atlas atlas;
    app::Font font{atlas};
    app::DrawList list;
    check_({"the end of a game",
            [&]() -> const app::DrawList& {
              list.clear();
              app::Canvas canvas{list, font, view};
              screen.draw(canvas);
              app::draw_tip(canvas);
              return list;
            },
            [&](const app::Input& input) { screen.event(input); }});
  }

  void throw_left(Player& game) {
    const app::Point from = game.app().screen().aim_prompt()->at;
    game.click(from);
    game.click({1, from.y});
    game.pass(seconds{4});
  }

  void levels() {
    const std::string easy = R"({"carom": 1, "width": 1000, "height": 500,
      "balls": [{"x": 110, "y": 120, "role": "projectile", "radius": 12},
                {"x": 200, "y": 120, "role": "enemy", "solidity": 10}]})";
    Player game(how_.language, how_.width, how_.height,
                {app::read_level("easy.json", easy), app::read_level("bad.json", std::string())});
    begin(game);
    game.press("Angry Balls");
    check(game);
    for (const bool practice : {false, true}) {
      if (practice) game.press(in(Text::practice_off));
      find(game, app::Words(how_.language).level_name("First steps"));
      check(game);
      for (int left = 2; left >= 0; --left) {
        throw_left(game);
        check(game);
        game.key(Key::n);
        if (!game.says(in(Text::ask_go_on))) continue;
        check(game);
        game.key(Key::escape);
      }
      ASSERT_TRUE(game.says(in(Text::lost))) << game.title();
      check(game);
      game.key(Key::escape);
      if (practice) break;
      find(game, "easy");
      throw_left(game);  // and back from the wall
      ASSERT_TRUE(game.says(in(Text::won))) << game.title();
      check(game);
      game.key(Key::escape);
    }
  }

  void replays_and_settings() {
    Player game(how_.language, how_.width, how_.height);
    begin(game);
    const std::string level = replay_file("level-06-won.json");
    ASSERT_TRUE(game.store().save("replays/broken.json", "{"));
    for (int i = 0; i < 30; ++i)
      ASSERT_TRUE(game.store().save("replays/replay-" + std::to_string(i) + ".json", level));
    ASSERT_TRUE(game.store().save("replays/strange.json", R"({"angry-balls-replay": 2})"));
    game.press(in(Text::replays));
    check(game);
    game.press("›");
    check(game);
    find(game, "replay-");
    game.pass(seconds{2});
    check(game);
    game.key(Key::escape);
    game.key(Key::escape);
    for (int page = 0; page < 4; ++page) {
      game.key(Key::settings);
      game.key(Key::tab);
      for (int i = 0; i < page; ++i) game.key(Key::right);
      game.click({1, 1});
      check(game);
      game.key(Key::escape);
    }
  }

  How how_;
  std::function<void(const Shown&)> check_;
};

}  // namespace every_screen
