// Both games from the title to the end and back by keyboard alone, by gamepad alone, by touch
// alone.

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

#include "app/greedy_player.hpp"
#include "app/hud/aim_controls.hpp"
#include "app/player.hpp"
#include "app/screens/angry_balls_screen.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/storage/level.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;
using app::PadAxis;
using app::PadButton;
using games::billiards::Obstruction;

namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;

class Hands : public testing::Test {
 protected:
  Player game{app::Language::en, 1280, 720};

  /// The table on screen; under the window of the end the one that was seen last.
  const app::BilliardsScreen& table() {
    if (const auto* seen = dynamic_cast<const app::BilliardsScreen*>(&game.app().screen()))
      table_ = seen;
    return *table_;
  }
  const app::AngryBallsScreen& level() {
    return dynamic_cast<const app::AngryBallsScreen&>(game.app().screen());
  }
  template <class Phase>
  void watch(Phase phase) {
    for (int i = 0; i < 10'000 && phase(); ++i) game.pass(100ms);
    ASSERT_FALSE(phase());
  }
  /// A place that is free, and 3 px beside it too.
  carom::Vec2 free_place() {
    const auto free = [&](carom::Vec2 at) {
      return table().game().obstruction(at) == Obstruction::none;
    };
    for (double x = 200; x < 780; x += 13)
      for (double y = 200; y < 380; y += 11)
        if (free({x, y}) && free({x - 3, y}) && free({x + 3, y}) && free({x, y - 3}) &&
            free({x, y + 3}))
          return {x, y};
    return {};
  }
  template <class Shoot, class Place>
  void play_table(Shoot shoot, Place place) {
    int turns = 0;
    for (; table().game().phase() != billiards::Phase::over && turns < 600; ++turns) {
      if (table().game().phase() == billiards::Phase::place) place(free_place());
      ASSERT_EQ(table().game().phase(), billiards::Phase::aim) << "turn " << turns;
      const auto shot = greedy::choose_shot(table().game(), table().viewport(), 3);
      shoot(greedy::drag_of(shot, table().viewport()));
      ASSERT_EQ(table().game().phase(), billiards::Phase::roll) << "turn " << turns;
      watch([&] { return table().game().phase() == billiards::Phase::roll; });
    }
    EXPECT_EQ(table().game().phase(), billiards::Phase::over) << turns;
    EXPECT_TRUE(game.says("wins!") || game.says("draw")) << game.title();
  }
  /// Is true if the aim wins the level.
  bool wins() {
    angry_balls::Game played = level().game();
    if (!played.apply(angry_balls::Throw{level().aimed()->drag()})) return false;
    while (played.phase() == angry_balls::Phase::fly) played.step();
    return played.phase() == angry_balls::Phase::won;
  }
  void watch_level() {
    ASSERT_EQ(level().game().phase(), angry_balls::Phase::fly);
    watch([&] { return level().game().phase() == angry_balls::Phase::fly; });
    EXPECT_TRUE(game.says("Level won!")) << game.title();
    game.pass(3s);
  }

  // Keys.
  void type(double number) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.3f", number);
    game.app().event(app::TextTyped{text.data()});
  }
  void key(Key key, bool shift = false) { game.app().event(app::KeyPressed{key, shift, false}); }
  void shoot_by_keys(carom::Vec2 drag) {
    app::Aim aim;
    aim.set(drag);
    type(aim.degrees());
    key(Key::tab);
    type(aim.speed());
    key(Key::enter);
    key(Key::enter);
  }

