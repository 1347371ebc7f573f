#include <algorithm>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "carom/quadtree.hpp"
#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "carom/world.hpp"
#include "random_worlds.hpp"
#include "worlds.hpp"

// What the limits of a scene are for: whatever is accepted is played alike by every broad phase,
// has no infinity in it, and takes no step that never ends.

namespace {

using carom::Ball;
using carom::BroadPhase;
using carom::Scene;
using carom::World;
using random_worlds::Numbers;

std::string text(const carom::Errors& errors) {
  std::string all;
  for (const carom::Error& error : errors) all += to_string(error) + '\n';
  return all;
}

/// What differs first between the broad phases, in words, or nothing. Also an infinity in a trace.
std::string difference(const Scene& scene, int steps) {
  World pairs = worlds::make(scene);
  World tree = pairs;
  World automatic = pairs;
  pairs.set_broad_phase(BroadPhase::pairs);
  tree.set_broad_phase(BroadPhase::quadtree);
  for (int step = 1; step <= steps; ++step) {
    const auto expected = pairs.step();
    for (World* world : {&tree, &automatic}) {
      const std::string name = world == &tree ? "quadtree" : "automatic";
      if (!std::ranges::equal(world->step(), expected))
        return name + ": other events in step " + std::to_string(step);
      if (world->state_hash() != pairs.state_hash())
        return name + ": another state after step " + std::to_string(step);
    }
    std::string line;
    append_trace_line(line, pairs, expected);
    if (line.find("inf") != std::string::npos || line.find("nan") != std::string::npos)
      return "no JSON: " + line;
  }
  return {};
}

/// Sizes and places at the limits: a crowd of small balls far away, with holes and obstacles there.
Scene extreme_scene(std::uint64_t seed, std::size_t most) {
  Numbers n(seed);
  Scene s;
  const auto one_of = [&](std::initializer_list<double> numbers) {
    return *(numbers.begin() + n.below(numbers.size()));
  };
  s.width = one_of({carom::min_size, 1, 1e5, carom::max_quantity});
  s.height = one_of({carom::min_size, 1, 1e5, carom::max_quantity});
  const auto edge = [&] { return n.one_in(4) ? carom::Edge::solid : carom::Edge::open; };
  s.edges = {edge(), edge(), edge(), edge()};
  s.friction = one_of({1e-300, 0.5, 1});
  s.gravity = one_of({0, 1e-300, 500, carom::max_quantity});
  s.hole_pull = one_of({0, 1e-300, 1e5, carom::max_quantity});
  s.damage_per_speed = one_of({0, 5e-324, 4, carom::max_quantity});
  s.damage_threshold = one_of({0, 5e-324, 1e308});
  const double unit = one_of({carom::min_size, 0.01, 1, 1e6});
  const double most_far = carom::max_quantity;
  const carom::Vec2 middle{one_of({0, 1, -5e8, 5e8, most_far, -most_far}),
                           one_of({0, 1, -5e8, 5e8, most_far, -most_far})};
  const double spread = unit * one_of({2, 10, 100});
  const auto within = [&](double number) { return std::clamp(number, -most_far, most_far); };
  const auto place = [&] {
    return carom::Vec2{within(middle.x + n.uniform(-spread, spread)),
                       within(middle.y + n.uniform(-spread, spread))};
  };
  const auto size = [&] {
    return n.one_in(10) ? one_of({carom::min_size, 1, 1e6, carom::max_quantity})
                        : unit * n.uniform(1, 3);
  };
  for (std::uint64_t k = n.below(3); k > 0; --k) s.holes.push_back({place(), size()});
  for (std::uint64_t k = n.below(3); k > 0; --k)
    s.obstacles.push_back({place().x, std::max(place().y, carom::min_size), size()});
  const Scene empty = s;
  const std::size_t count = 2 + n.below(most);
  for (std::size_t tries = 0; s.balls.size() < count && tries < 3 * count; ++tries) {
    Ball b;
    b.position = place();
    b.radius = size();
    const double top = one_of({0, 1e-300, unit, 1000, 70'000});
    b.velocity = {n.uniform(-top, top), n.uniform(-top, top)};
    if (n.one_in(3)) b.solidity = one_of({0, 5e-324, 1000, 1e308});
    if (s.balls.empty() && n.one_in(3)) b.role = carom::Role::projectile;
    Scene alone = empty;
    alone.balls = {b};
    if (carom::check(alone).empty()) s.balls.push_back(b);
  }
  return s;
}

TEST(Limits, AllBroadPhasesGiveTheSameBitsAtThem) {
  std::size_t balls = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const Scene scene = extreme_scene(seed, seed % 20 == 0 ? 120 : 20);
    balls += scene.balls.size();
    ASSERT_EQ(difference(scene, 4), "") << "seed " << seed << "\n" << write_scene(scene);
  }
  EXPECT_GT(balls, 7'000U);
}

TEST(Limits, AllBroadPhasesGiveTheSameBitsForBallsThatFlyAway) {
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    Numbers n(seed);
    Scene s;
    s.edges = {carom::Edge::open, carom::Edge::open, carom::Edge::open, carom::Edge::open};
    s.friction = 1;
    s.gravity = carom::max_quantity;
    s.width = carom::max_quantity;
    for (int k = 0; k < 40; ++k) {
      Ball b;
      b.position = {5e8 + n.uniform(0, 0.1), n.uniform(0, 0.1)};
      b.radius = n.one_in(8) ? n.uniform(1, 100) : n.uniform(0.001, 0.01);
      s.balls.push_back(b);
    }
    ASSERT_EQ(difference(s, 60), "") << "seed " << seed;
  }
}

// Nothing bounds where a ball gets to that has left.
TEST(Limits, TheTreeFindsAllPairsHoweverFarAway) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Numbers n(seed);
    const double far = std::pow(10, n.uniform(6, 19)) * (n.one_in(2) ? 1 : -1);
    const double grain = std::nextafter(std::abs(far), INFINITY) - std::abs(far);
    const double unit = std::clamp(grain * std::pow(10, n.uniform(-3, 9)), 0.001, 1e9);
    const bool equal = n.one_in(2);
    std::vector<double> x, y, radius;
    for (int k = 0; k < 50; ++k) {
      x.push_back(far + n.uniform(-10, 10) * unit);
      y.push_back((n.one_in(2) ? far : 0) + n.uniform(-10, 10) * unit);
      radius.push_back(equal          ? unit
                       : n.one_in(10) ? std::pow(10, n.uniform(-3, 9))
                                      : std::clamp(unit * n.uniform(0.5, 2), 0.001, 1e9));
    }
    carom::Quadtree tree;
    tree.build(x, y, radius);
    const auto check = [&] {
      std::vector<carom::Pair> expected, found;
      for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = i + 1; j < x.size(); ++j)
          if (const double sum = radius[i] + radius[j];
              length_squared(carom::Vec2{x[j], y[j]} - carom::Vec2{x[i], y[i]}) < sum * sum)
            expected.push_back({i, j});
      tree.overlapping_pairs(found);
      ASSERT_EQ(found, expected) << seed;
      // Of a size that reaches as far as the squares next to its own.
      const double own = 1.597 * unit;
      for (std::size_t i = 0; i < x.size(); ++i) {
        std::vector<std::uint32_t> around, got;
        for (std::uint32_t j = 0; j < x.size(); ++j)
          if (const double sum = own + radius[j];
              length_squared(carom::Vec2{x[j], y[j]} - carom::Vec2{x[i], y[i]}) < sum * sum)
            around.push_back(j);
        tree.query_disc({x[i], y[i]}, own, got);
        ASSERT_EQ(got, around) << seed;
      }
    };
    check();
    for (int k = 0; k < 5; ++k) {
      const std::size_t i = n.below(50);
      x[i] = n.one_in(3) ? n.uniform(-1e3, 1e3) : far + n.uniform(-10, 10) * unit;
      tree.moved(i);
    }
    check();
  }
}

