// Nothing overlaps and nothing is cut off, whatever the window's size and the language.

#include <gtest/gtest.h>

#include "app/hud/practice_strip.hpp"
#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/staged.hpp"
#include "app/view/level_view.hpp"
#include "app/view/table_view.hpp"
#include "project_file.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using app::Box;
using app::Text;

struct Size {
  int width, height;
  float least_text = 14;  ///< px; on a phone some labels shrink to their room
};
constexpr Size usual_sizes[] = {
    {1280, 720}, {800, 600}, {1920, 1080}, {390, 844, 12}, {844, 390, 12}};
#ifdef NDEBUG
constexpr Size other_sizes[] = {{500, 900},  {1600, 500}, {480, 360}, {700, 1300},  {3840, 2160},
                                {1024, 768}, {760, 601},  {667, 480}, {2560, 1080}, {640, 360, 12}};
#else  // slow
constexpr Size other_sizes[] = {{480, 360}};
#endif

const std::array<std::string, 2> long_names{"Maximilienne-Wilhelmine W",
                                            "WWWWWWWWWWWWWWWWWWWWWWWW"};

const std::string easy = R"({"carom": 1, "name": "A very long name, as players give them, )" +
                         std::string(150, '!') + R"(", "width": 1000, "height": 500,
  "balls": [{"x": 110, "y": 120, "role": "projectile", "radius": 12},
            {"x": 200, "y": 120, "role": "enemy", "solidity": 10}]})";

std::string describe(const Box& box) {
  return "\"" + box.text + "\" at " + std::to_string(box.area.x) + "," +
         std::to_string(box.area.y) + " " + std::to_string(box.area.w) + "x" +
         std::to_string(box.area.h);
}

bool within(const app::Rect& inner, const app::Rect& outer) {
  const float slack = 0.51f;  // px, of rounding
  return inner.x >= outer.x - slack && inner.y >= outer.y - slack &&
         inner.right() <= outer.right() + slack && inner.bottom() <= outer.bottom() + slack;
}

/// A modal question covers what lies under it: boxes before its title do not count.
std::vector<Box> visible(const std::vector<Box>& boxes, const std::string& modal_title) {
  // The last: a button under it may have the same name.
  const auto title = std::ranges::find(boxes.rbegin(), boxes.rend(), modal_title, &Box::text);
  return title == boxes.rend() ? boxes : std::vector<Box>(title.base() - 1, boxes.end());
}

/// The rest of a text that was too long.
std::string without_ellipsis(const std::string& text) {
  const std::string sign = "…";
  return text.ends_with(sign) ? text.substr(0, text.size() - sign.size()) : text;
}

void expect_sound(const std::vector<Box>& boxes, Size size) {
  const app::Rect window{0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& a = boxes[i];
    EXPECT_TRUE(within(a.area, window)) << describe(a) << " is cut off";
    if (a.kind != Box::Kind::button) {
      EXPECT_GE(a.text_size, size.least_text) << describe(a) << " is too small";
    }
    if (a.kind == Box::Kind::tip) continue;  // it stands over others for a moment
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Box& b = boxes[j];
      if (b.kind == Box::Kind::tip) continue;
      if (a.kind == Box::Kind::text && b.kind == Box::Kind::button &&
          b.text.find(without_ellipsis(a.text)) != std::string::npos && a.area.overlaps(b.area))
        EXPECT_TRUE(within(a.area, b.area)) << describe(a) << " leaves its button";
      else
        EXPECT_FALSE(a.area.overlaps(b.area)) << describe(a) << " overlaps " << describe(b);
    }
  }
}

class Layout : public testing::TestWithParam<std::tuple<Size, app::Language>> {
 protected:
  std::string in(Text text, std::initializer_list<std::string_view> values = {}) const {
    return words(text, values);
  }

  Size size = std::get<0>(GetParam());
  app::Words words{std::get<1>(GetParam())};
  std::string lost = in(Text::lost);
  /// Beside the shipped ones: 11 has a very long name and is won by any throw to the right; 12 is
  /// broken.
  Player game{std::get<1>(GetParam()),
              size.width,
              size.height,
              {app::read_level("easy.json", easy),
               app::read_level("bad.json", std::string("{\"carom\": 1, \"wide\": 3}"))}};

