#include <gtest/gtest.h>

#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/staged.hpp"
#include "app/storage/alone_best.hpp"

namespace {

using app::Key;
using games::billiards::Options;
using games::billiards::Rack;

class NewGameTest : public testing::Test {
 protected:
  const games::billiards::Game& table() {
    return dynamic_cast<const app::BilliardsScreen&>(game.app().screen()).game();
  }
  app::MemoryStore store;
  Player game{app::Language::en, 1280, 720, {}, store};
};

TEST_F(NewGameTest, ThePlainGameIsTheReports) {
  game.press("Billiards");
  EXPECT_EQ(table().options(), Options{});
}

TEST_F(NewGameTest, WhatIsChosenIsPlayedAndOneTapPlaysItAgain) {
  game.press("…");
  ASSERT_TRUE(game.says("New game · Players: Two · Match: One game · Balls: Classic: 36"))
      << game.title();
  game.press("Balls");
  game.press("Score and play on");
  game.press("Hit a ball");
  EXPECT_TRUE(game.says("Balls: Quick: 15")) << game.title();
  game.press("Start");
  EXPECT_EQ(table().options(),
            (Options{.keep_turn = true, .touch_red = true, .rack = Rack::quick}));
  EXPECT_EQ(table().reds_left(), 15);
  game.leave();
  game.press("Billiards");
  EXPECT_EQ(table().reds_left(), 15);
  Player later(app::Language::en, 1280, 720, {}, store);
  later.press("Billiards");
  EXPECT_TRUE(later.says("balls left: 15")) << "and at the next start";
}

TEST_F(NewGameTest, ByKeysAlone) {
  game.key(Key::tab);
  game.key(Key::tab);
  game.key(Key::enter);
  ASSERT_TRUE(game.says("New game · "));
  for (int i = 0; i < 3; ++i) game.key(Key::tab);  // Start, Back, Players
  game.key(Key::enter);
  EXPECT_TRUE(game.says("Players: Computer · Level: 3"));
  game.key(Key::enter);
  EXPECT_TRUE(game.says("Players: Alone"));
  game.key(Key::escape);
  EXPECT_TRUE(game.says("title screen"));
  game.key(Key::enter);  // the focus is on "…"
  game.key(Key::enter);
  EXPECT_TRUE(table().options().alone);
}

TEST_F(NewGameTest, WhoPlaysAloneSeesShotsInThePlaceOfASecondPlayer) {
  app::Settings settings = game.app().settings().get();
  settings.seats = app::Seats::alone;
  settings.rack = Rack::quick;
  game.app().settings().set(settings);
  game.press("Billiards");
  EXPECT_TRUE(game.says("Shots: 0")) << game.title();
  EXPECT_FALSE(game.shows("Player 2"));
  const app::Point cue = game.app().screen().aim_prompt()->at;
  game.click(cue);
  game.click(cue - app::Point{60, 4});
  game.wait_for("aims");
  EXPECT_TRUE(game.says("Player 1 aims")) << game.title();
  EXPECT_TRUE(game.says("Shots: 1")) << game.title();
}

TEST_F(NewGameTest, AMissByTheHouseRuleIsToldAndGivesTheCueBallAway) {
  app::Settings settings = game.app().settings().get();
  settings.touch_red = true;
  game.app().settings().set(settings);
  game.press("Billiards");
  game.pass(std::chrono::seconds{3});
  const app::Point cue = game.app().screen().aim_prompt()->at;
  game.click(cue);
  game.click(cue - app::Point{30, 2});
  game.wait_for("Player 2 places");
  EXPECT_TRUE(game.shows("No ball touched")) << game.title();
}

/// A table with one red at a hole, alone.
TEST_F(NewGameTest, ClearingATableAloneEntersItsOwnBestList) {
  app::MemoryClipboard clipboard;
  app::Session session(store, clipboard, {});
  carom::Scene scene = games::billiards::rack(Rack::quick);
  scene.balls.resize(2);
  scene.balls[1].position = {40, 200};
  scene.holes = {{.position = {10, 200}}};
  auto played = games::billiards::Game::create(scene, {.rack = Rack::quick, .alone = true});
  Staged<app::BilliardsScreen> screen(app::Words(app::Language::en), session,
                                      app::BilliardsRecorder(std::move(played).value()));
  screen.resize(app::View::of(1280, 720));
  const app::Point cue = screen.viewport().to_window(screen.game().world().ball(0).position);
  for (const app::Point at : {cue, cue - app::Point{200, 0}}) {
    screen.event(app::PointerMoved{at});
    screen.event(app::PointerPressed{at});
    screen.event(app::PointerReleased{at});
  }
  for (int i = 0; i < 3000 && screen.game().phase() == games::billiards::Phase::roll; ++i)
    screen.iterate(std::chrono::milliseconds{10});
  ASSERT_EQ(screen.game().phase(), games::billiards::Phase::over);
  EXPECT_NE(screen.describe().find("Cleared · shots: 1"), std::string::npos) << screen.describe();
  EXPECT_EQ(session.alone.of({.rack = Rack::quick}), std::vector{1});
  EXPECT_TRUE(session.alone.of({}).empty());
}

TEST(AloneBest, KeepsTheFewestOfEachKindOfTable) {
  app::MemoryStore store;
  app::AloneBest best(store);
  const Options quick{.rack = Rack::quick};
  const Options strict{.touch_red = true};
  for (const int shots : {30, 20, 40, 25, 50}) EXPECT_GT(best.record(quick, shots), 0U);
  EXPECT_EQ(best.record(quick, 22), 2U);
  EXPECT_EQ(best.record(quick, 60), 0U);
  EXPECT_EQ(best.of(quick), (std::vector{20, 22, 25, 30, 40}));
  EXPECT_EQ(best.record(strict, 99), 1U);
  EXPECT_TRUE(best.of({}).empty());
  EXPECT_EQ(app::AloneBest(store).of(quick), best.of(quick));
}

TEST(AloneBest, TwoWindowsLoseNothing) {
  app::MemoryStore store;
  app::AloneBest one(store);
  app::AloneBest other(store);
  one.record({}, 50);
  other.record({}, 40);
  EXPECT_EQ(app::AloneBest(store).of({}), (std::vector{40, 50}));
}

TEST(AloneBest, WhatIsNoListIsSetAside) {
  for (const char* wrong : {"", "{", R"({"angry-balls-alone": 2, "shots": {}})",
                            R"({"angry-balls-alone": 1, "shots": {"quick": [-1]}})",
                            R"({"angry-balls-alone": 1, "shots": {"quick": [1, 2, 3, 4, 5, 6]}})",
                            R"({"angry-balls-alone": 1, "shots": {"quick": 1}})"}) {
    app::MemoryStore store;
    ASSERT_TRUE(store.save("alone.json", wrong));
    app::AloneBest best(store);
    EXPECT_TRUE(best.of({.rack = Rack::quick}).empty());
    EXPECT_EQ(store.load("alone.json.broken").value(), wrong);
    EXPECT_EQ(best.record({}, 7), 1U);
    EXPECT_EQ(app::AloneBest(store).of({}), std::vector{7});
  }
}

}  // namespace