TEST(Limits, AreHeldByTheExampleThatDiffered) {
  const auto scene = carom::read_scene(
      R"({"carom":1,"width":1,"height":1,"obstacles":[{"x":1.1e-50,"height":9e-51,"radius":5e-51}],)"
      R"("balls":[{"x":2.07e-50,"y":9e-52,"radius":9e-52,"vx":-8e-48}]})");
  ASSERT_FALSE(scene);
  EXPECT_EQ(text(scene.errors()),
            "1:68: /obstacles/0/height: is 9e-51; expected a number from 0.001 to 1000000000 (px)\n"
            "1:83: /obstacles/0/radius: is 5e-51; expected a number from 0.001 to 1000000000 (px)\n"
            "1:133: /balls/0/radius: is 9e-52; expected a number from 0.001 to 1000000000 (px)\n");
}

TEST(Limits, DamagePerSpeedCannotMakeAnInfinity) {
  Scene scene = worlds::table({worlds::ball({100, 100}, {1000, 0}), worlds::ball({115, 100})});
  scene.balls[1].solidity = 1e308;
  scene.damage_per_speed = 1e308;
  EXPECT_EQ(text(carom::check(scene)),
            "/damage_per_speed: is 1e+308; expected a number from 0 to 1000000000\n");
  scene.damage_per_speed = carom::max_quantity;
  EXPECT_EQ(difference(scene, 3), "");
}