  // The gamepad.
  void pad(PadButton button) {
    game.app().event(app::PadPressed{button});
    game.app().event(app::PadReleased{button});
  }
  /// Holds a stick as long as `on`.
  template <class On>
  void hold(PadAxis axis, float to, On on) {
    game.app().event(app::PadMoved{axis, to});
    for (int i = 0; i < 2000 && on(); ++i) game.pass(10ms);
    game.app().event(app::PadMoved{axis, 0});
    EXPECT_FALSE(on());
  }
  template <class Screen>
  void aim_by_pad(const Screen& screen, carom::Vec2 drag) {
    app::Aim wanted;
    wanted.set(drag);
    pad(PadButton::left);  // shows the aim
    const auto turn = [&] {
      return std::remainder(wanted.degrees() - screen().aimed()->degrees(), 360);
    };
    const auto more = [&] { return wanted.speed() - screen().aimed()->speed(); };
    const bool left = turn() > 0;
    hold(PadAxis::left_x, left ? -1.0f : 1.0f,
         [&] { return left ? turn() > 0 && turn() < 170 : turn() < 0 && turn() > -170; });
    while (std::abs(turn()) > 0.6) pad(turn() > 0 ? PadButton::left : PadButton::right);
    for (int i = 0; i < 12 && std::abs(turn()) > 0.06; ++i)
      pad(turn() > 0 ? PadButton::left_shoulder : PadButton::right_shoulder);
    if (more() > 20) hold(PadAxis::right_trigger, 1, [&] { return more() > 20; });
    if (more() < -20) hold(PadAxis::right_y, 1, [&] { return more() < -20; });
    for (int i = 0; i < 12 && std::abs(more()) > 6; ++i)
      pad(more() > 0 ? PadButton::up : PadButton::down);
  }

  // Fingers.
  void finger(app::Finger::Phase phase, app::Point at, std::int64_t id = 1) {
    game.app().event(app::Finger{id, phase, at});
  }
  void tap(app::Point at) {
    finger(app::Finger::Phase::down, at);
    finger(app::Finger::Phase::up, at);
  }
  void tap(std::string_view label) {
    std::optional<app::Point> at;
    for (const app::Box& box : game.boxes())
      if (box.kind == app::Box::Kind::button && box.text.find(label) != std::string::npos)
        at = box.area.center();
    ASSERT_TRUE(at) << "no button " << label << " in " << game.title();
    tap(*at);
  }

 private:
  const app::BilliardsScreen* table_ = nullptr;
};

TEST_F(Hands, ATableByKeyboardAlone) {
  key(Key::enter);
  play_table([&](carom::Vec2 drag) { shoot_by_keys(drag); },
             [&](carom::Vec2 to) {
               const auto away = [&] {
                 return to - table().viewport().to_world(table().aim_prompt()->at);
               };
               for (const bool fine : {false, true}) {
                 const double least = fine ? 0.6 : 3;
                 while (std::abs(away().x) > least)
                   key(away().x > 0 ? Key::right : Key::left, fine);
                 while (std::abs(away().y) > least) key(away().y > 0 ? Key::up : Key::down, fine);
               }
               key(Key::enter);
             });
  key(Key::escape);
  EXPECT_TRUE(game.says("title screen"));
  key(Key::escape);
  EXPECT_TRUE(game.app().quit_requested());
}

TEST_F(Hands, ALevelByKeyboardAlone) {
  for (int i = 0; i < 4; ++i) key(Key::tab);
  key(Key::enter);
  ASSERT_TRUE(game.says("level menu"));
  key(Key::tab);
  key(Key::enter);
  ASSERT_TRUE(game.says("Level 1"));
  shoot_by_keys({155, -14});
  watch_level();
  key(Key::enter);
  EXPECT_TRUE(game.says("Level 2"));
}

TEST_F(Hands, ATableByGamepadAlone) {
  pad(PadButton::down);  // the first button
  pad(PadButton::a);
  play_table(
      [&](carom::Vec2 drag) {
        aim_by_pad([&]() -> const app::BilliardsScreen& { return table(); }, drag);
        pad(PadButton::a);
      },
      [&](carom::Vec2 to) {
        const auto away = [&] {
          return to - table().viewport().to_world(table().aim_prompt()->at);
        };
        if (away().x > 4) hold(PadAxis::left_x, 1, [&] { return away().x > 4; });
        if (away().x < -4) hold(PadAxis::left_x, -1, [&] { return away().x < -4; });
        if (away().y > 4) hold(PadAxis::left_y, -1, [&] { return away().y > 4; });
        if (away().y < -4) hold(PadAxis::left_y, 1, [&] { return away().y < -4; });
        while (std::abs(away().x) > 2.6) pad(away().x > 0 ? PadButton::right : PadButton::left);
        while (std::abs(away().y) > 2.6) pad(away().y > 0 ? PadButton::up : PadButton::down);
        pad(PadButton::a);
      });
  pad(PadButton::b);
  EXPECT_TRUE(game.says("title screen"));
  pad(PadButton::b);
  EXPECT_TRUE(game.app().quit_requested());
}

