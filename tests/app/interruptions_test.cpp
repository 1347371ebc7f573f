// Events at any moment: files and links, a window over the game, another hand, a window of no
// size, while something is held, aimed or carried.

#include <cmath>

#include "app/every_screen.hpp"
#include "app/player.hpp"
#include "app/screens/angry_balls_screen.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/view/effects.hpp"
#include "project_file.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;
using app::Point;

const std::string own_level =
    R"({"carom": 1, "name": "Mine", "width": 600, "height": 300, "gravity": 600, "balls": [
      {"x": 100, "y": 12, "role": "projectile"}, {"x": 400, "y": 12, "role": "enemy", "solidity": 900}]})";

class Interruptions : public testing::Test {
 protected:
  const app::BilliardsScreen& table() {
    return dynamic_cast<const app::BilliardsScreen&>(game.app().screen());
  }
  void key_up(Key key) { game.app().event(app::KeyReleased{key}); }
  void rebind(const std::string& command, Key key) {
    game.key(Key::help);
    game.press("Keys…");
    game.press(command);
    game.key(key);
    game.key(Key::escape);
    game.key(Key::escape);
  }
  void press_at(Point at) {
    game.app().event(app::PointerMoved{at});
    game.app().event(app::PointerPressed{at});
  }
  void move(Point at) { game.app().event(app::PointerMoved{at}); }
  void release_at(Point at) { game.app().event(app::PointerReleased{at}); }
  void aim_by(app::AimWay way) {
    app::Settings settings = game.app().settings().get();
    settings.aiming.way = way;
    game.app().settings().set(settings);
  }
  void shoot() {
    game.key(Key::enter);
    game.key(Key::enter);
    ASSERT_TRUE(game.says("watches"));
  }
  /// A throw that breaks nothing, up to the next one offered.
  void shoot_level() {
    game.key(Key::enter);
    for (int i = 0; i < 45; ++i) game.key(Key::down);
    game.key(Key::enter);
    game.wait_for("next throw");
  }
  /// Steps of 100 ms.
  std::uint64_t pace() {
    const std::uint64_t before = table().game().world().steps();
    for (int i = 0; i < 10; ++i) game.app().iterate(10ms);
    return table().game().world().steps() - before;
  }
  app::Rect button(std::string_view label) {
    for (const app::Box& box : game.boxes())
      if (box.kind == app::Box::Kind::button && box.text.find(label) != std::string::npos)
        return box.area;
    ADD_FAILURE() << label;
    return {};
  }

  app::MemoryStore store;
  Player game{app::Language::en, 1280, 720, {}, store};
};

TEST_F(Interruptions, AKeyLetGoUnderAnotherScreenIsLetGo) {
  game.press("Billiards");
  shoot();
  EXPECT_EQ(pace(), 10U);
  for (const Key over : {Key::settings, Key::help}) {
    game.key(Key::f);
    EXPECT_EQ(pace(), 40U);
    game.key(over);
    key_up(Key::f);
    game.key(Key::escape);
    EXPECT_EQ(pace(), 10U) << game.title();
  }
}

TEST_F(Interruptions, ATriggerAndAPressLetGoUnderTheSettingsAreLetGo) {
  game.press("Billiards");
  shoot();
  game.app().event(app::PadMoved{app::PadAxis::right_trigger, 1});
  EXPECT_EQ(pace(), 40U);
  game.key(Key::settings);
  game.app().event(app::PadMoved{app::PadAxis::right_trigger, 0});
  game.key(Key::escape);
  EXPECT_EQ(pace(), 10U);
  press_at({640, 360});
  pace();
  pace();
  game.key(Key::settings);
  release_at({640, 360});
  game.key(Key::escape);
  game.pass(300ms);
  EXPECT_EQ(pace(), 10U);
}

