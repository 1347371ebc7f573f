#include "search/search.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "games/launch.hpp"
#include "project_file.hpp"

namespace {

using games::billiards::Phase;
using search::Answer;
using search::Game;
using search::Question;
using search::Search;

Search started(const Game& game, const Question& question) {
  return Search::create(game, question).value();
}

Answer answer_of(const Game& game, const Question& question, int threads = 1,
                 std::uint64_t slice = 1000) {
  carom::Rollouts rollouts(threads);
  Search search = started(game, question);
  while (!search.done()) search.advance(slice, rollouts);
  return search.answer();
}

void expect_equal(const Answer& a, const Answer& b) {
  EXPECT_EQ(a.simulations, b.simulations);
  ASSERT_EQ(a.ranked.size(), b.ranked.size());
  for (std::size_t i = 0; i < a.ranked.size(); ++i) {
    EXPECT_EQ(a.ranked[i].shot, b.ranked[i].shot) << i;
    EXPECT_EQ(a.ranked[i].fresh, b.ranked[i].fresh) << i;
  }
}

/// The usual table with the cue ball at (200, 200) and these reds.
games::billiards::Game table(const std::vector<carom::Vec2>& reds) {
  carom::Scene scene = games::billiards::rack();
  scene.balls.resize(1);
  for (const carom::Vec2 red : reds)
    scene.balls.push_back({.role = carom::Role::red, .position = red});
  return games::billiards::Game::create(scene).value();
}

const std::vector<carom::Vec2> few{{500, 150}, {650, 300}, {600, 210}, {300, 320}, {420, 90}};

games::angry_balls::Game level(const std::string& name) {
  const std::string json = project_file("levels/" + name + ".json");
  return games::angry_balls::Game::create(games::angry_balls::read_level(json).value()).value();
}

/// A game in which the cue ball has just fallen.
games::billiards::Game with_ball_in_hand() {
  games::Random random(1);
  for (;;) {
    games::billiards::Game game = table(few);
    (void)game.apply(
        games::billiards::Shoot{{random.uniform(-400, 400), random.uniform(-400, 400)}});
    while (game.phase() == Phase::roll) game.step();
    if (game.phase() == Phase::place) return game;
  }
}

TEST(Search, ByEveryNumberOfThreadsAndInSlices_GivesTheSameAnswer) {
  for (const Game& game : {Game(table(few)), Game(with_ball_in_hand()), Game(level("06-skittles"))})
    for (const double error : {0.0, 4.0}) {
      const Question question{.hand = {.error = error},
                              .budget = {.simulations = 100, .fresh = 17, .shown = 3},
                              .seed = 5};
      const Answer once = answer_of(game, question);
      EXPECT_EQ(once.ranked.size(), 3U);
      for (const int threads : {1, 2, 5})
        for (const std::uint64_t slice : {1U, 7U, 64U})
          expect_equal(answer_of(game, question, threads, slice), once);
    }
}

TEST(Search, WithAnotherSeed_LooksAtOtherShots) {
  const Game game = table(few);
  const Answer one = answer_of(game, {.budget = {.simulations = 64}, .seed = 1});
  const Answer two = answer_of(game, {.budget = {.simulations = 64}, .seed = 2});
  EXPECT_NE(one.ranked[0].shot, two.ranked[0].shot);
}

TEST(Search, OfABudget_PlaysItAndTheFreshOnesAndNoMore) {
  for (const std::uint64_t simulations : {1U, 2U, 3U, 30U, 500U})
    for (const double error : {0.0, 4.0}) {
      const Answer answer =
          answer_of(table({{700, 360}}),
                    {.hand = {.error = error}, .budget = {.simulations = simulations, .fresh = 5}});
      const std::uint64_t fresh = error > 0 ? 5 : 0;
      EXPECT_LE(answer.simulations, simulations + fresh);
      // What does not divide evenly is left.
      EXPECT_GE(answer.simulations, simulations * 8 / 10 + fresh);
      ASSERT_EQ(answer.ranked.size(), 1U);
      EXPECT_EQ(answer.ranked[0].fresh.n, error > 0 ? 5U : 1U);
    }
}

TEST(Search, ByAnExactHand_PromisesWhatTheGameThenPays) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    games::billiards::Game game = seed % 2 == 0 ? with_ball_in_hand() : table(few);
    const Answer answer = answer_of(game, {.budget = {.simulations = 60}, .seed = seed});
    const auto& best = answer.ranked.at(0);
    const int player = game.player();
    if (best.shot.place) {
      ASSERT_TRUE(game.apply(games::billiards::Place{*best.shot.place}).ok());
    }
    ASSERT_TRUE(game.apply(games::billiards::Shoot{search::drag(best.shot.aim)}).ok());
    while (game.phase() == Phase::roll) game.step();
    EXPECT_EQ(game.score(player), best.fresh.points);
    EXPECT_GT(best.fresh.points, 0);
  }
}