TEST_F(Hands, ALevelByGamepadAlone) {
  for (int i = 0; i < 4; ++i) {  // the stick, as a cross
    game.app().event(app::PadMoved{PadAxis::left_y, 1});
    game.app().event(app::PadMoved{PadAxis::left_y, 0});
  }
  pad(PadButton::a);
  ASSERT_TRUE(game.says("level menu"));
  pad(PadButton::right);
  pad(PadButton::a);
  ASSERT_TRUE(game.says("Level 1"));
  aim_by_pad([&]() -> const app::AngryBallsScreen& { return level(); }, {155, -14});
  for (int i = 0; i < 40 && !wins(); ++i) pad(PadButton::left_shoulder);
  ASSERT_TRUE(wins());
  pad(PadButton::a);
  watch_level();
  pad(PadButton::a);
  EXPECT_TRUE(game.says("Level 2"));
}

TEST_F(Hands, ATableByTouchAlone) {
  tap("Billiards");
  play_table(
      [&](carom::Vec2 drag) {
        const app::Point cue =
            table().viewport().to_window(table().game().world().ball(0).position);
        const app::Point way = app::unit({-static_cast<float>(drag.x), static_cast<float>(drag.y)});
        // Taken beside its middle: a finger is not a needle.
        const app::Point from = cue + app::Point{9, -9};
        finger(app::Finger::Phase::down, from);
        const double speed = std::min(carom::length(drag) * games::launch_factor, 1995.0);
        for (float far = 20; far < 800; far += 1) {
          finger(app::Finger::Phase::moved, from + way * far);
          if (table().aimed()->speed() >= speed) {
            finger(app::Finger::Phase::up, from + way * far);
            return;
          }
        }
      },
      [&](carom::Vec2 to) { tap(table().viewport().to_window(to)); });
  tap("Back to title");
  EXPECT_TRUE(game.says("title screen"));
}

TEST_F(Hands, ALevelByTouchAlone) {
  tap("Angry Balls");
  ASSERT_TRUE(game.says("level menu"));
  tap("First steps");
  ASSERT_TRUE(game.says("Level 1"));
  const auto window = [&](carom::Vec2 at) { return level().viewport().to_window(at); };
  const carom::Vec2 ball = level().game().world().ball(0).position;
  // A second finger takes the aim back.
  finger(app::Finger::Phase::down, window(ball));
  finger(app::Finger::Phase::moved, window(ball - carom::Vec2{60, 0}));
  ASSERT_TRUE(level().aimed());
  finger(app::Finger::Phase::down, {900, 300}, 2);
  EXPECT_FALSE(level().aimed());
  finger(app::Finger::Phase::up, window(ball - carom::Vec2{60, 0}));
  finger(app::Finger::Phase::up, {900, 300}, 2);
  ASSERT_EQ(level().game().phase(), angry_balls::Phase::aim);

  tap(window(ball));
  tap(window(ball + carom::Vec2{155, -14}));
  watch_level();
  tap("Next level");
  EXPECT_TRUE(game.says("Level 2"));
}

