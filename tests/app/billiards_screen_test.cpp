#include "app/screens/billiards_screen.hpp"

#include <chrono>
#include <gtest/gtest.h>

#include "app/greedy_player.hpp"
#include "app/play/first_aim.hpp"
#include "app/staged.hpp"

namespace {

using namespace std::chrono_literals;
using games::billiards::Phase;

class BilliardsScreenTest : public testing::Test {
 protected:
  BilliardsScreenTest() { screen.resize(app::View::of(1280, 720)); }

  app::Navigation click(app::Point at, app::PointerButton button = app::PointerButton::left) {
    screen.event(app::PointerMoved{at});
    screen.event(app::PointerPressed{at, button});
    return screen.event(app::PointerReleased{at, button});
  }
  app::Navigation key(app::Key key) {
    return screen.event(*app::KeyBindings{}.meaning(app::KeyPressed{key}));
  }
  app::Point window(double x, double y) const { return screen.viewport().to_window({x, y}); }
  app::Point cue() const {
    return screen.viewport().to_window(screen.game().world().ball(0).position);
  }
  void shoot(greedy::Shot shot) {
    click(shot.grab);
    click(shot.target);
  }
  void watch() {
    while (screen.game().phase() == Phase::roll) screen.iterate(16'666'667ns);
  }
  /// Pockets the cue ball in the corner by a straight shot.
  void lose_cue_ball() {
    shoot({window(200, 200), window(10, 10)});
    watch();
  }
  app::DrawList picture() {
    app::DrawList list;
    const app::View view = app::View::of(1280, 720);
    app::Canvas canvas{list, font, view};
    screen.draw(canvas);
    return list;
  }
  bool shows(std::string_view text) {
    for (const app::Box& box : picture().boxes)
      if (box.text.find(text) != std::string::npos) return true;
    return false;
  }
  app::Point button(std::string_view text) {
    app::Rect area;  // of several the one on top
    for (const app::Box& box : picture().boxes)
      if (box.kind == app::Box::Kind::button && box.text == text) area = box.area;
    EXPECT_GT(area.w, 0) << "no button " << text;
    return area.center();
  }

  app::Atlas atlas;
  app::Font font{atlas};
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, {}};
  Staged<app::BilliardsScreen> screen{app::Words(app::Language::en), session};
};

TEST_F(BilliardsScreenTest, TwoClicksShoot) {
  click(cue());
  EXPECT_EQ(screen.game().phase(), Phase::aim);
  click(window(300, 250));
  EXPECT_EQ(screen.game().phase(), Phase::roll);
  const carom::Vec2 velocity = screen.game().world().ball(0).velocity;
  EXPECT_NEAR(velocity.x, 500, 1e-2);
  EXPECT_NEAR(velocity.y, 250, 1e-2);
}

/// On a phone held upright one shoots away from oneself, and up is up.
TEST_F(BilliardsScreenTest, AnUprightTableIsPlayedAsItIsSeen) {
  screen.resize(app::View::of(390, 844));
  lose_cue_ball();
  ASSERT_EQ(screen.game().phase(), Phase::place);
  screen.event(app::PointerMoved{window(200, 200)});
  for (int i = 0; i < 6; ++i) key(app::Key::up);
  key(app::Key::left);
  key(app::Key::enter);
  ASSERT_EQ(screen.game().phase(), Phase::aim);
  EXPECT_NEAR(cue().y, window(230, 200).y, 0.1f) << "30 px up";
  EXPECT_NEAR(cue().x, window(200, 205).x, 0.1f) << "5 px left";
  const app::Point at = cue();
  screen.event(app::PointerPressed{at});
  screen.event(app::PointerMoved{at + app::Point{0, 100}});
  screen.event(app::PointerReleased{at + app::Point{0, 100}});
  ASSERT_EQ(screen.game().phase(), Phase::roll);
  for (int i = 0; i < 10; ++i) screen.iterate(16'666'667ns);
  EXPECT_LT(cue().y, at.y - 20) << "pulled down, it goes up";
  EXPECT_NEAR(cue().x, at.x, 0.1f);
}