TEST_F(Interruptions, AReboundKeyLetGoUnderTheHelpIsLetGo) {
  rebind("Faster", Key::g);
  game.press("Billiards");
  shoot();
  game.key(Key::g);
  EXPECT_EQ(pace(), 40U);
  game.key(Key::help);
  key_up(Key::g);
  game.key(Key::escape);
  EXPECT_EQ(pace(), 10U);
}

TEST_F(Interruptions, NothingOpensOverABallThatIsPulled) {
  game.press("Billiards");
  shoot();
  game.wait_for("Player 2 aims");
  const Point cue = game.app().screen().aim_prompt()->at;
  press_at(cue);
  move(cue + Point{-90, 0});
  for (const Key key : {Key::r, Key::settings, Key::tab}) {
    game.key(key);
    EXPECT_TRUE(game.says("Player 2 aims")) << game.title();
  }
  release_at(cue + Point{-90, 0});
  EXPECT_TRUE(game.says("Player 2 watches")) << game.title();
}

TEST_F(Interruptions, AChargeEndsWithItsKeyUnderAQuestion) {
  game.press("Billiards");
  shoot();
  game.wait_for("Player 2 aims");
  aim_by(app::AimWay::turn);
  game.key(Key::enter);
  game.key(Key::space);
  EXPECT_TRUE(game.app().animating());
  game.press("Restart");
  ASSERT_TRUE(game.says("Restart?"));
  key_up(Key::space);
  game.press("Keep playing");
  game.pass(3s);
  const double speed = table().aimed()->speed();
  game.pass(300ms);
  EXPECT_EQ(table().aimed()->speed(), speed);
}

TEST_F(Interruptions, APullEndsWhenAReplayIsOpened) {
  game.press("Billiards");
  const Point cue = game.app().screen().aim_prompt()->at;
  press_at(cue);
  move(cue + Point{-90, 0});
  game.app().open_file("x", replay_file("level-01-won.json"));
  release_at(cue + Point{-90, 0});
  game.key(Key::escape);
  ASSERT_TRUE(game.says("Player 1 aims")) << game.title();
  EXPECT_EQ(table().aimed(), nullptr);
  game.click({640, 700});
  EXPECT_TRUE(game.says("Player 1 aims")) << "that click let nothing go";
}

TEST_F(Interruptions, TheBallInHandStaysWhereItIsCarried) {
  game.press("Billiards");
  const app::Viewport& seen = table().viewport();
  const carom::Vec2 corner{10, 10};
  game.click(game.app().screen().aim_prompt()->at);
  game.click(seen.to_window(corner));
  game.wait_for("Player 2 places");
  for (int i = 0; i < 20; ++i) game.key(Key::up);
  const auto carried = [&] { return table().viewport().to_world(table().aim_prompt()->at); };
  const carom::Vec2 there = carried();
  const auto expect_there = [&](const char* why) {
    EXPECT_NEAR(carried().x, there.x, 0.01) << why;
    EXPECT_NEAR(carried().y, there.y, 0.01) << why;
  };
  game.key(Key::settings);
  game.key(Key::escape);
  expect_there("settings were looked at");
  game.app().event(app::Resized{390, 844, 1});
  expect_there("the phone was turned");
  game.app().event(app::Resized{1, 1, 1});
  game.app().event(app::Resized{1280, 720, 1});
  EXPECT_TRUE(std::isfinite(carried().x));

  // The place that a finger tries first is not free: it stays shown as such.
  const Point on_a_ball = seen.to_window(table().game().world().ball(5).position);
  game.touches = true;
  game.click(on_a_ball);
  EXPECT_TRUE(game.shows("another ball is in the way"));
}

TEST_F(Interruptions, LabelsAreForTheDeviceUsedLast) {
  const auto next_label = [&]() -> std::string {
    for (const app::Box& box : game.boxes())
      if (box.kind == app::Box::Kind::button && box.text.starts_with("Next throw")) return box.text;
    return {};
  };
  game.press("Angry Balls");
  game.press("First steps");
  shoot_level();
  EXPECT_EQ(next_label(), "Next throw (N)");
  game.app().event(app::PadPressed{app::PadButton::right});
  EXPECT_EQ(next_label(), "Next throw");
  game.key(Key::tab);
  EXPECT_EQ(next_label(), "Next throw (N)");
  game.key(Key::help);
  game.press("Keys…");
  game.press("Next throw");
  game.key(Key::k);
  game.key(Key::escape);
  game.key(Key::escape);
  EXPECT_EQ(next_label(), "Next throw (K)");
}

