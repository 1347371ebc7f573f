#include "app/play/launcher.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "app/screens/angry_balls_screen.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/staged.hpp"
#include "games/launch.hpp"

namespace {

using namespace std::chrono_literals;
using app::AimWay;
using app::Key;
using app::Launcher;
using app::Point;

/// A launcher in a window of 1280 × 1000 px that shows a table of 800 × 400 px pixel by pixel.
/// Its left edge is 60 px from the window's, as it is at worst on a real screen.
class LauncherTest : public testing::Test {
 protected:
  Launcher::Outcome give(const app::Input& input) { return launcher.event(input, stage); }
  Launcher::Outcome key(Key key) { return give(app::KeyPressed{key}); }
  Launcher::Outcome fine(Key key) { return give(app::KeyPressed{key, true, false}); }
  void move(Point at) { give(app::PointerMoved{at}); }
  Launcher::Outcome press(Point at) {
    move(at);
    return give(app::PointerPressed{at});
  }
  Launcher::Outcome release(Point at) {
    move(at);
    return give(app::PointerReleased{at});
  }
  void click(Point at) {
    press(at);
    release(at);
  }
  Point window(double x, double y) const { return stage.viewport.to_window({x, y}); }
  void put_lead(double x, double y) { stage.lead.position = {x, y}; }
  void type(std::string_view text) {
    for (const char sign : text) give(app::TextTyped{{sign}});
  }

  Launcher launcher{{100, 0}};
  Launcher::Stage stage{.lead = {.role = carom::Role::cue, .position = {200, 200}, .radius = 8},
                        .viewport = app::Viewport({60, 450, 800, 400}, {0, 0}, {800, 400}),
                        .view = app::View::of(1280, 1000),
                        .world = {60, 450, 800, 400},
                        .meter = {500, 950, 200, 30},
                        .shoot = {300, 950, 112, 44},
                        .fine = {720, 950, 100, 40},
                        .way = AimWay::pull};
  const Point lead = window(200, 200);
};

TEST_F(LauncherTest, APullLaunchesTheOtherWay) {
  press(lead);
  move(window(260, 280));
  EXPECT_EQ(launcher.stance(), Launcher::Stance::pulling);
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{-60, -80})) << "1 px of pull for 1 px of drag";
  EXPECT_EQ(release(window(260, 280)), Launcher::Outcome::launch);
}

/// The picture counts, on a table that stands upright, too.
TEST_F(LauncherTest, OnATurnedTableEachWayGoesWhereOneSees) {
  stage.viewport = app::Viewport({60, 100, 400, 800}, {0, 0}, {800, 400}, true);
  const Point cue = window(200, 200);
  constexpr double up_and_left = 36.87;  // the world's right is up, its up is left
  press(cue);
  move(cue + Point{60, 80});
  EXPECT_NEAR(launcher.aim.degrees(), up_and_left, 0.01) << "pulled down and to the right";
  key(Key::escape);
  release(cue);
  click(cue);
  move(cue + Point{-60, -80});
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{80, 60})) << "by two clicks";
  key(Key::escape);
  stage.way = AimWay::turn;
  move(cue + Point{-120, -160});
  EXPECT_NEAR(launcher.aim.degrees(), up_and_left, 0.01) << "turned there";
}