TEST_F(BilliardsScreenTest, DragStartsAtTheFirstClickNotAtTheBall) {
  click(window(205, 203));
  click(window(255, 203));
  EXPECT_NEAR(screen.game().world().ball(0).velocity.x, 250, 1e-2);
  EXPECT_NEAR(screen.game().world().ball(0).velocity.y, 0, 1e-2);
}

TEST_F(BilliardsScreenTest, AClickBesideTheCueBallOnlyTellsWhatToDo) {
  app::Settings settings;
  settings.aiming.way = app::AimWay::pull;
  session.settings.set(settings);
  click(window(400, 200));
  click(window(500, 200));
  EXPECT_EQ(screen.game().phase(), Phase::aim);
  EXPECT_TRUE(shows("Click the white cue ball first"));
  click(cue());
  EXPECT_TRUE(shows("Click where to send it"));
}

TEST_F(BilliardsScreenTest, EscapeAndRightClickTakeTheFirstClickBack) {
  click(cue());
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  click(window(300, 200));
  EXPECT_EQ(screen.game().phase(), Phase::aim);
  click(cue());
  click(window(300, 200), app::PointerButton::right);
  click(window(300, 200));
  EXPECT_EQ(screen.game().phase(), Phase::aim);
}

TEST_F(BilliardsScreenTest, ADoubleClickOnTheCueBallLosesNoTurn) {
  click(cue());
  click(cue());
  EXPECT_EQ(screen.game().phase(), Phase::aim);
  EXPECT_TRUE(shows("Too weak"));
}

TEST_F(BilliardsScreenTest, StrengthShowsInNumbersUpToTheCap) {
  click(cue());
  screen.event(app::PointerMoved{window(400, 200)});
  EXPECT_TRUE(shows("50.0%"));
  screen.event(app::PointerMoved{window(790, 200)});
  EXPECT_TRUE(shows("100.0% · max"));
}

TEST_F(BilliardsScreenTest, TheCueBallInHandIsPlacedWhereItIsFree) {
  lose_cue_ball();
  ASSERT_EQ(screen.game().phase(), Phase::place);
  EXPECT_EQ(screen.game().player(), 1);
  click(window(560, 200));  // among the reds
  EXPECT_EQ(screen.game().phase(), Phase::place);
  EXPECT_TRUE(shows("another ball is in the way"));
  click(window(400, 14));
  EXPECT_TRUE(shows("over a pocket"));
  click(window(100, 3));
  EXPECT_TRUE(shows("off the table"));
  click(window(300, 120));
  EXPECT_EQ(screen.game().phase(), Phase::aim);
}

TEST_F(BilliardsScreenTest, TheSameShotWhateverTheFrameRate) {
  const auto hash_after = [&](std::chrono::nanoseconds frame) {
    app::BilliardsScreen other{app::Words(app::Language::en), session};
    other.resize(app::View::of(1280, 720));
    for (const app::Point at : {window(200, 200), window(560, 230)}) {
      other.event(app::PointerPressed{at});
      other.event(app::PointerReleased{at});
    }
    while (other.game().phase() == Phase::roll) other.iterate(frame);
    return other.game().world().state_hash();
  };
  const auto reference = hash_after(10ms);
  EXPECT_EQ(hash_after(16'666'667ns), reference);
  EXPECT_EQ(hash_after(4'166'667ns), reference);
  EXPECT_EQ(hash_after(500ms), reference);
}

TEST_F(BilliardsScreenTest, AFreshGameIsLeftWithoutAsking) {
  EXPECT_TRUE(asks_for<app::ShowTitle>(click(button("Leave"))));
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  EXPECT_TRUE(asks_for<app::ShowTitle>(click(button("Leave"))));
}

TEST_F(BilliardsScreenTest, EscapeFirstLeavesTheFocus) {
  shoot({cue(), window(300, 200)});
  watch();
  key(app::Key::tab);
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::escape)));
  EXPECT_TRUE(asks_for<app::ShowTitle>(click(button("Leave"))));
}

TEST_F(BilliardsScreenTest, TheFirstTabIsOnTheGear) {
  key(app::Key::tab);
  EXPECT_TRUE(asks_for<app::Stay>(key(app::Key::enter)));
  EXPECT_NE(screen.describe().find("paused: "), std::string::npos);
  EXPECT_TRUE(asks_for<app::ShowSettings>(click(button("Settings"))));
}

