#include "games/angry_balls.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "games/level_check.hpp"

namespace {

using carom::Vec2;
using games::angry_balls::Event;
using games::angry_balls::EventKind;
using games::angry_balls::Game;
using games::angry_balls::Next;
using games::angry_balls::Phase;
using games::angry_balls::Restart;
using games::angry_balls::Throw;

carom::Ball ball(carom::Role role, Vec2 position, double solidity = carom::infinite_solidity) {
  carom::Ball made;
  made.role = role;
  made.position = position;
  made.solidity = solidity;
  return made;
}

/// A projectile at (100, 100), a weak enemy on the floor at x = 400, open sides.
carom::Scene level() {
  carom::Scene scene;
  scene.edges = {.left = carom::Edge::open,
                 .right = carom::Edge::open,
                 .bottom = carom::Edge::solid,
                 .top = carom::Edge::open};
  scene.gravity = 500;
  scene.balls = {ball(carom::Role::projectile, {100, 100}),
                 ball(carom::Role::enemy, {400, 10}, 500)};
  return scene;
}

Game start(const carom::Scene& scene) { return Game::create(scene).value(); }

std::vector<Event> fly(Game& game) {
  std::vector<Event> all;
  while (game.phase() == Phase::fly) {
    game.step();
    all.insert(all.end(), game.events().begin(), game.events().end());
  }
  return all;
}

constexpr Throw away{{-400, 0}};  // out by the left side
constexpr Throw at_enemy{{200, -45}};

TEST(AngryBalls, RefusesASceneThatIsNotALevel) {
  carom::Scene scene = level();
  scene.balls[0].role = carom::Role::neutral;
  EXPECT_FALSE(Game::create(scene));
  scene = level();
  scene.balls[1].role = carom::Role::neutral;
  EXPECT_FALSE(Game::create(scene));
  scene = level();
  scene.friction = 0;
  EXPECT_FALSE(Game::create(scene));
}

TEST(AngryBalls, StandsStillUntilTheThrow) {
  carom::Scene scene = level();
  scene.balls[1].position.y = 200;  // in the air
  Game game = start(scene);
  for (int i = 0; i < 10; ++i) game.step();
  EXPECT_EQ(game.world().steps(), 0U);
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.throws_left(), 3);
}

TEST(AngryBalls, RefusesCommandsThatThePhaseDoesNotAllow) {
  Game game = start(level());
  EXPECT_FALSE(game.apply(Next{}));
  EXPECT_FALSE(game.apply(Throw{{0, 0}}));
  ASSERT_TRUE(game.apply(away));
  EXPECT_FALSE(game.apply(away));
  EXPECT_FALSE(game.apply(Next{})) << "not offered yet";
  EXPECT_EQ(game.throws_left(), 2);
}

TEST(AngryBalls, WinsAsSoonAsNoEnemyIsLeft) {
  Game game = start(level());
  ASSERT_TRUE(game.apply(at_enemy));
  const auto events = fly(game);
  ASSERT_EQ(game.phase(), Phase::won);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, EventKind::scored);
  EXPECT_EQ(events[0].points, 100);
  EXPECT_EQ(events[0].ball, 1U);
  EXPECT_NEAR(events[0].position.x, 400, 15) << "where it was made";
  EXPECT_EQ(events[1].kind, EventKind::won);
  EXPECT_EQ(game.score(), 100);
  EXPECT_FALSE(game.apply(at_enemy));
}

TEST(AngryBalls, LosesWhenTheThirdThrowIsOver) {
  Game game = start(level());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(game.phase(), Phase::aim);
    ASSERT_TRUE(game.apply(away));
    fly(game);
    ASSERT_EQ(game.phase(), Phase::offer) << "the player decides when a throw is over";
    ASSERT_TRUE(game.apply(Next{}));
  }
  EXPECT_EQ(game.phase(), Phase::lost);
  EXPECT_EQ(game.enemies_left(), 1);
  EXPECT_FALSE(game.apply(away));
}