/// 5 px/s a point of the screen, whatever the window, the room and the world's scale.
TEST_F(LauncherTest, APullHasOneScaleInEveryWindow) {
  struct Window {
    app::View view;
    app::Viewport viewport;
  };
  const carom::Vec2 corner{800, 400};
  for (const auto& [view, viewport] :
       {Window{app::View::of(1280, 720), app::Viewport({0, 80, 1280, 590}, {0, 0}, corner)},
        Window{app::View::of(800, 600), app::Viewport({0, 80, 800, 400}, {0, 0}, corner)},
        Window{app::View::of(390, 844), app::Viewport({0, 130, 390, 600}, {0, 0}, corner, true)},
        Window{app::View::of(1170, 2532, 3),
               app::Viewport({0, 390, 1170, 1800}, {0, 0}, corner)}}) {
    stage.view = view;
    stage.viewport = viewport;
    for (const carom::Vec2 at : {carom::Vec2{10, 10}, {790, 390}, {200, 200}}) {
      put_lead(at.x, at.y);
      const Point from = window(at.x, at.y);
      for (const float points : {20.0f, 80.0f, 399.0f, 500.0f}) {
        press(from);
        move(from + Point{0, points * view.density});
        EXPECT_NEAR(launcher.aim.speed(), std::min(5.0 * static_cast<double>(points), 2000.0), 0.1)
            << view.width << ": " << points;
        key(Key::escape);
        release(from);
      }
    }
  }
}

TEST_F(LauncherTest, APullIsTakenBackNearTheBallOrByEscape) {
  press(lead);
  move(lead + Point{-80, 0});
  EXPECT_EQ(release(lead + Point{-8, 0}), Launcher::Outcome::taken);
  EXPECT_FALSE(launcher.aim.active());
  press(lead);
  move(lead + Point{-80, 0});
  EXPECT_EQ(key(Key::escape), Launcher::Outcome::taken);
  EXPECT_EQ(release(lead + Point{-80, 0}), Launcher::Outcome::untouched);
  EXPECT_FALSE(launcher.aim.active());
  press(lead);
  move(lead + Point{-80, 0});
  give(app::PointerPressed{lead + Point{-80, 0}, app::PointerButton::right});
  EXPECT_FALSE(launcher.aim.active());
}

TEST_F(LauncherTest, AClickThatDoesNotMoveIsTheFirstOfTwoInEachWay) {
  for (const AimWay way : {AimWay::clicks, AimWay::pull, AimWay::turn}) {
    launcher = Launcher();
    stage.way = way;
    press(lead);
    EXPECT_EQ(release(lead + Point{2, 1}),
              way == AimWay::pull ? Launcher::Outcome::taken : Launcher::Outcome::untouched);
    move(lead + Point{60, 80});
    EXPECT_EQ(launcher.stance(), Launcher::Stance::clicked);
    EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{60, -80})) << "towards the second click";
    EXPECT_EQ(press(lead + Point{60, 80}), Launcher::Outcome::launch);
  }
}

TEST_F(LauncherTest, AfterAClickThatHasNotMovedKeysAndNumbersAimAsFromTheStart) {
  click(lead);
  key(Key::left);
  EXPECT_NEAR(launcher.aim.degrees(), 1, 0.05);
  EXPECT_NEAR(launcher.aim.speed(), 500, 0.1);
  key(Key::escape);
  click(lead);
  type("90");
  key(Key::enter);
  EXPECT_NEAR(launcher.aim.degrees(), 90, 0.05);
  EXPECT_EQ(key(Key::enter), Launcher::Outcome::launch);
}

TEST_F(LauncherTest, AfterAClickAPressOnTheBallCanStillPull) {
  click(lead);
  press(lead);
  EXPECT_TRUE(launcher.refused());
  move(lead + Point{100, 0});
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{-100, 0}));
  EXPECT_EQ(release(lead + Point{100, 0}), Launcher::Outcome::launch);
}

TEST_F(LauncherTest, KeysTurnAndStrengthen) {
  key(Key::left);
  EXPECT_EQ(launcher.stance(), Launcher::Stance::by_keys);
  EXPECT_NEAR(launcher.aim.degrees(), 1, 0.01);
  EXPECT_NEAR(launcher.aim.speed(), 500, 0.06);
  for (int i = 0; i < 3; ++i) fine(Key::right);
  EXPECT_NEAR(launcher.aim.degrees(), 0.7, 0.01);
  key(Key::up);
  EXPECT_NEAR(launcher.aim.speed(), 510, 0.06);
  for (int i = 0; i < 3; ++i) give(app::KeyPressed{Key::down, false, true});
  EXPECT_NEAR(launcher.aim.speed(), 507, 0.06);
  EXPECT_EQ(key(Key::enter), Launcher::Outcome::launch);
}