TEST_F(BilliardsScreenTest, KeysStartToAimAtTheNearestRed) {
  // Far beyond all reds: the middle of the table is no good aim.
  const auto world = [&]() -> const carom::World& { return screen.game().world(); };
  for (int turn = 0; turn < 12 && screen.game().phase() != Phase::over; ++turn) {
    if (screen.game().phase() == Phase::place)
      click(greedy::choose_place(screen.game(), screen.viewport()));
    key(app::Key::up);
    ASSERT_TRUE(screen.aimed());
    const carom::Vec2 cue_at = world().ball(0).position;
    const carom::Vec2 red = app::nearest(world(), carom::Role::red, cue_at, {});
    const carom::Vec2 way = screen.aimed()->drag();
    EXPECT_GT(carom::dot(carom::unit(way), carom::unit(red - cue_at)), 0.99) << turn;
    key(app::Key::escape);
    shoot({cue(), {cue().x + (turn % 2 == 0 ? 300.0f : -300.0f), cue().y + 40.0f}});
    watch();
  }
}

TEST_F(BilliardsScreenTest, AStartedGameIsGivenUpOnlyAfterAQuestion) {
  shoot({cue(), window(300, 200)});
  watch();
  const auto steps = screen.game().world().steps();
  click(button("Restart"));
  EXPECT_FALSE(screen.animating());
  click(button("Keep playing"));
  EXPECT_EQ(screen.game().world().steps(), steps);
  click(button("Restart"));
  click(button("New game"));
  EXPECT_EQ(screen.game().world().steps(), 0u);
  shoot({cue(), window(300, 200)});
  screen.iterate(50ms);
  EXPECT_TRUE(asks_for<app::ShowTitle>(click(button("Leave"))));
}

TEST_F(BilliardsScreenTest, TheTableWaitsWhileAQuestionIsOpen) {
  shoot({cue(), window(500, 200)});
  screen.iterate(50ms);
  const auto steps = screen.game().world().steps();
  key(app::Key::r);
  screen.iterate(50ms);
  EXPECT_EQ(screen.game().world().steps(), steps);
  key(app::Key::escape);
  screen.iterate(50ms);
  EXPECT_GT(screen.game().world().steps(), steps);
}

TEST_F(BilliardsScreenTest, AWholeGameToTheEndAndAgain) {
  int turns = 0;
  for (; screen.game().phase() != Phase::over && turns < 1000; ++turns) {
    if (screen.game().phase() == Phase::place)
      click(greedy::choose_place(screen.game(), screen.viewport()));
    ASSERT_EQ(screen.game().phase(), Phase::aim);
    shoot(greedy::choose_shot(screen.game(), screen.viewport(), 3));
    ASSERT_EQ(screen.game().phase(), Phase::roll);
    watch();
  }
  ASSERT_EQ(screen.game().phase(), Phase::over) << "after " << turns << " turns";
  EXPECT_EQ(screen.game().reds_left(), 0);
  const auto winner = screen.game().winner();
  EXPECT_TRUE(shows(!winner ? "draw" : *winner == 0 ? "Player 1 wins" : "Player 2 wins"));
  while (screen.animating()) screen.iterate(16'666'667ns);
  // The window of the end shows the rules' counts.
  const auto& [first, second] = std::pair{screen.game().tally(0), screen.game().tally(1)};
  EXPECT_EQ(first.balls + second.balls, games::billiards::reds);
  EXPECT_EQ(first.shots + second.shots, turns);
  for (const auto& tally : {first, second})
    for (const std::int64_t count : {std::int64_t{tally.balls}, tally.best_turn,
                                     std::int64_t{tally.shots}, std::int64_t{tally.fouls}})
      EXPECT_TRUE(shows(app::Words(app::Language::en).number(count)));

  app::Settings settings;
  settings.breaks = app::Breaks::alternate;
  session.settings.set(settings);
  click(button("Restart"));
  EXPECT_EQ(screen.game().phase(), Phase::aim);
  EXPECT_EQ(screen.game().player(), 1) << "who did not break in the last game";
  EXPECT_EQ(screen.game().reds_left(), games::billiards::reds);
  EXPECT_EQ(screen.game().score(0), 0);
}

}  // namespace
