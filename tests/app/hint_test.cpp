// Hints: the ball, the way, the aim with its odds.

#include "app/play/hint.hpp"

#include <gtest/gtest.h>

#include "app/hud/hint_view.hpp"
#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"

namespace {

using namespace std::chrono_literals;
using app::Hint;
using app::Key;
using games::billiards::Phase;

Hint found(const search::Game& game, double error, app::nanoseconds frame = 16ms) {
  carom::Rollouts rollouts;
  Hint hint = Hint::begin(game, error).value();
  while (hint.searching()) hint.advance(frame, rollouts);
  return hint;
}

TEST(Hint, OfTheSameGameAndHand_IsTheSameInEverySlice) {
  const search::Game rack = games::billiards::Game({.rack = games::billiards::Rack::quick});
  const Hint once = found(rack, 2, 1ms);
  const Hint again = found(rack, 2, 1s);
  EXPECT_EQ(once.shot().shot, again.shot().shot);
  EXPECT_EQ(once.shot().fresh, again.shot().fresh);
  EXPECT_EQ(once.shot().fresh.n, 1000U) << "of simulations that did not choose it";
}

TEST(Hint, IsToldInThreeSteps) {
  Hint hint = found(games::billiards::Game(), 0);
  const app::Words words(app::Language::en);
  EXPECT_FALSE(hint.tells(Hint::Step::way));
  ASSERT_TRUE(hint.ball());
  EXPECT_EQ(app::hint_in_words(words, hint, false), "Play at the ringed one.");
  hint.more();
  EXPECT_TRUE(hint.tells(Hint::Step::way));
  EXPECT_FALSE(hint.tells(Hint::Step::aim));
  for (int i = 0; i < 3; ++i) hint.more();
  EXPECT_TRUE(hint.tells(Hint::Step::aim));
  EXPECT_NE(app::hint_in_words(words, hint, false).find("points if exact"), std::string::npos);
}

TEST(Hint, WhileTheBallsRoll_IsNone) {
  games::billiards::Game game;
  ASSERT_TRUE(game.apply(games::billiards::Shoot{{-100, 0}}));
  EXPECT_FALSE(Hint::begin(game, 2));
}

struct HintScreen : testing::Test {
  Player game{app::Language::en, 1280, 720};
  const games::billiards::Game& table() {
    return dynamic_cast<const app::BilliardsScreen&>(game.app().screen()).game();
  }
  void hint() {
    game.key(Key::h);
    for (int i = 0; i < 600 && game.shows("Looking for a good shot"); ++i) game.pass(16ms);
  }
};

TEST_F(HintScreen, ByTheKey_EndsWithAnAimThatCanBeShot) {
  game.press("Billiards");
  hint();
  EXPECT_TRUE(game.shows("Play at the ringed one."));
  hint();
  EXPECT_TRUE(game.shows("Play this way."));
  EXPECT_EQ(table().phase(), Phase::aim);
  hint();
  EXPECT_TRUE(game.shows("with your hand (2 px) scores in"));
  game.key(Key::enter);
  EXPECT_EQ(table().phase(), Phase::roll);
  EXPECT_FALSE(game.shows("with your hand"));
}

TEST_F(HintScreen, ByTheButton_AsLongAsNothingIsAimed) {
  game.press("Billiards");
  game.press("Hint");
  EXPECT_TRUE(game.shows("Looking for a good shot"));
  EXPECT_EQ(table().phase(), Phase::aim);
  game.key(Key::up);
  EXPECT_FALSE(game.offers("Hint"));
  EXPECT_TRUE(game.offers("Shoot"));
}

TEST_F(HintScreen, ExactHand_IsToldAsPoints) {
  app::Settings settings = game.app().settings().get();
  settings.hand = app::Steadiness::exact;
  game.app().settings().set(settings);
  game.press("Billiards");
  for (int i = 0; i < 3; ++i) hint();
  EXPECT_TRUE(game.shows("points if exact"));
}

TEST_F(HintScreen, InALevel_TellsHowOftenItClears) {
  game.press("Angry Balls");
  game.press("First steps");
  for (int i = 0; i < 3; ++i) hint();
  EXPECT_TRUE(game.shows("with your hand (2 px) clears in")) << game.title();
}

}  // namespace
