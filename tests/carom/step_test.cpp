#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <rapidcheck/gtest.h>
#include <vector>

#include "carom/event.hpp"
#include "worlds.hpp"

namespace {

using carom::Event;
using carom::EventKind;
using carom::Vec2;
using carom::World;
using worlds::ball;
using worlds::level;
using worlds::make;
using worlds::table;

std::vector<Event> run(World& world, int steps) {
  std::vector<Event> all;
  for (int i = 0; i < steps; ++i) {
    const auto events = world.step();
    all.insert(all.end(), events.begin(), events.end());
  }
  return all;
}

int count(const std::vector<Event>& events, EventKind kind) {
  return static_cast<int>(std::ranges::count(events, kind, &Event::kind));
}

// A number in [low, high) with 20 bits of fineness.
rc::Gen<double> number(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1 << 20),
                      [=](int n) { return low + (high - low) * n / (1 << 20); });
}

rc::Gen<Vec2> vector(double low, double high) {
  return rc::gen::apply(
      [](double x, double y) {
        return Vec2{x, y};
      },
      number(low, high), number(low, high));
}

// §1.2.1: the speed after n steps is v·fⁿ and the path the geometric sum.
TEST(Move, FollowsTheClosedForm) {
  World world = make(table({ball({100, 200}, {300, 40})}));
  const double f = world.scene().friction;
  double factor = 1;
  for (int n = 1; n <= 200; ++n) {
    world.step();
    const double path = carom::time_step * (1 - factor * f) / (1 - f);
    factor *= f;
    EXPECT_NEAR(world.ball(0).velocity.x, 300 * factor, 1e-10);
    EXPECT_NEAR(world.ball(0).velocity.y, 40 * factor, 1e-10);
    EXPECT_NEAR(world.ball(0).position.x, 100 + 300 * path, 1e-9);
    EXPECT_NEAR(world.ball(0).position.y, 200 + 40 * path, 1e-9);
  }
}

TEST(Move, OneStepIsExact) {
  World world = make(table({ball({100, 200}, {300, -40})}));
  world.step();
  EXPECT_EQ(world.ball(0).position, (Vec2{100 + 300 * 0.01, 200 + -40 * 0.01}));
  EXPECT_EQ(world.ball(0).velocity, (Vec2{300 * 0.995, -40 * 0.995}));
}

// Spec §2: sub-steps keep a ball from moving further than its radius; friction acts once.
TEST(Move, SubStepsShareOneStepsFriction) {
  World world = make(table({ball({100, 200}, {4500, 0})}));  // 45 px a step: five parts
  world.step();
  const double h = carom::time_step / 5;
  double x = 100;
  for (int i = 0; i < 5; ++i) x += 4500 * h;
  EXPECT_EQ(world.ball(0).position.x, x);
  EXPECT_EQ(world.ball(0).velocity.x, 4500 * 0.995);
}

