// The review of a game of billiards.

#include <gtest/gtest.h>

#include "app/play/game_review.hpp"
#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/screens/replay_screen.hpp"
#include "project_file.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using app::GameReview;
using app::Key;

replay::Replay left_in_the_middle() {
  return replay::read_replay(project_file("tests/replays/billiards-left-in-the-middle.json"))
      .value();
}

TEST(GameReview, OfAGame_ReviewsEveryShotInItsOrder) {
  const replay::Replay game = left_in_the_middle();
  carom::Rollouts rollouts;
  GameReview review = GameReview::begin(game, 4).value();
  for (int i = 0; i < 100'000 && !review.done(); ++i) review.advance(16ms, 1000, rollouts);
  ASSERT_TRUE(review.done());
  ASSERT_EQ(review.shots().size(), review.all());
  const auto verified = replay::verify(game).value();
  for (std::size_t i = 0; i + 1 < review.all(); ++i) {
    EXPECT_EQ(review.shots()[i].player, verified.turns()[i].player);
    EXPECT_EQ(review.shots()[i].review.made, verified.turns()[i].points) << i;
    EXPECT_GE(review.shots()[i].review.decision(), 0) << i;
  }
  const auto costliest = review.costliest(3);
  ASSERT_FALSE(costliest.empty());
  for (const GameReview::Shot& shot : review.shots())
    EXPECT_LE(shot.review.decision(), review.shots()[costliest[0]].review.decision());
}

TEST(GameReview, OfALevel_IsNone) {
  EXPECT_FALSE(GameReview::begin(
      replay::read_replay(project_file("tests/replays/level-06-won.json")).value(), 4));
}

/// From the end of a game to a shot in its replay, and back.
TEST(ReviewScreen, AfterAGame_LeadsToAShotAndBack) {
  app::MemoryStore store;
  Player game(app::Language::en, 1280, 720, {}, store);
  app::Settings settings = game.app().settings().get();
  settings.seats = app::Seats::computer;
  settings.breaks = app::Breaks::player_2;
  game.app().settings().set(settings);
  game.press("Billiards");
  game.wait_for("Player 1 aims");
  game.key(Key::escape);
  for (int i = 0; i < 2; ++i) game.press("Resign");
  game.press("Review");
  EXPECT_TRUE(game.says("Review · 0 of 1 shots")) << game.title();
  game.wait_for("1 of 1 shots");
  EXPECT_TRUE(game.shows("Shot 1 · decision −"));
  EXPECT_FALSE(game.app().animating());
  game.press("Shot 1");
  game.pass(1s);
  EXPECT_TRUE(game.says("Turn 1 of 1")) << game.title();
  EXPECT_TRUE(game.says("paused")) << game.title();
  game.key(Key::escape);
  EXPECT_TRUE(game.says("Review · ")) << game.title();
  game.key(Key::escape);
  EXPECT_TRUE(game.says("Computer 3 wins")) << game.title();
}

}  // namespace