TEST_F(Interruptions, TheMouseShrinksButtonsWhenItLetsGo) {
  game.touches = true;
  game.press("Angry Balls");
  const Point title = button("Title").center();
  press_at(title);
  move(title + Point{1, 1});
  release_at(title + Point{1, 1});
  EXPECT_TRUE(game.says("title screen")) << game.title();
}

TEST_F(Interruptions, TheMouseShrinksButtonsOfAWindowThatBeganForFingers) {
  for (const bool resized : {false, true}) {
    app::MemoryClipboard clipboard;
    app::HostEnvironment phone;
    phone.touch = true;
    app::App app(app::Language::en, 390, 844, store, clipboard, {}, phone);
    if (resized) app.event(app::Resized{390, 844, 1});
    app.event(app::PointerPressed{{1, 1}});
    app.event(app::PointerReleased{{1, 1}});
    app::App other(app::Language::en, 390, 844, store, clipboard);
    const auto height = [](app::App& of) {
      of.event(app::KeyPressed{Key::settings});
      for (const app::Box& box : of.draw().boxes)
        if (box.kind == app::Box::Kind::button && box.text == "Close") return box.area.h;
      return 0.0f;
    };
    EXPECT_EQ(height(app), height(other));
  }
}

TEST_F(Interruptions, TheMessageNamesTheKeyThatMutes) {
  rebind("Sound on, off", Key::k);
  game.key(Key::k);
  EXPECT_TRUE(game.shows("Sound off (K: on)"));
}

TEST_F(Interruptions, WhilePausedNothingIsAimed) {
  game.press("Billiards");
  game.key(Key::p);
  game.app().event(app::TextTyped{"4"});
  game.app().event(app::WheelTurned{1});
  EXPECT_TRUE(game.says("paused"));
  game.key(Key::space);
  EXPECT_FALSE(game.says("paused"));
  EXPECT_EQ(table().aimed(), nullptr);
}

TEST_F(Interruptions, ALevelOpenedIsPlayedAndLeavesTheGameKeptAlone) {
  game.press("Angry Balls");
  game.press("First steps");
  shoot_level();
  const auto names = app::KeptGames(store).names();
  ASSERT_EQ(names.size(), 1U);
  game.app().open_file("mine.json", own_level);
  EXPECT_TRUE(game.says("Level 11: “Mine” (your level)")) << game.title();
  EXPECT_EQ(app::KeptGames(store).names(), names);
}

bool finite(const app::DrawList& list) {
  return std::ranges::all_of(list.vertices, [](const app::Vertex& vertex) {
    return std::isfinite(vertex.position.x) && std::isfinite(vertex.position.y);
  });
}

TEST(TinyWindow, EveryScreenIsDrawnWithoutNonsense) {
  for (const app::Resized size : {app::Resized{1, 1}, {1, 900}, {1600, 1}})
    every_screen::Walk({}, [&](const every_screen::Shown& shown) {
      shown.event(size);
      EXPECT_TRUE(finite(shown.draw()))
          << shown.where << " at " << size.width << " x " << size.height;
      shown.event(app::Resized{1280, 720, 1});
    }).all();
}

TEST(TinyWindow, AShockThatShakesThePictureLeavesItWhereItIs) {
  app::Effects effects;
  effects.burst({1, 1}, 8, app::BallKind::red, 1);
  app::DrawList list;
  list.add({1, 2}, {});
  effects.shake(list, 0, {0, 0, 0, 0});
  EXPECT_TRUE(finite(list));
}

}  // namespace