  app::Point cue() const {
    const app::View view = app::View::of(size.width, size.height);
    return app::table_viewport(app::GameLayout::of(view).world.inset(view.px(8)),
                               games::billiards::rack())
        .to_window({200, 200});
  }
  void check(const std::string& modal_title = {}) {
    // Beside the window that is expected, the offer after needless clicks may have come.
    expect_sound(visible(visible(game.app().draw().boxes, modal_title), in(Text::ask_go_on)), size);
  }
  void key(app::Key key) { game.key(key); }
  app::Point projectile() const {
    const app::View view = app::View::of(size.width, size.height);
    carom::Scene level;
    level.width = 1000;
    level.height = 500;
    return app::level_viewport(app::GameLayout::of(view).world, level).to_window({110, 120});
  }
  /// Clicks a level's card, on whatever page it is.
  void choose_level(int number) {
    for (int page = 0; page < 20; ++page) {
      for (const Box& box : game.boxes())
        if (box.kind == Box::Kind::button &&
            ("\n" + box.text).find("\n" + std::to_string(number) + "\n") != std::string::npos)
          return game.click(box.area.center());
      game.press("›");
      check();
    }
    FAIL() << "no level " << number;
  }
};

TEST_P(Layout, Title) { check(); }

TEST_P(Layout, HelpOnAllItsPagesAndTheKeys) {
  for (const bool touch : {false, true}) {
    if (touch)
      for (const auto phase : {app::Finger::Phase::down, app::Finger::Phase::up})
        game.app().event(app::Finger{0, phase, {1, 1}});
    key(app::Key::help);
    for (int i = 0; i < 8; ++i) {
      check(in(Text::help));
      key(app::Key::right);
    }
    game.press(in(Text::change_keys));
    check(in(Text::keys_title));
    game.press(in(Text::key_again));
    check(in(Text::keys_title));
    key(app::Key::n);
    check(in(Text::keys_title));
    key(app::Key::escape);
    key(app::Key::escape);
    game.press(in(Text::licences));
    for (int i = 0; i < 3; ++i) {
      check(in(Text::licences));
      key(app::Key::right);
    }
    key(app::Key::escape);
    key(app::Key::escape);
    key(app::Key::escape);
  }
}

/// With buttons for fingers, what they tell, the first lesson, and the words for a player who does
/// nothing.
TEST_P(Layout, ForFingersAndBeginners) {
  game.app().teach_beginners();
  const auto touch = [&] {
    for (const auto phase : {app::Finger::Phase::down, app::Finger::Phase::up})
      game.app().event(app::Finger{0, phase, {1, 1}});
  };
  touch();
  check();
  for (int i = 0; i < 8; ++i) {
    key(app::Key::tab);
    check();
  }
  game.press(in(Text::practice));
  game.pass(3s);
  check();
  touch();
  game.app().rest(30s);
  check();
  for (int i = 0; i < 9; ++i) {
    key(app::Key::tab);
    check();
  }
}

TEST_P(Layout, WordsForEveryHandAndWayOfAiming) {
  for (const auto way :
       {app::AimWay::clicks, app::AimWay::pull, app::AimWay::turn, app::AimWay::apart}) {
    app::Settings settings = game.app().settings().get();
    settings.aiming.way = way;
    game.app().settings().set(settings);
    for (const bool table : {true, false}) {
      if (table) {
        key(app::Key::enter);
      } else {
        game.press("Angry Balls");
        choose_level(1);
      }
      game.pass(3s);
      for (const bool finger : {true, false}) {
        const app::Point away{static_cast<float>(size.width) - 1,
                              static_cast<float>(size.height) - 1};
        if (finger) {
          for (const auto phase : {app::Finger::Phase::down, app::Finger::Phase::up})
            game.app().event(app::Finger{0, phase, away});
        } else {
          game.app().event(app::PadPressed{app::PadButton::start});
          check();
          game.app().event(app::PadPressed{app::PadButton::start});
        }
        check();
        game.app().rest(30s);
        check();
      }
      game.app().event(app::PadPressed{app::PadButton::left});
      check();
      key(app::Key::escape);
      game.leave();
      if (!table) key(app::Key::escape);
    }
  }
}