/// What a new player does: a tap, a drag across, the bar, the button.
TEST_F(Hands, ALevelByTapDragBarAndButtonByMouseAndFinger) {
  for (const bool by_finger : {false, true}) {
    const auto down = [&](app::Point at) {
      if (by_finger) return finger(app::Finger::Phase::down, at);
      game.app().event(app::PointerMoved{at});
      game.app().event(app::PointerPressed{at});
    };
    const auto move = [&](app::Point at) {
      if (by_finger) return finger(app::Finger::Phase::moved, at);
      game.app().event(app::PointerMoved{at});
    };
    const auto up = [&](app::Point at) {
      if (by_finger) return finger(app::Finger::Phase::up, at);
      game.app().event(app::PointerReleased{at});
    };
    const auto press = [&](app::Point at) {
      down(at);
      up(at);
    };
    press(game.find("Angry Balls")->center());
    press(game.find("First steps")->center());
    ASSERT_TRUE(game.says("Level 1")) << game.title();
    const carom::Vec2 drag{155, -14};
    app::Aim wanted;
    wanted.set(drag);
    const auto window = [&](carom::Vec2 at) { return level().viewport().to_window(at); };
    const carom::Vec2 ball = level().game().world().ball(0).position;
    EXPECT_FALSE(game.offers("Shoot"));
    press(window(ball + 2.0 * drag));
    ASSERT_TRUE(level().aimed());
    EXPECT_NEAR(level().aimed()->degrees(), wanted.degrees(), 0.5);
    // Up a point turns it by 0.1°, whatever is beneath.
    const app::Point from{640, 300};
    const auto off = static_cast<float>((wanted.degrees() + 3 - level().aimed()->degrees()) / 0.1);
    down(from);
    move(from - app::Point{0, 5});
    move(from - app::Point{0, 5 + off});
    up(from - app::Point{0, 5 + off});
    EXPECT_NEAR(level().aimed()->degrees(), wanted.degrees() + 3, 0.02);
    // The field: 300 points to the right are 3° back.
    const app::Point fine = game.find("Fine")->center();
    down(fine);
    move(fine + app::Point{5, 0});
    move(fine + app::Point{305, 0});
    up(fine + app::Point{305, 0});
    EXPECT_NEAR(level().aimed()->degrees(), wanted.degrees(), 0.02);
    app::View view = app::View::of(1280, 720);
    view.touch = by_finger;
    const app::Rect meter = app::strength_meter(view, app::GameLayout::of(view).footer);
    press({meter.x + meter.w * static_cast<float>(wanted.strength()), meter.center().y});
    EXPECT_NEAR(level().aimed()->speed(), wanted.speed(), 4);
    EXPECT_EQ(level().game().phase(), angry_balls::Phase::aim);
    press(game.find("Shoot")->center());
    watch_level();
    press(game.find("Menu")->center());
    game.key(Key::escape);
    ASSERT_TRUE(game.says("title screen")) << game.title();
  }
}

TEST_F(Hands, AFingerTurnsAndTheButtonShoots) {
  key(Key::settings);
  tap("Game");
  for (int i = 0; i < 3 && !game.shows("Turn, then power"); ++i) tap("Way");
  tap("Close");
  for (const bool by_button : {true, false}) {
    tap("Billiards");
    const app::Point cue = table().viewport().to_window({200, 200});
    EXPECT_FALSE(game.offers("Shoot"));
    tap(cue + app::Point{0, -100});
    ASSERT_TRUE(table().aimed());
    EXPECT_NEAR(table().aimed()->degrees(), 90, 0.1);
    EXPECT_EQ(table().game().phase(), billiards::Phase::aim) << "a finger lifted shoots nothing";
    if (by_button)
      tap("Shoot");
    else
      tap(cue);
    EXPECT_EQ(table().game().phase(), billiards::Phase::roll);
    game.pass(100ms);
    tap("Leave");
  }
}

/// Once a finger is used all buttons in a game are large enough for one.
TEST_F(Hands, ButtonsGrowForFingers) {
  for (const auto& [width, height] :
       {std::pair{800, 600}, {1280, 720}, {1920, 1080}, {390, 844}, {844, 390}}) {
    for (const bool practice : {false, true}) {
      Player small(app::Language::fr, width, height);
      small.app().event(app::Finger{0, app::Finger::Phase::down, {1, 1}});
      small.app().event(app::Finger{0, app::Finger::Phase::up, {1, 1}});
      small.press(practice ? "S’exercer" : "Billard");
      // The mouse that pressed it shrinks them again.
      small.app().event(app::Finger{0, app::Finger::Phase::down, {1, 1}});
      small.app().event(app::Finger{0, app::Finger::Phase::up, {1, 1}});
      for (const app::Box& box : small.boxes()) {
        if (box.kind != app::Box::Kind::button) continue;
        EXPECT_GE(box.area.h, 44) << box.text << " at " << width << "x" << height;
        EXPECT_GE(box.area.w, 44) << box.text << " at " << width << "x" << height;
      }
    }
  }
}