TEST_F(LauncherTest, NothingIsLaunchedUnseenAndEscapeCancels) {
  for (const Key go : {Key::enter, Key::space}) {
    EXPECT_EQ(key(go), Launcher::Outcome::taken);
    EXPECT_TRUE(launcher.aim.active());
    EXPECT_EQ(key(Key::escape), Launcher::Outcome::taken);
    EXPECT_FALSE(launcher.aim.active());
    EXPECT_EQ(key(Key::escape), Launcher::Outcome::untouched) << "leaves the screen";
  }
}

TEST_F(LauncherTest, EnterIsForTheButtonThatHasTheFocus) {
  key(Key::left);
  stage.focus_elsewhere = true;
  EXPECT_EQ(key(Key::enter), Launcher::Outcome::untouched);
  EXPECT_EQ(key(Key::space), Launcher::Outcome::untouched);
}

TEST_F(LauncherTest, ARestingPointerKeepsTheAimOfKeys) {
  click(lead);
  move(lead + Point{100, 0});
  fine(Key::left);
  move(lead + Point{102, 1});
  EXPECT_NEAR(launcher.aim.degrees(), 0.1, 0.01);
  EXPECT_EQ(press(lead + Point{102, 1}), Launcher::Outcome::launch);
  EXPECT_NEAR(launcher.aim.degrees(), 0.1, 0.01);
  move(lead + Point{0, 100});
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{0, -100})) << "one that moves on aims again";
}

TEST_F(LauncherTest, NumbersCanBeTyped) {
  type("47.3");
  EXPECT_EQ(launcher.stance(), Launcher::Stance::entering);
  key(Key::tab);
  type("812");
  EXPECT_EQ(key(Key::enter), Launcher::Outcome::taken) << "first they are taken";
  EXPECT_NEAR(launcher.aim.degrees(), 47.3, 0.01);
  EXPECT_NEAR(launcher.aim.speed(), 812, 0.06);
  EXPECT_EQ(key(Key::enter), Launcher::Outcome::launch);

  type("9");
  EXPECT_EQ(key(Key::escape), Launcher::Outcome::taken);
  EXPECT_NEAR(launcher.aim.degrees(), 47.3, 0.01) << "and taken back";
  type("9");
  key(Key::backspace);
  EXPECT_FALSE(launcher.entry) << "empty, it closes";
  type("x +");
  EXPECT_FALSE(launcher.entry);
}

TEST_F(LauncherTest, ThePointerTurnsAndAClickLaunches) {
  stage.way = AimWay::turn;
  move(window(200, 300));
  EXPECT_EQ(launcher.stance(), Launcher::Stance::turning);
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{0, 100}));
  give(app::WheelTurned{2});
  EXPECT_NEAR(launcher.aim.speed(), 600, 0.06);
  move(window(500, 200));
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{120, 0})) << "near or far, the strength stays";
  move({stage.meter.x + 50, stage.meter.y + 5});
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{120, 0})) << "outside the table it turns nothing";
  EXPECT_EQ(press({stage.meter.x + 50, stage.meter.y + 5}), Launcher::Outcome::taken);
  EXPECT_NEAR(launcher.aim.speed(), 500, 0.06) << "a quarter of the bar";
  move({stage.meter.x + 500, 300});
  EXPECT_NEAR(launcher.aim.speed(), 2000, 0.06);
  release({stage.meter.x + 100, 300});
  EXPECT_NEAR(launcher.aim.speed(), 1000, 0.06);
  EXPECT_EQ(key(Key::escape), Launcher::Outcome::untouched) << "there is nothing to take back";
  EXPECT_EQ(press(window(200, 300)), Launcher::Outcome::launch);
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{0, 200}));
}