TEST_P(Layout, FirstTurnAnnounced) {
  key(app::Key::enter);
  game.pass(500ms);
  check();
}

TEST_P(Layout, AimWeakStrongAndCapped) {
  key(app::Key::enter);
  game.pass(3s);
  game.click({cue().x, cue().y + 60});  // beside the ball
  check();
  game.click(cue());
  check();
  game.app().event(app::PointerMoved{{cue().x + 60, cue().y}});
  check();
  game.app().event(app::PointerMoved{{cue().x + 4000, cue().y}});
  check();
}

TEST_P(Layout, AimByPullKeysAndNumbers) {
  for (const bool table : {true, false}) {
    if (table) {
      key(app::Key::enter);
    } else {
      game.press("Angry Balls");
      choose_level(1);
    }
    game.pass(3s);
    check();
    const app::Point from = table ? cue() : projectile();
    game.app().event(app::PointerPressed{from});
    for (const float x : {20.0f, 4000.0f}) {
      game.app().event(app::PointerMoved{{from.x - x, from.y + 7}});
      check();
    }
    key(app::Key::escape);
    game.app().event(app::PointerReleased{from});
    key(app::Key::up);
    check();
    for (const char sign : std::string("-123.456")) game.app().event(app::TextTyped{{sign}});
    check();
    key(app::Key::tab);
    for (const char sign : std::string("1234.567")) game.app().event(app::TextTyped{{sign}});
    check();
    const app::Rect world = app::GameLayout::of(app::View::of(size.width, size.height)).world;
    for (const Box& box : game.boxes())
      EXPECT_FALSE(box.text.find("567") != std::string::npos && box.area.overlaps(world))
          << describe(box) << " covers the game";
    key(app::Key::enter);
    check();
    key(app::Key::escape);
    key(app::Key::escape);
    check(in(Text::paused));
    key(app::Key::escape);
    game.leave();
  }
}

/// The way of aiming that only a setting brings.
TEST_P(Layout, TurnThenPower) {
  app::Session session{game.store(), game.clipboard(), app::shipped_levels()};
  app::Settings turn_then_power;
  turn_then_power.aiming.way = app::AimWay::turn;
  session.settings.set(turn_then_power);
  app::BilliardsScreen screen{app::Words(std::get<1>(GetParam())), session};
  const app::View view = app::View::of(size.width, size.height);
  screen.resize(view);
  for (int i = 0; i < 300; ++i) screen.iterate(10ms);
  app::Atlas atlas;
  app::Font font{atlas};
  for (const bool turning : {false, true}) {
    if (turning) screen.event(app::PointerMoved{{cue().x + 60, cue().y}});
    app::DrawList list;
    app::Canvas canvas{list, font, view};
    screen.draw(canvas);
    expect_sound(list.boxes, size);
  }
}

/// The choice of a game, with the most rows that there are, and a game against a computer.
TEST_P(Layout, NewGameAndTheComputer) {
  for (const bool touch : {false, true}) {
    if (touch)
      for (const auto phase : {app::Finger::Phase::down, app::Finger::Phase::up})
        game.app().event(app::Finger{0, phase, {1, 1}});
    game.press(in(Text::new_game_more));
    for (int seats = 0; seats < 3; ++seats) {
      check(in(Text::new_game));
      game.press(in(Text::who_plays));
    }
    for (int i = 0; i < 8; ++i) {
      key(app::Key::tab);
      check(in(Text::new_game));
    }
    key(app::Key::escape);
    app::Settings settings = game.app().settings().get();
    settings.seats = app::Seats::computer;
    settings.opponent = 10;
    settings.match = app::BestOf::three;
    settings.names = {long_names[1], ""};
    game.app().settings().set(settings);
    game.press(in(Text::new_game_more));
    check(in(Text::new_game));
    game.press(in(Text::set_opponent));
    check();
    for (int i = 0; i < 2; ++i) key(app::Key::escape);
    settings.breaks = app::Breaks::player_2;
    game.app().settings().set(settings);
    game.press(in(Text::billiards));
    game.pass(200ms);
    check();
    game.pass(700ms);
    check();
    key(app::Key::escape);
    check(in(Text::paused));
    game.press(in(Text::resign));
    check(in(Text::ask_resign));
    game.press(in(Text::resign));
    check(in(Text::wins, {in(Text::computer, {"10"})}));
    game.press(in(Text::review));
    check();
    for (int i = 0; i < 400 && game.app().animating(); ++i) game.pass(16ms);
    check();
    key(app::Key::escape);
    key(app::Key::escape);
    settings.seats = app::Seats::two;
    game.app().settings().set(settings);
  }
}