/// Balls on one spot.
Scene heap(std::size_t balls) {
  Scene scene;
  scene.balls.assign(balls, worlds::ball({400, 200}));
  return scene;
}

TEST(Limits, PairsThatOverlapAreCounted) {
  // 163 on one spot: 13 203 pairs, where 20·163 + 10 000 = 13 260 are allowed.
  EXPECT_EQ(text(carom::check(heap(163))), "");
  EXPECT_EQ(
      text(carom::check(heap(164))),
      "/balls: overlap in more than 13280 pairs; expected at most 20 per ball and 10000 more\n");
  // Of different sizes, on several levels of the tree, each pair once.
  Scene scene = heap(163);
  scene.edges = {carom::Edge::open, carom::Edge::open, carom::Edge::open, carom::Edge::open};
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
    scene.balls[i].radius = 0.007 * static_cast<double>(1 + i * i);
  EXPECT_EQ(text(carom::check(scene)), "");
  scene.balls.push_back(worlds::ball({400, 200}, {}, 0.001));
  EXPECT_EQ(carom::check(scene).size(), 1U);
}

TEST(Limits, ManyBallsSideBySideAreFine) {
  Scene scene;
  scene.width = scene.height = 20'000;
  for (int k = 0; k < 20'000; ++k)
    scene.balls.push_back(worlds::ball({20.0 + k % 140 * 15, 20.0 + k / 140 * 15}));
  EXPECT_EQ(text(carom::check(scene)), "");  // each overlaps all eight around it
}

TEST(Limits, CentresInHolesAreCounted) {
  Scene scene;
  scene.balls.assign(20, worlds::ball({400, 200}));
  scene.holes.assign(520, {{400, 200}, 16});
  EXPECT_EQ(text(carom::check(scene)), "");
  scene.holes.push_back({{400, 200}, 16});
  EXPECT_EQ(text(carom::check(scene)),
            "/balls: lie on holes in more than 10400 pairs; expected at most 20 per ball and 10000 "
            "more\n");
}

TEST(Limits, HeapsAreRefusedAtOnce) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(carom::check(heap(20'000)).size(), 1U);
  // 40 000 obstacles in one place, 60 000 balls in them and as many beside.
  Scene scene;
  scene.width = scene.height = 1e6;
  scene.obstacles.assign(40'000, {500'000, 400'000, 12});
  for (int k = 0; k < 60'000; ++k) {
    scene.balls.push_back(worlds::ball({499'995, 20.0 + k}, {}, 0.4));
    scene.balls.push_back(worlds::ball({20.0 + k, 999'000}, {}, 0.4));
  }
  const carom::Errors errors = carom::check(scene);
  EXPECT_EQ(errors.size(), carom::max_errors + 1);
  EXPECT_EQ(to_string(errors.back()), "and 59000 more errors");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

/// As a look at each obstacle finds it.
std::string overlaps_of(const Scene& scene) {
  std::string all;
  for (const Ball& ball : scene.balls)
    for (const carom::Obstacle& o : scene.obstacles) {
      const double reach = o.radius + ball.radius;
      if (ball.position.y < o.height ? std::abs(ball.position.x - o.x) < reach
                                     : length(ball.position - carom::Vec2{o.x, o.height}) < reach) {
        all += "/balls/" + std::to_string(&ball - scene.balls.data()) + ": overlaps obstacle " +
               std::to_string(&o - scene.obstacles.data()) + " ";
        break;
      }
    }
  return all;
}

TEST(Limits, OverlapsWithObstaclesAreFoundByTheTree) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Numbers n(seed);
    Scene scene;
    scene.edges = {carom::Edge::open, carom::Edge::open, carom::Edge::open, carom::Edge::open};
    const double size = n.one_in(3) ? 0.001 : n.uniform(1, 50);
    for (std::uint64_t k = 1 + n.below(40); k > 0; --k)
      scene.obstacles.push_back({n.uniform(0, 800), n.uniform(1, 400), n.uniform(size, 2 * size)});
    for (std::uint64_t k = 1 + n.below(40); k > 0; --k)
      scene.balls.push_back(
          worlds::ball({n.uniform(-100, 900), n.uniform(-400, 500)}, {},
                       n.one_in(9) ? n.uniform(1, 300) : n.uniform(size, 3 * size)));
    std::string found;
    for (const carom::Error& error : carom::check(scene)) {
      const std::string whole = to_string(error);
      found += whole.substr(0, whole.find('('));
    }
    ASSERT_EQ(found, overlaps_of(scene)) << seed;
  }
}

}  // namespace