TEST(AngryBalls, EventsOfACommandComeOutLikeThoseOfAStep) {
  carom::Scene scene = level();
  scene.throws = 2;
  Game game = start(scene);
  const auto kinds = [&] {
    std::vector<EventKind> all;
    for (const Event& event : game.events()) all.push_back(event.kind);
    return all;
  };
  using Kinds = std::vector<EventKind>;
  ASSERT_TRUE(game.apply(away));
  EXPECT_EQ(kinds(), Kinds{});
  fly(game);
  EXPECT_EQ(kinds(), Kinds{EventKind::offered});
  EXPECT_FALSE(game.apply(away));
  EXPECT_EQ(kinds(), Kinds{EventKind::offered}) << "refused, so nothing has happened";
  ASSERT_TRUE(game.apply(Next{}));
  EXPECT_EQ(kinds(), Kinds{}) << "an offer is told once";
  EXPECT_TRUE(game.physics_events().empty());
  ASSERT_TRUE(game.apply(away));
  fly(game);
  ASSERT_TRUE(game.apply(Next{}));
  EXPECT_EQ(kinds(), Kinds{EventKind::lost});
  EXPECT_TRUE(game.physics_events().empty());
  game.step();
  EXPECT_EQ(kinds(), Kinds{}) << "lost once";
}

TEST(AngryBalls, AProjectileThatLeavesComesBackAtTheNextThrow) {
  Game game = start(level());
  ASSERT_TRUE(game.apply(away));
  fly(game);
  EXPECT_FALSE(game.world().in_play(0));
  EXPECT_EQ(game.score(), 0) << "the projectile makes no points";
  ASSERT_TRUE(game.apply(Next{}));
  EXPECT_TRUE(game.world().in_play(0));
  EXPECT_EQ(game.world().ball(0).position, (Vec2{100, 100}));
  EXPECT_EQ(game.world().ball(0).velocity, (Vec2{0, 0}));
}

TEST(AngryBalls, TheLevelGoesOnMovingAfterTheOffer) {
  carom::Scene scene = level();
  scene.balls.push_back(ball(carom::Role::neutral, {300, 300}));
  Game game = start(scene);
  ASSERT_TRUE(game.apply(Throw{{-0.1, 0}}));  // all is slow for the first steps of the fall
  fly(game);
  ASSERT_EQ(game.phase(), Phase::offer);
  const double height = game.world().ball(2).position.y;
  for (int i = 0; i < 50; ++i) game.step();
  EXPECT_EQ(game.phase(), Phase::offer);
  EXPECT_LT(game.world().ball(2).position.y, height - 30);
}

TEST(AngryBalls, OffersTheNextThrowAfter30SecondsWhateverMoves) {
  carom::Scene scene = level();
  scene.friction = 1;
  scene.edges.left = scene.edges.right = carom::Edge::solid;
  scene.balls[1].solidity = carom::infinite_solidity;
  Game game = start(scene);
  ASSERT_TRUE(game.apply(at_enemy));  // bounces for ever
  fly(game);
  EXPECT_EQ(game.phase(), Phase::offer);
  EXPECT_EQ(game.world().steps(), games::angry_balls::offer_steps);
  EXPECT_FALSE(game.world().at_rest());
}

TEST(AngryBalls, TheIthBallOfATurnMakes100TimesI) {
  carom::Scene scene = level();
  // Two that the projectile hits before the enemy; whatever breaks lets it go on the slower.
  for (const double x : {340.0, 375.0})
    scene.balls.push_back(ball(carom::Role::neutral, {x, 10}, 50));
  Game game = start(scene);
  ASSERT_TRUE(game.apply(Throw{{200, -60}}));
  std::int64_t points = 0;
  int balls = 0;
  while (game.phase() == Phase::fly) {
    game.step();
    for (const Event& event : game.events()) {
      if (event.kind != EventKind::scored) continue;
      EXPECT_EQ(event.points, 100 * ++balls);
      points += event.points;
    }
    EXPECT_EQ(game.score(), points) << "counted up as it happens";
  }
  EXPECT_GE(balls, 2) << "one ball does not tell 100·i from 100";
}