TEST_P(Layout, Hints) {
  for (const bool table : {true, false}) {
    if (table) {
      game.press(in(Text::billiards));
    } else {
      game.press("Angry Balls");
      choose_level(1);
    }
    check();
    for (int step = 0; step < 3; ++step) {
      key(app::Key::h);
      check();
      for (int i = 0; i < 1500 && game.shows(in(Text::hint_searching)); ++i) game.pass(32ms);
      check();
    }
    key(app::Key::escape);
    game.leave();
  }
}

TEST_P(Layout, WatchAndQuestion) {
  key(app::Key::enter);
  game.pass(3s);
  game.click(cue());
  game.click({cue().x + 100, cue().y});
  game.pass(50ms);
  check();
  key(app::Key::r);
  check(in(Text::ask_restart));
}

TEST_P(Layout, Settings) {
  game.press(in(Text::settings));
  check();
  for (int page = 0; page < 4; ++page) {
    key(app::Key::tab);
    for (int i = 0; i < page; ++i) key(app::Key::right);
    check();
    for (int i = page; i < 4; ++i) key(app::Key::tab);
    const std::string separator = in(Text::key_line, {"", ""});
    while (game.says(separator)) {
      // Through all languages and round to the one it was.
      for (std::size_t value = 0; value <= app::language_codes.size(); ++value) {
        key(app::Key::right);
        check();
      }
      game.app().event(app::TextTyped{long_names[1]});
      check();
      for (const Box& box : game.boxes())
        EXPECT_TRUE(box.text.find("…") == std::string::npos || box.text.starts_with("WWW"))
            << describe(box) << " is cut short";
      key(app::Key::down);
    }
  }
  key(app::Key::escape);
  key(app::Key::enter);
  game.pass(500ms);
  check();
  game.pass(3s);
  game.click(cue());
  game.click({cue().x + 100, cue().y});
  game.pass(50ms);
  check();
}

TEST_P(Layout, SettingsThatCannotBeReadOrSaved) {
  struct Fixed : app::MemoryStore {
    carom::Status set_aside(const std::string&) override {
      return carom::Error{.problem = "cannot be moved"};
    }
  } fixed;
  app::MemoryStore store;
  const std::string title = in(Text::settings_broken);
  for (app::Store* const any :
       {static_cast<app::Store*>(&store), static_cast<app::Store*>(&fixed)}) {
    ASSERT_TRUE(any->save("settings.json", "{"));
    Player broken(std::get<1>(GetParam()), size.width, size.height, {}, *any);
    ASSERT_TRUE(broken.says(title));
    expect_sound(visible(broken.boxes(), in(Text::settings_broken)), size);
    broken.key(app::Key::enter);
    broken.key(app::Key::settings);
    expect_sound(broken.boxes(), size);
  }
}