class AngleAndStrengthApart : public LauncherTest {
 protected:
  AngleAndStrengthApart() { stage.way = AimWay::apart; }
  void drag(Point from, Point by) {
    press(from);
    const Point begin = from + app::unit(by) * (5 * stage.view.density);  // no tap any more
    move(begin);
    move(begin + by);
    release(begin + by);
  }
  Point middle(const app::Rect& box) { return box.center(); }
};

TEST_F(AngleAndStrengthApart, ATapPoints) {
  click(window(200, 300));
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{0, 100}));
  EXPECT_EQ(launcher.stance(), Launcher::Stance::turning);
  click(window(500, 200));
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{100, 0})) << "near or far, the strength stays";
  move(window(200, 100));
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{100, 0})) << "a pointer that passes turns nothing";
  EXPECT_FALSE(launcher.held());
}

TEST_F(AngleAndStrengthApart, ADragTurnsByWhatIsAcrossTheAim) {
  for (const carom::Vec2 from : {carom::Vec2{500, 200}, {60, 380}, {790, 10}}) {
    click(window(500, 200));
    drag(window(from.x, from.y), {0, -30});
    EXPECT_NEAR(launcher.aim.degrees(), 3, 0.01) << "its front goes up, too";
    EXPECT_NEAR(launcher.aim.speed(), 500, 0.1);
    drag(window(from.x, from.y), {0, 30});
    EXPECT_NEAR(launcher.aim.degrees(), 0, 0.01);
    drag(window(from.x, from.y), {30, 0});
    EXPECT_NEAR(launcher.aim.degrees(), 0, 0.01) << "along it";
  }
  stage.view.density = 3;
  click(window(500, 200));
  drag(window(500, 200), {0, -30});
  EXPECT_NEAR(launcher.aim.degrees(), 1, 0.01) << "points, not pixels";
}

TEST_F(AngleAndStrengthApart, TheFirstDragBeginsWhereTheKeysDo) {
  drag(window(500, 200), {0, -30});
  EXPECT_NEAR(launcher.aim.degrees(), 3, 0.01);
  EXPECT_NEAR(launcher.aim.speed(), 500, 0.1);
}

TEST_F(AngleAndStrengthApart, TheBarSetsTheStrengthAndTheButtonLaunches) {
  EXPECT_EQ(press(middle(stage.meter)), Launcher::Outcome::untouched) << "nothing is aimed";
  click(window(200, 300));
  press({stage.meter.x + 50, stage.meter.y + 5});
  EXPECT_NEAR(launcher.aim.speed(), 500, 0.06);
  move({stage.meter.x + 150, 300});
  release({stage.meter.x + 150, 300});
  EXPECT_NEAR(launcher.aim.speed(), 1500, 0.06);
  EXPECT_NEAR(launcher.aim.degrees(), 90, 0.01);
  EXPECT_TRUE(launcher.offers_shot(stage.way, false));
  EXPECT_EQ(press(middle(stage.shoot)), Launcher::Outcome::launch);
}

TEST_F(AngleAndStrengthApart, TheFieldMakesSmallSteps) {
  click(window(500, 200));
  drag(middle(stage.fine), {-40, 3});
  EXPECT_NEAR(launcher.aim.degrees(), 0.4, 0.01);
  EXPECT_NEAR(launcher.aim.speed(), 500, 0.1);
  drag(middle(stage.fine), {3, -40});
  EXPECT_NEAR(launcher.aim.degrees(), 0.4, 0.01);
  EXPECT_NEAR(launcher.aim.speed(), 540, 0.1);
  for (int i = 0; i < 40; ++i) click(middle(stage.fine) + Point{40, 0});
  EXPECT_NEAR(launcher.aim.degrees(), 0, 0.01);
  for (int i = 0; i < 40; ++i) click(middle(stage.fine) + Point{0, 15});
  EXPECT_NEAR(launcher.aim.speed(), 500, 0.1);
}

