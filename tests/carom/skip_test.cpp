#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "carom/event.hpp"
#include "carom/world.hpp"
#include "random_worlds.hpp"
#include "worlds.hpp"

// Steps in which surely nothing meets are passed over: the bits are those of a world that tests
// every step.

namespace {

using carom::Event;
using carom::Scene;
using carom::Vec2;
using carom::World;
using random_worlds::Numbers;

World tested(World world) {
  world.set_skipping(false);
  return world;
}

/// Takes the same steps one by one with both; what differs first, in words, or nothing.
std::string step_by_step(World& skips, World& tests, int steps) {
  for (int step = 1; step <= steps; ++step) {
    const auto expected = tests.step();
    if (!std::ranges::equal(skips.step(), expected))
      return "other events in step " + std::to_string(tests.steps());
    if (skips.state_hash() != tests.state_hash())
      return "another state after step " + std::to_string(tests.steps());
    if (skips.at_rest() != tests.at_rest()) return "one rests";
  }
  return {};
}

using Told = std::vector<std::pair<std::uint64_t, Event>>;

/// Runs both until rest at once; the same.
std::string at_once(World& skips, World& tests, std::uint64_t steps) {
  Told told;
  Told expected;
  const auto into = [](Told& list) {
    return [&list](std::uint64_t step, std::span<const Event> events) {
      for (const Event& event : events) list.emplace_back(step, event);
    };
  };
  const carom::RunEnd end = skips.run({.rest = true}, steps, into(told));
  std::uint64_t taken = 0;
  for (; taken < steps && !tests.at_rest(); ++taken) {
    const auto events = tests.step();
    into(expected)(tests.steps(), events);
  }
  if (end.steps != taken) return "another number of steps";
  if (told != expected) return "other events, or in other steps";
  if (skips.state_hash() != tests.state_hash()) return "another state in the end";
  return {};
}

std::string difference(const Scene& scene, int steps) {
  World skips = worlds::make(scene);
  World tests = tested(skips);
  World runs = skips;
  World stays = tests;
  if (std::string found = step_by_step(skips, tests, steps); !found.empty()) return found;
  return at_once(runs, stays, static_cast<std::uint64_t>(steps));
}

Vec2 direction(Numbers& n) {
  for (;;) {
    const Vec2 d{n.uniform(-1, 1), n.uniform(-1, 1)};
    if (carom::length_squared(d) > 0.01 && carom::length_squared(d) < 1) return carom::unit(d);
  }
}

const std::vector<carom::Hole> six_holes{{{10, 10}, 16},  {{400, 10}, 16},  {{790, 10}, 16},
                                         {{10, 390}, 16}, {{400, 390}, 16}, {{790, 390}, 16}};

/// A table with a cue ball and reds that do not overlap.
Scene table(Numbers& n, std::size_t count, bool holes) {
  Scene scene;
  if (holes) scene.holes = six_holes;
  while (scene.balls.size() < count) {
    carom::Ball ball;
    ball.role = scene.balls.empty() ? carom::Role::cue : carom::Role::red;
    ball.radius = scene.balls.empty() ? 8 : 10;
    ball.position = {n.uniform(30, 770), n.uniform(30, 370)};
    if (std::ranges::none_of(scene.balls, [&](const carom::Ball& other) {
          return carom::length(other.position - ball.position) < ball.radius + other.radius;
        }))
      scene.balls.push_back(ball);
  }
  scene.balls[0].velocity = n.uniform(200, 2000) * direction(n);
  return scene;
}

std::size_t below(Numbers& n, std::size_t end) { return static_cast<std::size_t>(n.below(end)); }

#ifdef NDEBUG
constexpr std::uint64_t times = 4;
#else
constexpr std::uint64_t times = 1;
#endif

TEST(Skipping, GivesTheSameBitsInRandomWorlds) {
  for (std::uint64_t seed = 0; seed < 400 * times; ++seed)
    ASSERT_EQ(difference(random_worlds::scene(seed, seed % 10 == 0 ? 70 : 12), 60), "")
        << "seed " << seed;
}

TEST(Skipping, GivesTheSameBitsOnTables) {
  Numbers n(1);
  for (std::uint64_t shot = 0; shot < 6 * times; ++shot)
    for (const std::size_t count : {2U, 4U, 8U, 16U, 37U}) {
      Scene scene = table(n, count, n.one_in(2));
      const double speed = n.one_in(4) ? n.uniform(2000, 90'000) : n.uniform(100, 2000);
      if (n.one_in(3)) scene.friction = n.one_in(2) ? n.uniform(0.05, 0.97) : n.uniform(0.97, 1);
      if (n.one_in(4)) scene.friction = 1;
      if (n.one_in(5)) scene.edges.left = scene.edges.top = carom::Edge::open;
      if (n.one_in(6)) scene.hole_pull = n.one_in(2) ? 0 : 1e9;
      scene.balls[0].velocity = speed * direction(n);
      ASSERT_EQ(difference(scene, 1500), "") << "shot " << shot << ", " << count << " balls";
    }
}

// The clock's tables are searched from a guess, which is poor where balls hardly get slower.
TEST(Skipping, GivesTheSameBitsAtFrictionsNearOneAndZero) {
  Numbers n(8);
  for (const double friction :
       {1 - 1e-3, 1 - 1e-4, 1 - 1e-5, 1 - 1e-7, 1 - 1e-10, 1 - 1e-16, 0.5, 1e-3, 1e-9, 1e-300}) {
    Scene scene = table(n, 8, true);
    scene.friction = friction;
    ASSERT_EQ(difference(scene, 1500), "") << friction;
  }
}

TEST(Skipping, GivesTheSameBitsInGases) {
  Numbers n(2);
  for (std::uint64_t k = 0; k < 5 * times; ++k) {
    Scene scene = table(n, 2 + below(n, 60), n.one_in(3));
    scene.friction = n.one_in(2) ? 1 : n.uniform(0.99, 1);
    for (carom::Ball& ball : scene.balls) ball.velocity = n.uniform(0, 900) * direction(n);
    ASSERT_EQ(difference(scene, 600), "") << k;
  }
}

// Balls, holes and cushions that are passed by a hair, on one side or the other.
TEST(Skipping, GivesTheSameBitsWhereBallsGraze) {
  Numbers n(3);
  for (std::uint64_t k = 0; k < 60 * times; ++k) {
    Scene scene = table(n, 2 + below(n, 6), k % 2 == 0);
    const double hair = (n.one_in(2) ? -1 : 1) * std::pow(10, -n.uniform(1, 14));
    const Vec2 v = scene.balls[0].velocity;
    const Vec2 d = carom::unit(v);
    const Vec2 side{-d.y, d.x};
    const double way = std::min(2 * carom::length(v), 350.0) * n.uniform(0.2, 0.95);
    if (k % 4 == 0)
      scene.balls[0].position = scene.holes[4].position - d * way + side * (16 + hair);
    else if (k % 4 == 1)
      scene.balls[0].position.y = 8 + std::abs(hair),
      scene.balls[0].velocity = {v.x, -std::abs(hair) * n.uniform(0, 1.2)};
    else
      scene.balls[1].position = scene.balls[0].position + d * way + side * (18 + hair);
    if (!carom::check(scene).empty()) continue;
    ASSERT_EQ(difference(scene, 700), "") << k;
  }
}

// The rounding of many steps decides whether two balls meet in one step or in the next: without the
// margin some are missed.
TEST(Skipping, FindsContactsThatRoundingDecides) {
  Numbers n(7);
  for (std::uint64_t k = 0; k < 100 * times; ++k) {
    Scene scene;
    scene.friction = n.one_in(2) ? 1 : n.uniform(0.98, 1);
    carom::Ball ball;
    ball.position = {n.uniform(100, 300), n.uniform(100, 300)};
    ball.velocity = n.uniform(100, 900) * carom::unit({1, n.uniform(-0.2, 0.2)});
    scene.balls = {ball};
    World alone = tested(worlds::make(scene));
    for (std::uint64_t steps = 8 + n.below(20); steps > 0; --steps) alone.step();
    const double hair = std::pow(10, -n.uniform(11, 14));
    ball.position = alone.ball(0).position + (20 - hair) * carom::unit(ball.velocity);
    ball.velocity = {};
    scene.balls.push_back(ball);
    if (!carom::check(scene).empty()) continue;
    ASSERT_EQ(difference(scene, 60), "") << k;
  }
}

/// A level with everything that one can have.
Scene level(Numbers& n) {
  Scene scene;
  scene.gravity = n.one_in(6) ? 0 : n.uniform(50, 1500);
  if (n.one_in(5)) scene.friction = n.uniform(0.9, 1);
  scene.edges = {.left = n.one_in(2) ? carom::Edge::open : carom::Edge::solid,
                 .right = carom::Edge::open,
                 .bottom = n.one_in(8) ? carom::Edge::open : carom::Edge::solid,
                 .top = n.one_in(2) ? carom::Edge::open : carom::Edge::solid};
  if (n.one_in(4)) scene.holes = {{{n.uniform(0, 800), n.uniform(0, 400)}, n.uniform(5, 30)}};
  for (std::uint64_t k = n.below(4); k > 0; --k)
    scene.obstacles.push_back({n.uniform(100, 700), n.uniform(20, 250), n.uniform(5, 20)});
  const Scene empty = scene;
  const std::size_t count = 1 + below(n, 14);
  for (int tries = 0; scene.balls.size() < count && tries < 200; ++tries) {
    carom::Ball ball;
    ball.radius = n.one_in(3) ? n.uniform(5, 20) : 10;
    ball.position = {n.uniform(20, 780), n.one_in(2) ? ball.radius : n.uniform(20, 380)};
    // Some are stacked, on the one before or on an obstacle, just touching or nearly.
    if (!scene.balls.empty() && n.one_in(3)) {
      const carom::Ball& last = scene.balls.back();
      ball.position =
          last.position + (last.radius + ball.radius) * n.uniform(0.99, 1.03) *
                              (n.one_in(2) ? Vec2{0, 1} : carom::unit({n.uniform(-1, 1), 1}));
    } else if (!scene.obstacles.empty() && n.one_in(3)) {
      const carom::Obstacle& o = scene.obstacles.back();
      ball.position = {o.x, o.height + (o.radius + ball.radius) * n.uniform(1, 1.03)};
    }
    if (n.one_in(3)) ball.solidity = n.uniform(0, 3000);
    if (n.one_in(5)) ball.velocity = n.uniform(0, 600) * direction(n);
    if (scene.balls.empty()) ball.role = carom::Role::projectile;
    Scene alone = empty;
    alone.balls = {ball};
    if (carom::check(alone).empty()) scene.balls.push_back(ball);
  }
  if (!scene.balls.empty()) scene.balls[0].velocity = n.uniform(100, 2000) * direction(n);
  return scene;
}

TEST(Skipping, GivesTheSameBitsInLevels) {
  Numbers n(4);
  for (std::uint64_t k = 0; k < 100 * times; ++k) ASSERT_EQ(difference(level(n), 500), "") << k;
}

// Turns: the world is changed between its steps, the lead goes out and comes back.
TEST(Skipping, GivesTheSameBitsOverWholeGames) {
  Numbers n(5);
  for (std::uint64_t game = 0; game < 2 * times; ++game) {
    World skips = worlds::make(n.one_in(2) ? table(n, 16, true) : level(n));
    if (!skips.has_lead()) continue;
    World tests = tested(skips);
    World copy = skips;
    for (int turn = 0; turn < 15; ++turn) {
      const std::string where = "game " + std::to_string(game) + ", turn " + std::to_string(turn);
      ASSERT_EQ(step_by_step(skips, tests, static_cast<int>(n.below(300))), "") << where;
      ASSERT_EQ(at_once(skips, tests, 2000), "") << where;
      const bool stop = n.one_in(2);
      const Vec2 place{n.uniform(30, 770), n.uniform(30, 370)};
      const Vec2 launch = n.uniform(100, 3000) * direction(n);
      if (n.one_in(3)) {
        copy = skips;
        std::swap(copy, skips);
      }
      for (World* world : {&skips, &tests}) {
        if (stop) world->stop();
        if (!world->in_play(0) || turn % 4 == 0) (void)world->place_lead(place);
        if (world->in_play(0)) (void)world->set_velocity(0, launch);
      }
    }
  }
}

// A world at the limits: where the margins do not hold, every step is tested.
TEST(Skipping, GivesTheSameBitsAtTheLimits) {
  Numbers n(6);
  for (std::uint64_t k = 0; k < 40 * times; ++k) {
    Scene scene;
    const double size = std::pow(10, n.uniform(2, 9));
    scene.width = size;
    scene.height = n.one_in(2) ? size : 400;
    scene.friction = n.one_in(2) ? 1 : n.uniform(0.9, 1);
    if (n.one_in(3)) scene.gravity = std::pow(10, n.uniform(0, 9));
    const double radius =
        n.one_in(3) ? size * n.uniform(0.001, 0.05) : std::pow(10, n.uniform(-3, 2));
    const double corner = n.one_in(2) ? 0 : size - 60 * radius;
    while (scene.balls.size() < 8) {
      carom::Ball ball;
      ball.radius = radius;
      const double spread = n.one_in(3) ? size : 60 * radius;
      ball.position = {corner + n.uniform(0, spread), n.uniform(0, std::min(spread, scene.height))};
      ball.velocity =
          std::min(carom::max_speed, std::pow(10, n.uniform(0, 5))) * 0.99 * direction(n);
      scene.edges = {carom::Edge::open, carom::Edge::open, carom::Edge::open, carom::Edge::open};
      scene.balls.push_back(ball);
    }
    scene.edges.right = carom::Edge::solid;
    for (carom::Ball& ball : scene.balls)
      ball.position.x = std::min(ball.position.x, size - 1.001 * radius);
    if (!carom::check(scene).empty()) continue;
    ASSERT_EQ(difference(scene, 400), "") << k;
  }
}

}  // namespace