/// The last step of a whole game, and the statistics.
TEST_P(Layout, EndOfBilliards) {
  const replay::Replay whole = replay::read_replay(replay_file("billiards-whole.json")).value();
  auto player = replay::Player::create(whole).value();
  std::uint64_t steps = 0;
  for (const replay::Move& move : whole.moves) steps += move.steps;
  while (player.steps() + 1 < steps) ASSERT_TRUE(player.step());
  app::MemoryStore store;
  app::Session session(store, game.clipboard(), {});
  const app::View view = app::View::of(size.width, size.height);
  for (const bool named : {false, true}) {
    Staged<app::BilliardsScreen> screen(
        words, session,
        app::BilliardsRecorder(std::get<games::billiards::Game>(player.game()), whole));
    if (named) words.name_players(long_names);
    screen.resize(view);
    for (int i = 0; i < 500; ++i) screen.iterate(20ms);
    ASSERT_EQ(screen.game().phase(), games::billiards::Phase::over);
    app::Atlas atlas;
    app::Font font{atlas};
    app::DrawList list;
    app::Canvas canvas{list, font, view};
    screen.draw(canvas);
    std::size_t modal = list.boxes.size();
    for (std::size_t i = 0; i < list.boxes.size(); ++i)
      for (const int winner : {0, 1})
        if (list.boxes[i].text == words(Text::wins, {words.player(winner)})) modal = i;
    ASSERT_LT(modal, list.boxes.size());
    const std::vector<Box> boxes(list.boxes.begin() + static_cast<std::ptrdiff_t>(modal),
                                 list.boxes.end());
    expect_sound(boxes, size);
    for (const Text row :
         {Text::points_made, Text::balls, Text::best_turn, Text::shots, Text::fouls})
      EXPECT_TRUE(std::ranges::any_of(boxes, [&](const Box& box) { return box.text == in(row); }))
          << in(row);
  }
}

TEST_P(Layout, LevelMenu) {
  game.press("Angry Balls");
  check();
  choose_level(12);
  check();
}

TEST_P(Layout, LevelFromTheFirstClickToTheEnd) {
  game.press("Angry Balls");
  choose_level(1);
  game.pass(500ms);
  check();
  game.pass(3s);
  const app::Point from = projectile();
  game.click({from.x + 60, from.y - 60});  // beside it
  check();
  game.click(from);
  check();
  game.app().event(app::PointerMoved{{from.x + 4000, from.y}});
  check();
  game.click({from.x - 400, from.y});  // out on the left
  game.pass(100ms);
  check();
  game.pass(3s);
  check();
  for (int i = 0; i < 2; ++i) {
    key(app::Key::n);
    check();
    game.click(from);
    game.click({from.x - 400, from.y});
    game.pass(3s);
    check();
  }
  key(app::Key::n);
  check(lost);
  EXPECT_TRUE(game.says(lost)) << game.title();
}

TEST_P(Layout, LevelWon) {
  game.press("Angry Balls");
  choose_level(11);
  game.pass(3s);
  const app::Point from = projectile();
  game.click(from);
  game.click({from.x + 4000, from.y});
  game.pass(100ms);
  check();
  game.pass(4s);
  check(in(Text::won));
}

/// Throws out on the left until the level is lost.
TEST_P(Layout, PracticeFromTheFirstThrowToTheEnd) {
  game.press("Angry Balls");
  game.press(in(Text::practice_off));
  check();
  choose_level(1);
  game.pass(3s);
  check();
  const app::View view = app::View::of(size.width, size.height);
  app::Rect world = app::GameLayout::of(view).world;
  world.cut_bottom(app::PracticeStrip::height(view));
  carom::Scene level;
  level.width = 1000;
  level.height = 500;
  const app::Point from = app::level_viewport(world, level).to_window({110, 120});
  for (int i = 0; i < 3; ++i) {
    game.click(from);
    check();
    game.click({from.x - 400, from.y});
    game.pass(50ms);
    check();
    key(app::Key::left);
    key(app::Key::down);
    check();
    game.pass(4s);
    check();
    key(app::Key::n);
  }
  check(lost);
  EXPECT_TRUE(game.says(lost)) << game.title();
  game.press(in(Text::take_back));
  check();
}

TEST_P(Layout, PracticeTable) {
  game.press(in(Text::practice));
  check();
  game.pass(3s);
  check();
  key(app::Key::escape);
  check(in(Text::paused));
}

TEST_P(Layout, ReplayOfBilliardsFromTheFirstTurnToTheLast) {
  ASSERT_TRUE(game.clipboard().set_text(replay_file("billiards-whole.json")));
  key(app::Key::paste);
  check();
  for (int i = 0; i < 40; ++i) game.pass(20ms);
  check();
  for (int i = 0; i < 101; i += 10) {
    for (int j = 0; j < 10; ++j) key(app::Key::right);
    check();
  }
  key(app::Key::copy);
  check();
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 9; ++j) key(i == 0 ? app::Key::plus : app::Key::minus);
    check();
  }
  game.press(in(Text::save_replay));
  check();
  key(app::Key::escape);
  game.press(in(Text::replays));
  check();
}