TEST(Move, AFastBallDoesNotPassThroughAnother) {
  World world = make(table({ball({20, 200}, {60'000, 0}), ball({400, 200})}));
  const auto events = run(world, 1);
  ASSERT_EQ(count(events, EventKind::pair), 1);
  EXPECT_LT(world.ball(0).position.x, world.ball(1).position.x);
}

// §1.2.2
TEST(Cushion, KeepsTheTangentialSpeedAndMirrorsTheNormal) {
  World world = make(table({ball({788, 200}, {400, 70})}));
  const auto events = run(world, 1);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::cushion);
  EXPECT_EQ(events[0].other, static_cast<unsigned>(carom::Side::right));
  EXPECT_EQ(world.ball(0).velocity, (Vec2{-400 * 0.995, 70 * 0.995}));
  EXPECT_EQ(events[0].deviation, (Vec2{-2 * (400 * 0.995), 0}));
  EXPECT_EQ(world.ball(0).position.x, 790);
}

TEST(Cushion, LeavesAPartingBallItsVelocity) {
  // The right ball is pushed into the cushion by a separation while it moves away from it.
  World world = make(table({ball({775, 200}), ball({789.9, 200}, {-50, 0})}));
  const auto events = run(world, 1);
  EXPECT_EQ(count(events, EventKind::cushion), 1);
  EXPECT_LE(world.ball(1).velocity.x, 0);
}

// §1.2.3
TEST(TwoBalls, AHeadOnShotPassesAllItsSpeedOn) {
  World world = make(table({ball({100, 200}, {500, 0}), ball({121, 200})}));
  const auto events = run(world, 1);
  ASSERT_EQ(count(events, EventKind::pair), 1);
  EXPECT_EQ(world.ball(0).velocity, (Vec2{0, 0}));
  EXPECT_EQ(world.ball(1).velocity, (Vec2{500 * 0.995, 0}));
  EXPECT_EQ(events[0].deviation, (Vec2{500 * 0.995, 0}));
  EXPECT_NEAR(carom::length(world.ball(1).position - world.ball(0).position), 1.01 * 20, 1e-12);
}

TEST(TwoBalls, AreSeparatedAboutTheWeightedMean) {
  World world = make(table({ball({100, 200}, {}, 5), ball({112, 200}, {}, 15)}));
  world.step();
  const double g = (15 * 100.0 + 5 * 112.0) / 20;
  EXPECT_DOUBLE_EQ(world.ball(0).position.x, g - 1.01 * 5);
  EXPECT_DOUBLE_EQ(world.ball(1).position.x, g + 1.01 * 15);
}

TEST(TwoBalls, WithOneCentrePartAlongX) {
  World world = make(table({ball({100, 200}), ball({100, 200})}));
  world.step();
  EXPECT_DOUBLE_EQ(world.ball(0).position.x, 100 - 10.1);
  EXPECT_DOUBLE_EQ(world.ball(1).position.x, 100 + 10.1);
}

TEST(TwoBalls, PartingAlreadyExchangeNothing) {
  World world = make(table({ball({100, 200}, {-30, 5}), ball({115, 200}, {40, 0})}));
  const auto events = run(world, 1);
  ASSERT_EQ(count(events, EventKind::pair), 1);
  EXPECT_EQ(events[0].deviation, (Vec2{0, 0}));
  EXPECT_EQ(world.ball(0).velocity, (Vec2{-30 * 0.995, 5 * 0.995}));
  EXPECT_EQ(world.ball(1).velocity, (Vec2{40 * 0.995, 0}));
}

RC_GTEST_PROP(TwoBalls, ConserveMomentumAndNeverGainEnergy, ()) {
  const Vec2 a = *vector(-500, 500);
  const Vec2 b = *vector(-500, 500);
  const Vec2 offset = *vector(-14, 14);
  World world = make(table({ball({400, 200}, a), ball(Vec2{400, 200} + offset, b, 9)}));
  const Vec2 before = (a + b) * 0.995;
  const double energy = carom::length_squared(a * 0.995) + carom::length_squared(b * 0.995);
  world.step();
  RC_ASSERT(carom::length(worlds::momentum(world) - before) < 1e-9);
  RC_ASSERT(worlds::energy(world) <= energy * (1 + 1e-12));
}

// §1.2.4
TEST(ThreeBalls, ShareTheEnergyOfASymmetricShot) {
  const double c = std::sqrt(3.0) / 2;
  // Just touching each other and, after the move, overlapped by the first ball from the left.
  World world = make(table(
      {ball({100, 200}, {300, 0}), ball({100 + 20.2 * c, 210.1}), ball({100 + 20.2 * c, 189.9})}));
  const auto events = run(world, 1);
  ASSERT_EQ(count(events, EventKind::pair), 3);
  EXPECT_EQ(events[0].ball, 0U);
  EXPECT_EQ(events[0].other, 1U);
  EXPECT_EQ(events[1].ball, 1U);
  EXPECT_EQ(events[1].other, 2U);
  EXPECT_EQ(events[2].ball, 0U);
  EXPECT_EQ(events[2].other, 2U);
  // The separations leave only a trace of asymmetry.
  EXPECT_NEAR(world.ball(1).velocity.x, world.ball(2).velocity.x, 15);
  EXPECT_NEAR(world.ball(1).velocity.y, -world.ball(2).velocity.y, 15);
  EXPECT_GT(world.ball(1).velocity.x, 80);
}

RC_GTEST_PROP(ThreeBalls, ConserveMomentumAndNeverGainEnergy, ()) {
  std::vector<carom::Ball> balls;
  for (int i = 0; i < 3; ++i)
    balls.push_back(ball(Vec2{400, 200} + *vector(-12, 12), *vector(-500, 500)));
  World world = make(table(balls));
  Vec2 before;
  double energy = 0;
  for (const auto& b : balls) {
    before += b.velocity * 0.995;
    energy += carom::length_squared(b.velocity * 0.995);
  }
  const auto events = run(world, 1);
  RC_PRE(!events.empty());
  RC_ASSERT(carom::length(worlds::momentum(world) - before) < 1e-9);
  RC_ASSERT(worlds::energy(world) <= energy * (1 + 1e-12));
}

TEST(Table, NeverGainsEnergyIn10000RandomSteps) {
  std::mt19937 random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  std::uint64_t collisions = 0;
  for (int round = 0; round < 10; ++round) {
    std::vector<carom::Ball> balls;
    for (int i = 0; i < 40; ++i)
      balls.push_back(ball({uniform(20, 780), uniform(20, 380)},
                           {uniform(-1000, 1000), uniform(-1000, 1000)}, uniform(4, 16)));
    carom::Scene scene = table(balls);
    scene.friction = 1;
    World world = make(scene);
    double energy = worlds::energy(world);
    for (int step = 0; step < 1000; ++step) {
      collisions += world.step().size();
      const double now = worlds::energy(world);
      ASSERT_LE(now, energy * (1 + 1e-13)) << "round " << round << " step " << step;
      energy = now;
    }
  }
  EXPECT_GT(collisions, 10'000U);
}

// §1.2.5
TEST(Hole, PullsByTheFormulaOfTheReport) {
  carom::Scene scene = table({ball({400 + 12, 200})});
  scene.holes = {{.position = {400, 200}, .radius = 16}};
  World world = make(scene);
  world.step();
  const double d = (16 - 12) / 10.0;
  EXPECT_DOUBLE_EQ(world.ball(0).acceleration.x, -100'000 * d * std::sqrt(1 - d * d));
  EXPECT_EQ(world.ball(0).acceleration.y, 0);
  EXPECT_EQ(world.ball(0).velocity, (Vec2{0, 0})) << "the pull acts in the next step's move";
  EXPECT_FALSE(world.at_rest()) << "a pulled ball is not at rest, however slow";
}

TEST(Hole, DoesNotPullABallWhoseCentreIsOutside) {
  carom::Scene scene = table({ball({416, 200})});
  scene.holes = {{.position = {400, 200}, .radius = 16}};
  World world = make(scene);
  world.step();
  EXPECT_EQ(world.ball(0).acceleration, (Vec2{0, 0}));
  EXPECT_TRUE(world.at_rest());
}

TEST(Hole, PocketsABallWhollyInside) {
  carom::Scene scene = table({ball({400 + 6, 200}), ball({100, 100}), ball({200, 100})});
  scene.holes = {{.position = {400, 200}, .radius = 16}};
  World world = make(scene);
  const auto events = run(world, 1);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::pocketed);
  EXPECT_EQ(events[0].ball, 0U);
  ASSERT_EQ(world.size(), 2U);
  EXPECT_EQ(world.ball(0).id, 2U) << "the last ball takes the free index";
  EXPECT_EQ(world.ball(1).id, 1U);
}

TEST(Hole, SmallerThanTheBallNeverPocketsButStaysFinite) {
  carom::Scene scene = table({ball({401, 200}), ball({400, 100})});
  scene.holes = {{.position = {400, 200}, .radius = 4}, {.position = {400, 100}, .radius = 4}};
  World world = make(scene);
  EXPECT_EQ(count(run(world, 2000), EventKind::pocketed), 0);
  EXPECT_TRUE(worlds::all_finite(world));
  EXPECT_EQ(world.ball(1).position, (Vec2{400, 100})) << "no pull at the centre";
}

RC_GTEST_PROP(Hole, TakesABallThatRollsSlowlyOverItsEdge, ()) {
  // Aimed to pass the hole's centre at up to 15 px, which is 1 px inside the edge.
  const Vec2 heading = carom::unit(*vector(-1, 1));
  const double offset = *number(-15, 15);
  const double speed = *number(25, 60);
  const Vec2 aside{-heading.y, heading.x};
  const Vec2 hole{400, 200};
  carom::Scene scene = table({ball(hole - 18.0 * heading + offset * aside, speed * heading)});
  scene.friction = 0.999;
  scene.holes = {{.position = hole, .radius = 16}};
  World world = make(scene);
  RC_ASSERT(count(run(world, 400), EventKind::pocketed) == 1);
}

TEST(Lead, KeepsItsIndexAndWaitsOutOfPlay) {
  carom::Scene scene = table({ball({400, 200}), ball({100, 100}), ball({200, 100}, {50, 0})});
  scene.balls[0].role = carom::Role::cue;
  scene.holes = {{.position = {400, 200}, .radius = 16}};
  World world = make(scene);
  run(world, 1);
  ASSERT_EQ(world.size(), 3U);
  EXPECT_FALSE(world.in_play(0));
  EXPECT_EQ(world.balls_left(), 2U);
  EXPECT_EQ(world.ball(1).id, 1U);

  EXPECT_TRUE(run(world, 5).empty()) << "a ball out of play takes part in nothing";
  const auto hash = world.state_hash();
  EXPECT_FALSE(world.set_velocity(0, {10, 0}));
  EXPECT_EQ(world.state_hash(), hash);

  ASSERT_TRUE(world.place_lead({300, 300}));
  EXPECT_TRUE(world.in_play(0));
  EXPECT_EQ(world.ball(0).position, (Vec2{300, 300}));
  EXPECT_TRUE(world.set_velocity(0, {10, 0}));
}

TEST(Lead, PlacedAfterItBrokeIsWholeAgain) {
  carom::Scene scene = table({ball({100, 200}, {1000, 0}), ball({400, 200})});
  scene.balls[0].role = carom::Role::cue;
  scene.balls[0].solidity = 500;
  World world = make(scene);
  ASSERT_EQ(count(run(world, 60), EventKind::destroyed), 1);
  ASSERT_FALSE(world.in_play(0));
  ASSERT_TRUE(world.place_lead({100, 100}));
  EXPECT_EQ(world.ball(0).solidity, 500);
}

TEST(Lead, PlacedAfterAShockKeepsTheWear) {
  carom::Scene scene = table({ball({100, 200}, {1000, 0}), ball({400, 200})});
  scene.balls[0].role = carom::Role::cue;
  scene.balls[0].solidity = 50000;
  World world = make(scene);
  run(world, 60);
  const double left = world.ball(0).solidity;
  ASSERT_LT(left, 50000);
  ASSERT_TRUE(world.place_lead({100, 100}));
  EXPECT_EQ(world.ball(0).solidity, left);
}

TEST(Lead, GoingOutDropsTheRemainingSubSteps) {
  carom::Scene scene = table({ball({380, 200}, {2000, 0}), ball({100, 100}, {1000, 0})});
  scene.balls[0].role = carom::Role::cue;
  scene.balls[0].radius = 4;  // five parts of 4 px
  scene.holes = {{.position = {392, 200}, .radius = 16}};
  World world = make(scene);
  const auto events = run(world, 1);
  ASSERT_EQ(count(events, EventKind::pocketed), 1);
  EXPECT_DOUBLE_EQ(world.ball(1).position.x, 100 + 1000 * carom::time_step / 5);
  EXPECT_EQ(world.ball(1).velocity.x, 1000) << "friction acts in the last part, which was dropped";
}

TEST(Lead, OnlyACueBallOrProjectileIsOne) {
  EXPECT_FALSE(make(table({ball({400, 200})})).has_lead());
  EXPECT_FALSE(make(table({})).has_lead());
}

// §2.2.1: o and v of the recurrence, summed by hand.
TEST(Gravity, AThrownBallFollowsTheClosedForm) {
  World world = make(level({ball({100, 200}, {200, 300})}));
  const double f = world.scene().friction;
  const double h = carom::time_step;
  // v(n) = fⁿ·v0 + (the pull from the second step on: −g·h·(1 + f + … + fⁿ⁻²)).
  double factor = 1;
  double y = 200;
  for (int n = 1; n <= 150; ++n) {
    const double pulls = n >= 2 ? (1 - factor / f) / (1 - f) : 0;
    const double vy_before = factor * 300 - 500 * h * (n >= 2 ? pulls : 0);
    y += vy_before * h;
    factor *= f;
    world.step();
    EXPECT_NEAR(world.ball(0).position.y, y, 1e-8) << n;
    EXPECT_NEAR(world.ball(0).velocity.x, 200 * factor, 1e-9);
  }
}

TEST(Support, ABallAtRestStaysForever) {
  carom::Scene scene = level({ball({100, 10}), ball({300, 10}), ball({300, 30}), ball({500, 142.1}),
                              ball({600, 10}), ball({620, 10})});
  scene.obstacles = {{.x = 500, .height = 120, .radius = 12}};
  World world = make(scene);
  run(world, 10);
  std::vector<carom::Ball> before;
  for (std::size_t i = 0; i < world.size(); ++i) before.push_back(world.ball(i));
  run(world, 10'000);
  for (std::size_t i = 0; i < world.size(); ++i) {
    EXPECT_EQ(world.ball(i).position, before[i].position) << i;
    EXPECT_EQ(world.ball(i).velocity, before[i].velocity) << i;
  }
  EXPECT_TRUE(world.at_rest());
}

// §2.2.3 to §2.2.5: what a shock costs.
carom::Ball fragile(carom::Ball made, double solidity) {
  made.solidity = solidity;
  return made;
}

const Event* find(const std::vector<Event>& events, EventKind kind) {
  const auto it = std::ranges::find(events, kind, &Event::kind);
  return it == events.end() ? nullptr : &*it;
}

TEST(Solidity, TheFloorCostsTwiceTheNormalSpeed) {
  World world = make(level({fragile(ball({100, 11}, {50, -200}), 3000)}));
  const auto events = run(world, 1);
  ASSERT_TRUE(find(events, EventKind::floor));
  ASSERT_TRUE(find(events, EventKind::damage));
  EXPECT_DOUBLE_EQ(find(events, EventKind::damage)->damage, 4 * 2 * 200 * 0.995);
  EXPECT_EQ(world.ball(0).solidity, 3000 - 4 * (2 * (200 * 0.995)));
}

TEST(Solidity, AWallCostsTwiceTheNormalSpeed) {
  carom::Scene scene = level({fragile(ball({470, 60}, {900, 0}), 10'000)});
  scene.obstacles = {{.x = 500, .height = 120, .radius = 12}};
  World world = make(scene);
  const auto events = run(world, 1);
  ASSERT_TRUE(find(events, EventKind::wall));
  EXPECT_EQ(world.ball(0).position.x, 500 - 22);
  EXPECT_EQ(world.ball(0).velocity.x, -900 * 0.995);
  EXPECT_DOUBLE_EQ(world.ball(0).solidity, 10'000 - 4 * 2 * 900 * 0.995);
}

TEST(Solidity, ACapMirrorsTheNormalPartAndCostsTwiceIt) {
  carom::Scene scene = level({fragile(ball({500, 143}, {0, -200}), 10'000)});
  scene.obstacles = {{.x = 500, .height = 120, .radius = 12}};
  World world = make(scene);
  const auto events = run(world, 1);
  ASSERT_TRUE(find(events, EventKind::cap));
  EXPECT_EQ(world.ball(0).velocity, (Vec2{0, 200 * 0.995}));
  EXPECT_DOUBLE_EQ(world.ball(0).position.y, 120 + 1.01 * 22);
  EXPECT_DOUBLE_EQ(world.ball(0).solidity, 10'000 - 4 * 2 * 200 * 0.995);
}

TEST(Solidity, APairCostsEachBallTheDeviation) {
  World world =
      make(table({fragile(ball({100, 200}, {500, 0}), 5000), fragile(ball({121, 200}), 6000)}));
  const auto events = run(world, 1);
  EXPECT_EQ(count(events, EventKind::damage), 2);
  EXPECT_DOUBLE_EQ(world.ball(0).solidity, 5000 - 4 * 500 * 0.995);
  EXPECT_DOUBLE_EQ(world.ball(1).solidity, 6000 - 4 * 500 * 0.995);
}

TEST(Solidity, AWeakShockCostsNothing) {
  carom::Scene scene = table({fragile(ball({100, 200}, {500, 0}), 5000), ball({121, 200})});
  scene.damage_threshold = 4 * 500;
  World world = make(scene);
  EXPECT_EQ(count(run(world, 1), EventKind::damage), 0);
  EXPECT_EQ(world.ball(0).solidity, 5000);
}

TEST(Solidity, AShockAtTheThresholdCounts) {
  carom::Scene scene = table({fragile(ball({100, 200}, {500, 0}), 5000), ball({121, 200})});
  scene.damage_threshold = 4 * 497.5;  // what this shock costs, exactly
  World world = make(scene);
  EXPECT_EQ(count(run(world, 1), EventKind::damage), 1);
}

TEST(Solidity, ABrokenBallDeviatesTheOtherTheLess) {
  World world = make(table({ball({100, 200}, {500, 0}), fragile(ball({121, 200}), 600)}));
  const auto events = run(world, 1);
  ASSERT_TRUE(find(events, EventKind::destroyed));
  ASSERT_EQ(world.size(), 1U);
  const double dv = 500 * 0.995;
  EXPECT_DOUBLE_EQ(world.ball(0).velocity.x, dv - 600 / (4 * dv) * dv);
}

TEST(Solidity, ZeroIsStillWhole) {
  World world = make(level({fragile(ball({100, 9.999 + 0.001}, {0, 0}), 0)}));
  run(world, 100);
  EXPECT_EQ(world.size(), 1U);
}

TEST(Solidity, AProjectilesIsInfiniteWhateverTheSceneSays) {
  carom::Scene scene = level({fragile(ball({100, 100}), 5)});
  scene.balls[0].role = carom::Role::projectile;
  EXPECT_EQ(make(scene).ball(0).solidity, carom::infinite_solidity);
}

TEST(OpenSide, RemovesABallThatIsWhollyOutsideAndNoOther) {
  World world = make(level({ball({795, 200}, {500, 0}), ball({100, 390}, {0, 900})}));
  std::vector<Event> events;
  int steps = 0;
  while (events.empty() && ++steps < 100) events = run(world, 1);
  ASSERT_EQ(count(events, EventKind::left), 1);
  EXPECT_EQ(events[0].ball, 0U);
  EXPECT_GT(events[0].position.x, 800 + 10) << "the whole ball is out";
  EXPECT_LT(events[0].position.x, 800 + 10 + 5) << "and has only just left";
  ASSERT_EQ(world.size(), 1U);
  EXPECT_EQ(world.ball(0).id, 1U) << "an open top removes nothing";
}

}  // namespace
