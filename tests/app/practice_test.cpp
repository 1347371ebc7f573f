#include "app/play/practice.hpp"

#include "app/greedy_player.hpp"
#include "app/player.hpp"
#include "app/screens/angry_balls_screen.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/staged.hpp"
#include "games/launch.hpp"

namespace {

using namespace std::chrono_literals;
using app::Change;
using app::Key;

TEST(Practice, ChangesAThrowByOnePixelASecondOrATenthOfADegree) {
  app::Aim aim;
  aim.set({60, 80});
  const double start = aim.degrees();
  for (int i = 0; i < 10; ++i) app::change(aim, Change::faster);
  EXPECT_NEAR(aim.speed(), 510, 0.06);
  for (int i = 0; i < 20; ++i) app::change(aim, Change::slower);
  EXPECT_NEAR(aim.speed(), 490, 0.06);
  for (int i = 0; i < 10; ++i) app::change(aim, Change::left);
  EXPECT_NEAR(aim.degrees(), start + 1, 0.01);
  for (int i = 0; i < 20; ++i) app::change(aim, Change::right);
  EXPECT_NEAR(aim.degrees(), start - 1, 0.01);
}

class PracticeTable : public testing::Test {
 protected:
  PracticeTable() { screen.resize(app::View::of(1280, 720)); }
  void click(app::Point at) {
    screen.event(app::PointerPressed{at});
    screen.event(app::PointerReleased{at});
  }
  void shoot(double x, double y) {
    const carom::Vec2 cue = screen.game().world().ball(0).position;
    click(screen.viewport().to_window(cue));
    click(screen.viewport().to_window(cue + carom::Vec2{x, y}));
  }
  void key(Key key) { screen.event(*app::KeyBindings{}.meaning(app::KeyPressed{key})); }
  std::uint64_t hash() const { return screen.game().world().state_hash(); }
  void watch() {
    while (screen.game().phase() == games::billiards::Phase::roll) screen.iterate(10ms);
  }
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, {}};
  app::BilliardsScreen screen{app::Words(app::Language::en), session,
                              app::BilliardsScreen::Mode::practice};
};

TEST_F(PracticeTable, TakesShotsBackBitByBitAndRepeatsThem) {
  std::vector<std::uint64_t> before;
  std::vector<int> players;
  for (const carom::Vec2 drag : {carom::Vec2{-37, 11}, {300, 20}, {-50, 90}}) {
    if (screen.game().phase() != games::billiards::Phase::aim) break;
    before.push_back(hash());
    players.push_back(screen.game().player());
    shoot(drag.x, drag.y);
    ASSERT_EQ(screen.game().phase(), games::billiards::Phase::roll);
    watch();
  }
  const std::uint64_t after = hash();
  const std::int64_t score = screen.game().score(0) + screen.game().score(1);
  key(Key::r);  // takes back and shoots again
  watch();
  EXPECT_EQ(hash(), after);
  EXPECT_EQ(screen.game().score(0) + screen.game().score(1), score);
  key(Key::backspace);
  EXPECT_EQ(hash(), before.back());
  key(Key::r);
  screen.iterate(100ms);
  key(Key::backspace);  // in the middle
  for (std::size_t i = before.size(); i-- > 0; key(Key::backspace)) {
    EXPECT_EQ(hash(), before[i]);
    EXPECT_EQ(screen.game().player(), players[i]);
    EXPECT_EQ(screen.game().phase(), games::billiards::Phase::aim);
  }
  EXPECT_EQ(hash(), before.front()) << "nothing more to take back";
}

TEST_F(PracticeTable, RepeatsWithASmallChange) {
  shoot(-37, 11);
  const carom::Vec2 first = screen.game().world().ball(0).velocity;
  watch();
  const auto degrees = [](carom::Vec2 v) { return std::atan2(v.y, v.x) * 180 / std::acos(-1.0); };
  key(Key::backspace);  // the shot taken back is aimed again
  key(Key::up);
  key(Key::left);
  key(Key::enter);
  const carom::Vec2 second = screen.game().world().ball(0).velocity;
  EXPECT_NEAR(carom::length(second), carom::length(first) + 10, 0.12);
  EXPECT_NEAR(degrees(second), degrees(first) + 1, 0.05);
  // While it rolls, the buttons change what R repeats.
  app::Atlas atlas;
  app::Font font{atlas};
  app::DrawList list;
  const app::View view = app::View::of(1280, 720);
  app::Canvas canvas{list, font, view};
  screen.draw(canvas);
  for (const app::Box& box : list.boxes)
    if (box.kind == app::Box::Kind::button && box.text == "+1 px/s") click(box.area.center());
  key(Key::r);
  EXPECT_NEAR(carom::length(screen.game().world().ball(0).velocity), carom::length(second) + 1,
              0.12);
}