TEST_P(Layout, ReplayOfALevelAndOneThatDiverges) {
  for (const char* file : {"level-09-won.json", "diverging/another-hash.json"}) {
    ASSERT_TRUE(game.clipboard().set_text(replay_file(file)));
    key(app::Key::paste);
    game.pass(2s);
    check();
    key(app::Key::escape);
  }
}

TEST_P(Layout, NothingToPaste) {
  key(app::Key::paste);
  check(in(Text::paste_failed));
  key(app::Key::enter);
  game.press(in(Text::replays));
  check();
  key(app::Key::paste);
  check();
}

TEST_P(Layout, ListOfReplays) {
  const std::string level = replay_file("level-06-won.json");
  for (int i = 0; i < 30; ++i)
    ASSERT_TRUE(game.store().save("replays/replay-" + std::to_string(i) + ".json", level));
  ASSERT_TRUE(game.store().save("replays/s" + std::string(200, 'y') + ".json", level));
  ASSERT_TRUE(game.store().save("replays/t.json", replay_file("billiards-whole.json")));
  ASSERT_TRUE(game.store().save("replays/u.json", "{"));
  ASSERT_TRUE(game.store().save("replays/v.json", R"({"angry-balls-replay": 2})"));
  game.press(in(Text::replays));
  check();
  for (int page = 0; page < 20 && !game.shows("u\n"); ++page) {
    game.press("›");
    check();
  }
  game.press("u\n");
  check();
  game.press("›");
  check();
}

TEST_P(Layout, GamesKeptAreOffered) {
  app::MemoryStore store;
  ASSERT_TRUE(
      store.save("continue-billiards.json", replay_file("billiards-left-in-the-middle.json")));
  Player first(std::get<1>(GetParam()), size.width, size.height, {}, store);
  expect_sound(first.boxes(), size);
  ASSERT_TRUE(store.save("continue-level.json", replay_file("level-random-lost.json")));
  Player again(std::get<1>(GetParam()), size.width, size.height, {}, store);
  expect_sound(again.boxes(), size);
  again.press(in(Text::kept_games));
  expect_sound(again.boxes(), size);
  again.press(in(Text::delete_game));
  const std::string question = in(Text::ask_delete_game);
  EXPECT_TRUE(again.says(question));
  expect_sound(visible(again.boxes(), question), size);
  again.key(app::Key::escape);
  again.press("Random");
  expect_sound(again.boxes(), size);
  again.pass(100ms);
  // That game is over already.
  expect_sound(visible(again.boxes(), in(Text::kept_refused_level)), size);
}

TEST_P(Layout, GamesKeptThatAreBroken) {
  for (const bool fixed : {false, true}) {
    struct Fixed : app::MemoryStore {
      bool fixed = false;
      carom::Status set_aside(const std::string& name) override {
        if (fixed) return carom::Error{.problem = "cannot be moved"};
        return MemoryStore::set_aside(name);
      }
    } store;
    store.fixed = fixed;
    ASSERT_TRUE(store.save("continue-billiards.json", "{"));
    ASSERT_TRUE(store.save("continue-level.json", R"({"angry-balls-replay": 2})"));
    Player broken(std::get<1>(GetParam()), size.width, size.height, {}, store);
    expect_sound(visible(broken.boxes(), in(Text::kept_refused_billiards)), size);
    broken.key(app::Key::enter);
    expect_sound(visible(broken.boxes(), in(Text::kept_refused_level)), size);
  }
}