TEST_F(AngleAndStrengthApart, TheWheelAndKeysMakeSmallSteps) {
  click(window(500, 200));
  give(app::WheelTurned{10});
  EXPECT_NEAR(launcher.aim.degrees(), 0.1, 0.01);
  move(middle(stage.meter));
  give(app::WheelTurned{-10});
  EXPECT_NEAR(launcher.aim.speed(), 490, 0.1);
  for (int i = 0; i < 10; ++i) give(app::KeyPressed{Key::right, false, true});
  EXPECT_NEAR(launcher.aim.degrees(), 0, 0.01);
}

TEST_F(AngleAndStrengthApart, WhatIsTakenBackLeavesTheAimAsItWas) {
  press(window(500, 300));
  give(app::PointerCancelled{});
  EXPECT_FALSE(launcher.aim.active());
  click(window(200, 300));
  for (const Point at : {window(500, 200), middle(stage.meter), middle(stage.fine)}) {
    press(at);
    move(at + Point{30, 0});
    move(at + Point{60, 30});
    EXPECT_TRUE(launcher.held());
    give(app::PointerCancelled{});
    EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{0, 100}));
    EXPECT_FALSE(launcher.held());
  }
  EXPECT_EQ(key(Key::escape), Launcher::Outcome::taken);
  EXPECT_FALSE(launcher.aim.active());
}

TEST_F(AngleAndStrengthApart, APressWithin44PointsTakesTheLead) {
  for (const float density : {1.0f, 2.0f}) {
    stage.view = app::View::of(1280, 1000, density);
    press(lead + Point{0, 43 * density});
    move(lead + Point{-80 * density, 43 * density});
    EXPECT_EQ(launcher.stance(), Launcher::Stance::pulling);
    key(Key::escape);
    release(lead);
    press(lead + Point{0, 45 * density});
    EXPECT_EQ(launcher.stance(), Launcher::Stance::turning);
    give(app::PointerCancelled{});
  }
}

TEST_F(AngleAndStrengthApart, AClickOnTheLeadIsTheFirstOfTwo) {
  click(lead);
  move(lead + Point{60, 80});
  EXPECT_EQ(launcher.aim.drag(), (carom::Vec2{60, -80}));
  EXPECT_FALSE(launcher.offers_shot(stage.way, false));
  EXPECT_EQ(press(lead + Point{60, 80}), Launcher::Outcome::launch);
}

TEST_F(LauncherTest, SpaceHeldRunsTheStrengthUpAndDown) {
  stage.way = AimWay::turn;
  move(window(500, 200));
  EXPECT_EQ(key(Key::space), Launcher::Outcome::taken);
  ASSERT_TRUE(launcher.charging());
  for (int i = 0; i < 50; ++i) launcher.advance(10ms);
  EXPECT_NEAR(launcher.aim.speed(), 1000, 0.1);
  for (int i = 0; i < 125; ++i) launcher.advance(10ms);
  EXPECT_NEAR(launcher.aim.speed(), 1750, 12) << "up to the greatest and down again";
  give(app::KeyReleased{Key::space});
  EXPECT_FALSE(launcher.charging());
  const double speed = launcher.aim.speed();
  launcher.advance(1s);
  EXPECT_EQ(launcher.aim.speed(), speed);
  EXPECT_EQ(key(Key::enter), Launcher::Outcome::launch);
}

TEST_F(LauncherTest, AButtonUnderThePointerIsLeftAlone) {
  for (const AimWay way : {AimWay::clicks, AimWay::pull, AimWay::turn}) {
    launcher = Launcher();
    stage.way = way;
    stage.on_button = true;
    EXPECT_EQ(press(lead), Launcher::Outcome::untouched);
    EXPECT_FALSE(launcher.aim.active());
  }
}

template <class Screen>
class KeyboardOnly : public testing::Test {
 protected:
  KeyboardOnly() { screen.resize(view); }
  app::Navigation key(Key key) {
    return screen.event(*app::KeyBindings{}.meaning(app::KeyPressed{key}));
  }
  app::DrawList picture() {
    app::DrawList list;
    app::Canvas canvas{list, font, view};
    screen.draw(canvas);
    return list;
  }
  bool shows(std::string_view text) {
    for (const app::Box& box : picture().boxes)
      if (box.text.find(text) != std::string::npos) return true;
    return false;
  }
  app::View view = app::View::of(1280, 720);
  app::Atlas atlas;
  app::Font font{atlas};
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, app::shipped_levels()};
  Screen screen{app::Words(app::Language::en), session};
};
using Screens = testing::Types<app::BilliardsScreen, app::AngryBallsScreen>;