TEST_F(PracticeTable, TabReachesEveryButton) {
  const auto start = hash();
  shoot(-37, 11);
  watch();
  const auto after = hash();
  ASSERT_NE(after, start);
  for (int i = 0; i < 4; ++i) key(Key::tab);  // Settings, Restart, Close, Take back
  key(Key::enter);
  EXPECT_EQ(hash(), start);
  key(Key::tab);
  key(Key::space);  // Repeat
  watch();
  EXPECT_EQ(hash(), after);
  for (int i = 0; i < 3; ++i) key(Key::back_tab);
  key(Key::enter);  // Restart
  EXPECT_EQ(hash(), start);
}

TEST_F(PracticeTable, KeysTakeBackAndRepeatAtTheEndToo) {
  auto before = hash();
  for (int turns = 0; screen.game().phase() != games::billiards::Phase::over; ++turns) {
    ASSERT_LT(turns, 1000);
    if (screen.game().phase() == games::billiards::Phase::place)
      click(greedy::choose_place(screen.game(), screen.viewport()));
    before = hash();
    const auto shot = greedy::choose_shot(screen.game(), screen.viewport(), 3);
    click(shot.grab);
    click(shot.target);
    watch();
  }
  const auto end = hash();
  key(Key::r);
  EXPECT_EQ(screen.game().phase(), games::billiards::Phase::roll);
  watch();
  EXPECT_EQ(hash(), end);
  EXPECT_EQ(screen.game().phase(), games::billiards::Phase::over);
  key(Key::backspace);
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(screen.game().phase(), games::billiards::Phase::aim);
}

TEST_F(PracticeTable, NothingToRepeatAtFirst) {
  const auto start = hash();
  for (const Key which : {Key::r, Key::backspace, Key::up, Key::left}) key(which);
  EXPECT_EQ(hash(), start);
  EXPECT_EQ(screen.game().phase(), games::billiards::Phase::aim);
}

TEST(PracticeLevel, TakesThrowsBackAndKeepsNoScore) {
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  carom::Scene level;
  level.width = 1000;
  level.height = 500;
  level.gravity = 600;
  level.balls = {{.role = carom::Role::projectile, .position = {100, 12}, .radius = 12},
                 {.role = carom::Role::enemy, .position = {300, 12}, .radius = 12, .solidity = 10}};
  app::Session session{store, clipboard, {app::level_of(level)}};
  session.campaign.practice = true;
  Staged<app::AngryBallsScreen> screen(app::Words(app::Language::en), session);
  screen.resize(app::View::of(1000, 720));
  const auto key = [&](Key which) {
    screen.event(*app::KeyBindings{}.meaning(app::KeyPressed{which}));
  };
  const auto hash = [&] { return screen.game().world().state_hash(); };
  const auto throw_by = [&](float x) {
    const app::Point at = screen.viewport().to_window({100, 12});
    for (const app::Point p : {at, at + app::Point{x, 0}}) {
      screen.event(app::PointerPressed{p});
      screen.event(app::PointerReleased{p});
    }
  };
  const auto start = hash();
  throw_by(150);
  for (int i = 0; i < 1000; ++i) screen.iterate(10ms);
  EXPECT_EQ(screen.game().phase(), games::angry_balls::Phase::won);
  EXPECT_FALSE(session.campaign.best.of(session.campaign.levels[0].identity));
  EXPECT_TRUE(store.list("").empty());
  EXPECT_FALSE(store.load("scores.json").value());
  key(Key::tab);
  key(Key::tab);  // Play again, Take back
  key(Key::enter);
  EXPECT_EQ(hash(), start);
  EXPECT_EQ(screen.game().phase(), games::angry_balls::Phase::aim);
  EXPECT_EQ(screen.game().throws_left(), 3);
  EXPECT_EQ(screen.game().score(), 0);
  key(Key::r);
  EXPECT_EQ(screen.game().phase(), games::angry_balls::Phase::fly);
  key(Key::backspace);
  EXPECT_EQ(hash(), start);

  // The keys do the same in the window of the end, and before it opens.
  for (const auto wait : {3000ms, 0ms}) {
    key(Key::r);
    while (screen.game().phase() == games::angry_balls::Phase::fly) screen.iterate(10ms);
    ASSERT_EQ(screen.game().phase(), games::angry_balls::Phase::won);
    for (auto time = 0ms; time < wait; time += 10ms) screen.iterate(10ms);
    key(Key::r);
    EXPECT_EQ(screen.game().phase(), games::angry_balls::Phase::fly);
    while (screen.game().phase() == games::angry_balls::Phase::fly) screen.iterate(10ms);
    key(Key::backspace);
    EXPECT_EQ(hash(), start);
    EXPECT_EQ(screen.game().phase(), games::angry_balls::Phase::aim);
  }
}

}  // namespace
