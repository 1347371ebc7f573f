#include "search/review.hpp"

#include <gtest/gtest.h>

#include "games/launch.hpp"

namespace {

using search::Game;
using search::PlayedTurn;
using search::Question;
using search::Reviewing;
using search::TurnReview;

/// A red at (500, 360) that a straight shot from (200, 200) misses.
games::billiards::Game table() {
  carom::Scene scene = games::billiards::rack();
  scene.balls.resize(1);
  for (const carom::Vec2 red :
       {carom::Vec2{500, 360}, carom::Vec2{640, 120}, carom::Vec2{560, 200}})
    scene.balls.push_back({.role = carom::Role::red, .position = red});
  return games::billiards::Game::create(scene).value();
}

TurnReview review_of(const Game& game, const PlayedTurn& turn, const Question& question,
                     int threads = 1, std::uint64_t slice = 1000) {
  carom::Rollouts rollouts(threads);
  Reviewing reviewing = Reviewing::create(game, turn, question).value();
  while (!reviewing.done()) reviewing.advance(slice, rollouts);
  return reviewing.review();
}

constexpr Question steady{
    .hand = {.error = 3}, .budget = {.simulations = 200, .fresh = 200}, .seed = 2};

TEST(Review, OfAWastedTurn_BlamesTheDecisionAndNotLuck) {
  const TurnReview review = review_of(table(), {.drag = {-20, 0}}, steady);
  EXPECT_EQ(review.made, 0);
  EXPECT_EQ(review.played_value.mean, 0);
  EXPECT_EQ(review.played_value.n, 200U);
  EXPECT_GT(review.best_value.low, 20);
  EXPECT_EQ(review.decision(), review.best_value.mean);
  EXPECT_EQ(review.luck(), 0);
}

TEST(Review, OfTheBestShotFound_BlamesHardlyAnything) {
  const Game game = table();
  const TurnReview found = review_of(game, {.drag = {-20, 0}}, steady);
  const TurnReview review = review_of(game, {.drag = search::drag(found.best.aim)}, steady);
  EXPECT_LT(review.decision(), 25);
  EXPECT_NEAR(review.luck(), static_cast<double>(review.made) - found.best_value.mean, 40);
}

TEST(Review, OfAnExactShotThatScores_HasNoLuck) {
  const Game game = table();
  const Question exact{.budget = {.simulations = 200, .fresh = 5}, .seed = 1};
  const TurnReview found = review_of(game, {.drag = {-20, 0}}, exact);
  const TurnReview review = review_of(game, {.drag = search::drag(found.best.aim)}, exact);
  EXPECT_GT(review.made, 0);
  EXPECT_EQ(review.decision(), 0);
  EXPECT_EQ(review.luck(), 0);
}

TEST(Review, InSlicesAndByMoreThreads_IsTheSame) {
  const PlayedTurn turn{.drag = {200, 30}};
  const TurnReview once = review_of(table(), turn, steady);
  const TurnReview sliced = review_of(table(), turn, steady, 3, 11);
  EXPECT_EQ(sliced.best, once.best);
  EXPECT_EQ(sliced.best_value, once.best_value);
  EXPECT_EQ(sliced.played_value, once.played_value);
}

TEST(Review, OfWhatTheGameWouldNotTake_IsRefused) {
  const Game game = table();
  EXPECT_FALSE(Reviewing::create(game, {.drag = {0, 0}}, steady).ok());
  EXPECT_FALSE(
      Reviewing::create(game, {.place = carom::Vec2{300, 300}, .drag = {9, 0}}, steady).ok());
  EXPECT_FALSE(Reviewing::create(game, {.drag = {9, 0}}, {.budget = {.fresh = 0}}).ok());
}

}  // namespace