struct ScreenName {
  template <class Screen>
  static std::string GetName(int) {
    return std::is_same_v<Screen, app::BilliardsScreen> ? "Billiards" : "AngryBalls";
  }
};
TYPED_TEST_SUITE(KeyboardOnly, Screens, ScreenName);

TYPED_TEST(KeyboardOnly, AimsAndShoots) {
  EXPECT_TRUE(this->shows("Keys: arrows, Enter"));
  for (int i = 0; i < 3; ++i) this->key(Key::up);
  for (const char sign : std::string("12.5")) this->screen.event(app::TextTyped{{sign}});
  EXPECT_TRUE(this->shows("12.5")) << "in the field";
  this->key(Key::enter);
  EXPECT_TRUE(this->shows("12.5° · 26.5%"));
  this->key(Key::enter);
  const carom::Vec2 velocity = this->screen.game().world().ball(0).velocity;
  EXPECT_NEAR(carom::length(velocity), 530, 0.06);
  EXPECT_NEAR(std::atan2(velocity.y, velocity.x), 12.5 * 3.14159265 / 180, 1e-3);
}

TYPED_TEST(KeyboardOnly, ReachesTheButtonsByTabAndComesBackByArrows) {
  this->key(Key::left);
  this->key(Key::tab);
  this->key(Key::tab);  // settings, restart
  this->key(Key::up);
  EXPECT_TRUE(asks_for<app::Stay>(this->key(Key::enter))) << "the focus went back to the aim";
  EXPECT_GT(carom::length(this->screen.game().world().ball(0).velocity), 0);
}

TYPED_TEST(KeyboardOnly, TheFocusedButtonGetsEnter) {
  this->key(Key::left);
  for (int i = 0; i < 3; ++i) this->key(Key::tab);  // settings, restart, close
  const app::Navigation request = this->key(Key::enter);
  EXPECT_TRUE((std::is_same_v<TypeParam, app::BilliardsScreen>
                   ? asks_for<app::ShowTitle>(request)
                   : asks_for<app::ShowLevels>(request)));
}

TYPED_TEST(KeyboardOnly, APullThrowsWhatWasShown) {
  const carom::Vec2 at = this->screen.game().world().ball(0).position;
  const Point from = this->screen.viewport().to_window(at);
  this->screen.event(app::PointerPressed{from});
  this->screen.event(app::PointerMoved{from + Point{-60, 30}});
  EXPECT_TRUE(this->shows("26.6° · "));
  EXPECT_TRUE(this->shows("Let go to shoot"));
  this->screen.event(app::PointerReleased{from + Point{-60, 30}});
  const carom::Vec2 velocity = this->screen.game().world().ball(0).velocity;
  EXPECT_NEAR(velocity.y / velocity.x, 0.5, 1e-3);
  EXPECT_GT(velocity.x, 0);
}

TYPED_TEST(KeyboardOnly, TheStrengthRunsOnlyWhileSpaceIsHeld) {
  app::Settings turn_then_power;
  turn_then_power.aiming.way = AimWay::turn;
  this->session.settings.set(turn_then_power);
  this->key(Key::up);
  for (int i = 0; i < 500; ++i) this->screen.iterate(10ms);
  EXPECT_FALSE(this->screen.animating());
  this->key(Key::space);
  EXPECT_TRUE(this->screen.animating()) << "the picture changes by itself";
  this->screen.iterate(100ms);
  EXPECT_TRUE(this->shows("30.5%"));
  this->screen.event(app::KeyReleased{Key::space});
  EXPECT_FALSE(this->screen.animating());
}

}  // namespace