TEST(AngryBalls, EveryThrowCountsFrom100Anew) {
  carom::Scene scene = level();
  scene.balls[1].position.x = 700;  // out of this
  for (const double x : {300.0, 400.0})
    scene.balls.push_back(ball(carom::Role::neutral, {x, 10}, 50));
  Game game = start(scene);
  std::vector<std::int64_t> points;
  for (const Throw shot : {at_enemy, Throw{{200, -80}}, Throw{{100, -40}}, Throw{{100, -60}}}) {
    if (game.phase() == Phase::offer) {
      ASSERT_TRUE(game.apply(Next{}));
    }
    if (game.phase() != Phase::aim) break;
    ASSERT_TRUE(game.apply(shot));
    EXPECT_EQ(game.turn_balls(), 0);
    int in_turn = 0;
    for (const Event& event : fly(game)) {
      if (event.kind != EventKind::scored) continue;
      EXPECT_EQ(event.points, 100 * ++in_turn);
      points.push_back(event.points);
    }
  }
  EXPECT_GE(std::ranges::count(points, 100), 2) << "only one throw scored";
}

TEST(AngryBalls, ALevelMayAllowMoreThrowsOrFewer) {
  carom::Scene scene = level();
  scene.throws = 1;
  Game game = start(scene);
  ASSERT_TRUE(game.apply(away));
  fly(game);
  ASSERT_TRUE(game.apply(Next{}));
  EXPECT_EQ(game.phase(), Phase::lost);
}

TEST(AngryBalls, RestartsAtAnyTime) {
  Game game = start(level());
  const auto fresh = game.world().state_hash();
  ASSERT_TRUE(game.apply(at_enemy));
  fly(game);
  ASSERT_TRUE(game.apply(Restart{}));
  EXPECT_EQ(game.phase(), Phase::aim);
  EXPECT_EQ(game.world().state_hash(), fresh);
  EXPECT_EQ(game.score(), 0);
  EXPECT_EQ(game.throws_left(), 3);
}

std::vector<std::string> pointers(const carom::Errors& errors) {
  std::vector<std::string> all;
  for (const carom::Error& error : errors) all.push_back(error.pointer);
  return all;
}

using Pointers = std::vector<std::string>;

TEST(LevelWarnings, AreNoneForAGoodLevel) {
  EXPECT_EQ(pointers(games::angry_balls::level_warnings(level())), Pointers{});
}

TEST(LevelWarnings, TellOfBallsThatDoNotStay) {
  carom::Scene scene = level();
  scene.balls.push_back(ball(carom::Role::neutral, {300, 200}));      // in the air
  scene.balls.push_back(ball(carom::Role::neutral, {600, 300}, 10));  // breaks when it falls
  EXPECT_EQ(pointers(games::angry_balls::level_warnings(scene)),
            (Pointers{"/balls/2", "/balls/3", ""}))
      << "the last: the indestructible ball bounces for longer than 30 s";
}

TEST(LevelWarnings, TellOfBallsOnTheLaunchPlace) {
  carom::Scene scene = level();
  scene.balls.push_back(ball(carom::Role::neutral, {100, 10}));
  scene.balls[0].position.y = 25;
  EXPECT_EQ(pointers(games::angry_balls::level_warnings(scene)), (Pointers{"/balls/2"}));
}

TEST(LevelWarnings, TellOfEnemiesNobodyCanHurt) {
  carom::Scene scene = level();
  scene.width = 2000;
  scene.balls[0].position.x = 50;
  scene.edges = {};  // closed in
  scene.balls[1].position.x = 1950;
  scene.obstacles = {{.x = 1900, .height = 1500, .radius = 12}};
  scene.height = 1500;
  EXPECT_EQ(pointers(games::angry_balls::level_warnings(scene)), (Pointers{"/balls/1"}));

  scene = level();
  scene.edges.left = scene.edges.right = carom::Edge::solid;
  scene.balls[1].solidity = carom::infinite_solidity;
  EXPECT_EQ(pointers(games::angry_balls::level_warnings(scene)), (Pointers{"/balls/1"}));
}

TEST(LevelWarnings, TellOfASolidityOfTheProjectile) {
  carom::Scene scene = level();
  scene.balls[0].solidity = 7;
  EXPECT_EQ(pointers(games::angry_balls::level_warnings(scene)), (Pointers{"/balls/0/solidity"}));
}

}  // namespace