TEST(LayoutOfWideWindows, HasLargeButtonsInTheBar) {
  for (const Size size : {Size{1920, 1080}, {1280, 720}, {2560, 1080}}) {
    for (const bool table : {true, false}) {
      Player game(app::Language::fr, size.width, size.height);
      const app::View view = app::View::of(size.width, size.height);
      game.press(table ? "Billard" : "Angry Balls");
      if (!table) game.press("Premiers pas");
      game.pass(3s);
      int buttons = 0;
      for (const Box& box : game.boxes()) {
        const bool of_bar = app::GameLayout::of(view).bar.contains(box.area.center());
        if (of_bar && box.kind == Box::Kind::button) {
          ++buttons;
          EXPECT_GE(box.area.h, view.px(60)) << describe(box);
          EXPECT_GE(box.area.w, view.px(48)) << describe(box);
        }
        if (box.kind == Box::Kind::text && (box.text == "Quitter" || box.text == "Menu")) {
          EXPECT_GE(static_cast<float>(box.text_size), view.px(20)) << describe(box);
        }
      }
      EXPECT_EQ(buttons, 3);
    }
  }
}

TEST(LayoutOfAnySize, IsSurvivedByReplays) {
  for (const Size size : {Size{1, 1}, {64, 64}, {1, 2000}, {2000, 1}, {130, 97}, {8192, 64}}) {
    for (const char* file : {"level-09-won.json", "billiards-left-in-the-middle.json"}) {
      Player game(app::Language::fr, size.width, size.height);
      ASSERT_TRUE(game.clipboard().set_text(replay_file(file)));
      game.key(app::Key::paste);
      game.pass(500ms);
      EXPECT_FALSE(game.boxes().empty());
      game.click({0, 0});
      game.click({static_cast<float>(size.width) / 2, static_cast<float>(size.height) - 5});
      EXPECT_FALSE(game.boxes().empty());
      for (const app::Key key : {app::Key::escape, app::Key::tab, app::Key::tab, app::Key::enter})
        game.key(key);
      EXPECT_FALSE(game.boxes().empty());
    }
  }
}

TEST(LayoutOfAnySize, IsSurvived) {
  for (const Size size : {Size{1, 1}, {64, 64}, {1, 2000}, {2000, 1}, {130, 97}, {8192, 8192}}) {
    platform::NullPlatform game(app::Language::fr, size.width, size.height);
    EXPECT_FALSE(game.app().draw().indices.empty());
    game.app().event(app::KeyPressed{app::Key::enter});
    game.pass(500ms);
    EXPECT_FALSE(game.app().draw().indices.empty());
    game.app().event(app::Resized{size.height, size.width});
    EXPECT_FALSE(game.app().draw().indices.empty());
  }
}

TEST(LayoutOfAnySize, IsSurvivedByLevels) {
  const std::string odd =
      R"({"carom": 1, "width": 1000000000, "height": 3, "holes": [{"x": 50, "y": 2}],
    "obstacles": [{"x": 90, "height": 1000000, "radius": 0.01}], "balls": [
    {"x": 10, "y": 1, "radius": 1, "role": "projectile"},
    {"x": 30, "y": 1, "radius": 1, "role": "enemy"}]})";
  for (const Size size : {Size{1, 1}, {64, 64}, {1, 2000}, {2000, 1}, {130, 97}, {8192, 64}}) {
    Player game(app::Language::fr, size.width, size.height, {app::read_level("odd", odd)});
    for (const int tabs : {1, 11}) {
      game.app().event(app::Resized{800, 600});
      while (!game.says("écran titre")) game.leave();
      game.press("Angry Balls");
      game.app().event(app::Resized{size.width, size.height});
      EXPECT_FALSE(game.app().draw().indices.empty());
      for (int i = 0; i < tabs; ++i) game.key(app::Key::tab);
      game.key(app::Key::enter);
      EXPECT_FALSE(game.app().draw().indices.empty());
      game.click({0, 0});
      game.click({500, 0});
      game.pass(500ms);
      EXPECT_FALSE(game.app().draw().indices.empty());
    }
  }
}

const auto languages = testing::ValuesIn(app::all_languages());

std::string name_of(const testing::TestParamInfo<Layout::ParamType>& test) {
  const auto [size, language] = test.param;
  return std::to_string(size.width) + "x" + std::to_string(size.height) + "_" +
         std::string(app::code_of(language));
}

INSTANTIATE_TEST_SUITE_P(UsualSizes, Layout,
                         testing::Combine(testing::ValuesIn(usual_sizes), languages), name_of);
INSTANTIATE_TEST_SUITE_P(EverySize, Layout,
                         testing::Combine(testing::ValuesIn(other_sizes), languages), name_of);

}  // namespace