TEST(Search, OfMoreSimulations_FindsMorePoints) {
  std::int64_t sums[2] = {};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    sums[0] +=
        answer_of(table(few), {.budget = {.simulations = 10}, .seed = seed}).ranked[0].fresh.points;
    sums[1] += answer_of(table(few), {.budget = {.simulations = 300}, .seed = seed})
                   .ranked[0]
                   .fresh.points;
  }
  EXPECT_GT(sums[1], sums[0] * 3 / 2);
}

// Found with seeds of its own, the shot is worth on average what the fresh simulations say.
TEST(Search, ByAnErringHand_TellsWhatTheShotIsWorthInLaterShots) {
  const Game game = table(few);
  const search::Hand hand{.error = 3};
  const Answer answer =
      answer_of(game, {.hand = hand, .budget = {.simulations = 200, .fresh = 400}, .seed = 3});
  const search::Record& fresh = answer.ranked[0].fresh;
  EXPECT_EQ(fresh.n, 400U);
  search::Record later;
  games::Random random(99);
  const carom::Vec2 meant = search::drag(answer.ranked[0].shot.aim);
  for (int i = 0; i < 400; ++i) {
    carom::World world = search::world_of(game);
    later.add(search::simulate(world, {}, search::launched(meant, hand, random)));
  }
  // The 95 % intervals of two such estimates are almost never apart.
  EXPECT_LT(fresh.points_estimate().low, later.points_estimate().high);
  EXPECT_GT(fresh.points_estimate().high, later.points_estimate().low);
}

TEST(Search, ByAnErringHand_FindsBetterThanTheShotOfTheLuckiestTrial) {
  const Game game = table(few);
  const auto value = [&](const search::Shot& shot) {
    search::Record record;
    for (std::uint64_t i = 0; i < 300; ++i) {
      games::Random random = search::random_of(7, search::Use::fresh, i);
      carom::World world = search::world_of(game);
      record.add(search::simulate(world, {},
                                  search::launched(search::drag(shot.aim), {.error = 6}, random)));
    }
    return record.points;
  };
  std::int64_t halving = 0;
  std::int64_t lucky = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    halving +=
        value(answer_of(game, {.hand = {.error = 6}, .budget = {.simulations = 150}, .seed = seed})
                  .ranked[0]
                  .shot);
    lucky += value(answer_of(game, {.budget = {.simulations = 150}, .seed = seed}).ranked[0].shot);
  }
  EXPECT_GT(halving, lucky);
}

TEST(Search, OfALevel_FindsAThrowThatClearsIt) {
  games::angry_balls::Game game = level("01-first-steps");
  const Answer answer = answer_of(game, {.budget = {.simulations = 200}, .seed = 1});
  EXPECT_EQ(answer.ranked.at(0).fresh.cleared, 1U);
  ASSERT_TRUE(game.apply(games::angry_balls::Throw{search::drag(answer.ranked[0].shot.aim)}).ok());
  while (game.phase() == games::angry_balls::Phase::fly) game.step();
  EXPECT_EQ(game.phase(), games::angry_balls::Phase::won);
}

TEST(Search, OfTheFirstEightLevels_ClearsEachByOneThrow) {
  for (const char* name :
       {"01-first-steps", "02-two-towers", "03-pass-it-on", "04-off-the-back-wall",
        "05-over-the-wall", "06-skittles", "07-the-pit", "08-sentinels"}) {
    const Answer answer = answer_of(level(name), {.budget = {.simulations = 1000}, .seed = 1});
    EXPECT_EQ(answer.ranked.at(0).fresh.cleared, 1U) << name;
  }
}