TEST_F(Hands, HintsAreForTheDeviceUsedLast) {
  game.app().teach_beginners();
  key(Key::enter);
  EXPECT_TRUE(game.shows("Set the strength"));
  EXPECT_TRUE(game.shows("Click where to send it, or pull the ball back. Keys: arrows, Enter."));
  game.app().event(app::PadMoved{PadAxis::right_trigger, 0.1f});
  EXPECT_TRUE(game.shows("Keys: arrows")) << "a trigger that is not quite let go is no hand";
  game.app().event(app::PadMoved{PadAxis::right_trigger, 0.6f});
  game.app().event(app::PadMoved{PadAxis::right_trigger, 0});
  EXPECT_TRUE(game.shows("Triggers: power"));
  EXPECT_FALSE(game.shows("Set the strength"));
  EXPECT_TRUE(game.shows("A: shoot."));
  game.app().event(app::Finger{1, app::Finger::Phase::down, {1, 1}});
  game.app().event(app::Finger{1, app::Finger::Phase::up, {1, 1}});
  EXPECT_TRUE(game.shows("Tap where to send it"));
  EXPECT_FALSE(game.shows("A: shoot."));
  key(Key::up);
  key(Key::escape);
  EXPECT_TRUE(game.shows("pull the ball back."));
  EXPECT_FALSE(game.shows("Keys: arrows")) << "a finger's keys are those of the screen";
  game.click({1, 1});
  EXPECT_TRUE(game.shows("Click where to send it"));
  for (const PadButton by : {PadButton::b, PadButton::back, PadButton::back, PadButton::a}) pad(by);
  EXPECT_TRUE(game.says("title screen")) << game.title();
  key(Key::enter);
  EXPECT_TRUE(game.shows("Keys: arrows"));
  tap("Leave");
  tap("Angry Balls");
  tap("First steps");
  EXPECT_TRUE(game.says("tap the angry ball"));
}

TEST_F(Hands, NothingLightsUpOnceAFingerIsLifted) {
  const auto picture = [&] { return game.app().draw().vertices.size(); };
  finger(app::Finger::Phase::down, {1, 1});
  finger(app::Finger::Phase::up, {1, 1});
  const std::size_t before = picture();
  app::Point button;
  for (const app::Box& box : game.boxes())
    if (box.text == "Billiards") button = box.area.center();
  finger(app::Finger::Phase::down, button);
  EXPECT_TRUE(game.shows("A game for two")) << "what a button does is told while it is held";
  EXPECT_NE(picture(), before);
  finger(app::Finger::Phase::moved, {1, 1});
  finger(app::Finger::Phase::up, {1, 1});
  EXPECT_EQ(picture(), before);
}

TEST(Footer, TheHintStaysInTheMiddleBesideThePower) {
  Player wide(app::Language::fr, 1280, 720);
  app::Settings settings = wide.app().settings().get();
  settings.aiming.way = app::AimWay::pull;
  wide.app().settings().set(settings);
  wide.press("Billard");
  wide.pass(std::chrono::seconds{3});
  const auto middle = [&](std::string_view hint) {
    for (const app::Box& box : wide.boxes())
      if (box.text.find(hint) != std::string::npos) return box.area.center().x;
    return 0.0f;
  };
  EXPECT_NEAR(middle("Clavier : flèches"), 640, 1);
  wide.key(Key::up);
  EXPECT_TRUE(wide.shows("\u202f%"));
  EXPECT_NEAR(middle("Flèches : viser"), 640, 1);
}

}  // namespace