TEST(Search, WithTheBallInHand_PlacesItWhereTheGameTakesIt) {
  const games::billiards::Game game = with_ball_in_hand();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Answer answer =
        answer_of(game, {.hand = {.error = 5}, .budget = {.simulations = 20}, .seed = seed});
    ASSERT_TRUE(answer.ranked.at(0).shot.place.has_value());
    const carom::Vec2 place = *answer.ranked[0].shot.place;
    EXPECT_EQ(game.obstruction(place), games::billiards::Obstruction::none);
    EXPECT_EQ(place, games::on_grid(place));
  }
}

TEST(Search, WhereNoPointIsToBeMade_StillMeetsABall) {
  const games::billiards::Game rack;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Answer answer = answer_of(rack, {.budget = {.simulations = 4}, .seed = seed});
    EXPECT_EQ(answer.ranked.at(0).fresh.touched, 1U) << seed;
  }
}

TEST(Search, CutShort_AnswersWithAShotAsFarAsItCame) {
  carom::Rollouts rollouts(1);
  const Game game = table(few);
  for (const double error : {0.0, 4.0}) {
    Search search = started(game, {.hand = {.error = error}, .budget = {.simulations = 100}});
    EXPECT_TRUE(search.answer().ranked.empty());
    for (int i = 0; i < 30; ++i) {
      search.advance(3, rollouts);
      EXPECT_EQ(search.answer().ranked.size(), 1U);
      EXPECT_EQ(search.simulated(), 3U * static_cast<unsigned>(i + 1));
    }
    EXPECT_FALSE(search.done());
  }
}

TEST(Search, OfSeveralShots_ShowsNoTwoAlike) {
  const Answer answer =
      answer_of(table(few), {.budget = {.simulations = 400, .shown = 6}, .seed = 1});
  ASSERT_EQ(answer.ranked.size(), 6U);
  for (std::size_t i = 1; i < answer.ranked.size(); ++i) {
    EXPECT_LE(answer.ranked[i].fresh.points, answer.ranked[i - 1].fresh.points);
    const search::Aim& a = answer.ranked[i].shot.aim;
    const search::Aim& b = answer.ranked[i - 1].shot.aim;
    EXPECT_TRUE(std::abs(a.tenths - b.tenths) >= 10 || std::abs(a.speed - b.speed) >= 50);
  }
}

TEST(Search, OfWhatCannotBeAsked_IsRefused) {
  const Game game = table(few);
  EXPECT_FALSE(Search::create(game, {.budget = {.simulations = 0}}).ok());
  EXPECT_FALSE(Search::create(game, {.budget = {.shown = 0}}).ok());
  EXPECT_FALSE(Search::create(game, {.hand = {.error = -1}}).ok());
  EXPECT_FALSE(Search::create(game, {.hand = {.error = 0.0 / 0.0}}).ok());
  games::billiards::Game rolling = table(few);
  ASSERT_TRUE(rolling.apply(games::billiards::Shoot{{100, 0}}).ok());
  EXPECT_FALSE(Search::create(Game(rolling), {}).ok());
  EXPECT_FALSE(Search::create(Game(table({})), {}).ok()) << "the game is over";
}

TEST(Candidates, OfTablesAndLevels_AreTakenByTheGame) {
  for (const Game& game : {Game(table(few)), Game(games::billiards::Game()),
                           Game(with_ball_in_hand()), Game(level("05-over-the-wall"))}) {
    search::Candidates candidates(game, games::Random(4));
    ASSERT_TRUE(candidates.possible());
    for (int i = 0; i < 300; ++i) {
      search::Shot shot = candidates.next();
      if (i % 3 == 0) shot = candidates.near(shot, 20, 100);
      EXPECT_GT(shot.aim.tenths, -1800);
      EXPECT_LE(shot.aim.tenths, 1800);
      EXPECT_GE(shot.aim.speed, search::least_speed);
      EXPECT_LE(shot.aim.speed, search::greatest_speed);
      Game taken = game;
      if (auto* billiards = std::get_if<games::billiards::Game>(&taken)) {
        EXPECT_EQ(shot.place.has_value(), billiards->phase() == Phase::place);
        if (shot.place) {
          EXPECT_TRUE(billiards->apply(games::billiards::Place{*shot.place}).ok());
        }
        EXPECT_TRUE(billiards->apply(games::billiards::Shoot{search::drag(shot.aim)}).ok());
      }
    }
  }
}

}  // namespace
