#include "carom/quadtree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "allocations.hpp"
#include "carom/world.hpp"
#include "random_worlds.hpp"
#include "worlds.hpp"

namespace {

using carom::Pair;
using carom::Quadtree;
using carom::Vec2;
using random_worlds::Numbers;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Discs {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> radius;

  std::size_t size() const { return x.size(); }
  Vec2 centre(std::size_t i) const { return {x[i], y[i]}; }
  void add(Vec2 at, double r) {
    x.push_back(at.x);
    y.push_back(at.y);
    radius.push_back(r);
  }
  void put(std::size_t i, Vec2 at) {
    x[i] = at.x;
    y[i] = at.y;
  }
};

void build(Quadtree& tree, const Discs& discs) { tree.build(discs.x, discs.y, discs.radius); }

// What the header promises, disc by disc.

bool overlap(Vec2 a, double radius_a, Vec2 b, double radius_b) {
  const double sum = radius_a + radius_b;
  return length_squared(b - a) < sum * sum;
}

std::vector<Pair> expected_pairs(const Discs& discs) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      if (overlap(discs.centre(i), discs.radius[i], discs.centre(j), discs.radius[j]))
        pairs.push_back({i, j});
  return pairs;
}

std::vector<std::uint32_t> expected_near(const Discs& discs, Vec2 centre, double radius) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < discs.size(); ++i)
    if (overlap(centre, radius, discs.centre(i), discs.radius[i])) found.push_back(i);
  return found;
}

std::vector<std::uint32_t> expected_in_box(const Discs& discs, Vec2 low, Vec2 high) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < discs.size(); ++i) {
    const double dx = std::max({low.x - discs.x[i], 0.0, discs.x[i] - high.x});
    const double dy = std::max({low.y - discs.y[i], 0.0, discs.y[i] - high.y});
    if (dx * dx + dy * dy <= discs.radius[i] * discs.radius[i]) found.push_back(i);
  }
  return found;
}

/// How the discs lie and how large they are.
enum class Kind : std::uint8_t { equal, billiards, orders, outliers, heaps, on_sides, far_off };
constexpr int kinds = 7;

Discs random_discs(Numbers& n, Kind kind, std::size_t count) {
  Discs discs;
  // As dense as balls in a world, left and right of the origin, above and below.
  const double spread = 15 * std::sqrt(static_cast<double>(count)) + 1;
  Vec2 heap{-7.3, 2.1};
  for (std::size_t i = 0; i < count; ++i) {
    Vec2 at{n.uniform(-spread, spread), n.uniform(-spread, spread)};
    double radius = 10;
    switch (kind) {
      case Kind::equal:
        break;
      case Kind::billiards:
        radius = n.one_in(5) ? 8 : 10;
        break;
      case Kind::orders:  // 0.001 to 1000
        radius = std::pow(10, n.uniform(-3, 3));
        break;
      case Kind::outliers:
        if (n.one_in(10)) at = 1e4 * at;
        if (n.one_in(30)) at = 1e14 * at;
        if (n.one_in(40)) radius = 3000;
        break;
      case Kind::heaps:
        if (n.one_in(12)) heap = at;
        at = heap;
        radius = n.uniform(1, 30);
        break;
      case Kind::on_sides:  // of the squares, 26 px wide
        at = {26 * std::round(at.x / 26), 26 * std::round(at.y / 26)};
        if (n.one_in(3)) at.x = std::nextafter(at.x, n.one_in(2) ? 1e9 : -1e9);
        if (n.one_in(3)) at.y = std::nextafter(at.y, n.one_in(2) ? 1e9 : -1e9);
        break;
      case Kind::far_off:
        at += Vec2{-1e9, 3e8};
        break;
    }
    discs.add(at, radius);
  }
  return discs;
}

Vec2 somewhere(Numbers& n, const Discs& discs) {
  if (discs.size() == 0 || n.one_in(10)) return {n.uniform(-1e4, 1e4), n.uniform(-1e4, 1e4)};
  const Vec2 near = discs.centre(n.below(discs.size()));
  return n.one_in(4) ? near : near + Vec2{n.uniform(-60, 60), n.uniform(-60, 60)};
}

/// What the tree answers otherwise than a look at each disc does; or nothing.
std::string difference(const Quadtree& tree, const Discs& discs, Numbers& n, int queries) {
  std::vector<Pair> pairs{{7, 7}};
  tree.overlapping_pairs(pairs);
  if (pairs != expected_pairs(discs)) return "other pairs";
  std::vector<std::uint32_t> found{7};
  for (int query = 0; query < queries; ++query) {
    const Vec2 at = somewhere(n, discs);
    const double radius = n.one_in(4) ? 0 : std::pow(10, n.uniform(-3, 3.5));
    tree.query_disc(at, radius, found);
    if (found != expected_near(discs, at, radius)) return "others overlap a disc";
    Vec2 low = n.one_in(2) ? at : at - Vec2{n.uniform(0, 200), n.uniform(0, 200)};
    Vec2 high = n.one_in(4) ? low : low + Vec2{n.uniform(0, 300), n.uniform(0, 300)};
    if (n.one_in(8)) low.x = -infinity;
    if (n.one_in(8)) low.y = -infinity;
    if (n.one_in(8)) high.x = infinity;
    if (n.one_in(8)) high.y = infinity;
    tree.query_box(low, high, found);
    if (found != expected_in_box(discs, low, high)) return "others reach into a box";
  }
  return {};
}

class QuadtreeOf : public testing::TestWithParam<int> {
 protected:
  Kind kind() const { return static_cast<Kind>(GetParam()); }
  Numbers numbers_{static_cast<std::uint64_t>(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(AllKinds, QuadtreeOf, testing::Range(0, kinds));

TEST_P(QuadtreeOf, FindsWhatALookAtEachDiscFinds) {
  for (int round = 0; round < 150; ++round) {
    const std::size_t count = numbers_.below(round % 10 == 0 ? 800 : round % 3 == 0 ? 100 : 12);
    const Discs discs = random_discs(numbers_, kind(), count);
    Quadtree tree;
    build(tree, discs);
    ASSERT_EQ(tree.size(), count);
    ASSERT_EQ(difference(tree, discs, numbers_, 40), "") << "round " << round;
  }
}

// The form of the levels is kept for 64 builds, whatever becomes of the discs.
TEST_P(QuadtreeOf, FindsWhatHasChangedBetweenBuilds) {
  Quadtree tree;
  Discs discs = random_discs(numbers_, kind(), 60);
  for (int round = 0; round < 150; ++round) {
    const auto other = static_cast<Kind>(numbers_.below(kinds));
    if (round % 20 == 0) discs = random_discs(numbers_, other, 60);
    if (round % 7 == 0)
      for (double& radius : discs.radius) radius *= std::pow(10, numbers_.uniform(-2, 2));
    for (double& x : discs.x) x += numbers_.uniform(-30, 30);
    build(tree, discs);
    ASSERT_EQ(difference(tree, discs, numbers_, 10), "") << "round " << round;
  }
}

// Larger, of a sudden, than the squares are wide.
TEST_P(QuadtreeOf, FindsDiscsThatHaveGrown) {
  for (int round = 0; round < 20; ++round) {
    Discs discs = random_discs(numbers_, kind(), 200);
    for (double& radius : discs.radius) radius /= 8;
    Quadtree tree;
    build(tree, discs);
    for (double& radius : discs.radius) radius *= 8;
    build(tree, discs);
    ASSERT_EQ(difference(tree, discs, numbers_, 20), "") << "round " << round;
  }
}

TEST_P(QuadtreeOf, FindsDiscsOfAnotherNumber) {
  Quadtree tree;
  for (int round = 0; round < 150; ++round) {
    const Discs discs = random_discs(numbers_, kind(), numbers_.below(round % 2 == 0 ? 200 : 5));
    build(tree, discs);
    ASSERT_EQ(difference(tree, discs, numbers_, 10), "") << "round " << round;
  }
}

// Short moves stay in the square, longer ones come to a neighbour, long ones anywhere; far more of
// these than the tree looks at one by one.
TEST_P(QuadtreeOf, FindsWhatHasMoved) {
  Quadtree tree;
  for (int round = 0; round < 60; ++round) {
    Discs discs = random_discs(numbers_, kind(), 1 + numbers_.below(round % 10 == 0 ? 400 : 40));
    build(tree, discs);
    const double moves = std::pow(10, numbers_.uniform(-2, 4));
    for (int after = 0; after < 8; ++after) {
      for (std::uint64_t k = numbers_.below(after == 7 ? 300 : 10); k > 0; --k) {
        const std::size_t i = numbers_.below(discs.size());
        const Vec2 by{numbers_.uniform(-moves, moves), numbers_.uniform(-moves, moves)};
        discs.put(i, numbers_.one_in(8) ? somewhere(numbers_, discs) : discs.centre(i) + by);
        tree.moved(i);
      }
      ASSERT_EQ(difference(tree, discs, numbers_, 10), "") << "round " << round;
    }
  }
}

TEST(Quadtree, FindsNothingInNothing) {
  Quadtree tree;
  Numbers n(1);
  EXPECT_EQ(difference(tree, {}, n, 10), "");
  EXPECT_TRUE(tree.squares().empty());
  build(tree, {});
  EXPECT_EQ(difference(tree, {}, n, 10), "");
  EXPECT_EQ(tree.size(), 0);
  EXPECT_TRUE(tree.squares().empty());
}

// Discs that are just in contact do not overlap, but a box's boundary belongs to it.
TEST(Quadtree, TellsContactFromOverlap) {
  Discs discs;
  discs.add({-10, 0}, 10);
  discs.add({10, 0}, 10);
  Quadtree tree;
  build(tree, discs);
  std::vector<Pair> pairs;
  tree.overlapping_pairs(pairs);
  EXPECT_TRUE(pairs.empty());
  std::vector<std::uint32_t> found;
  tree.query_disc({0, 0}, 0, found);
  EXPECT_TRUE(found.empty());
  tree.query_box({0, 0}, {0, 0}, found);
  EXPECT_EQ(found, (std::vector<std::uint32_t>{0, 1}));

  discs.x[1] = 10 - 0x1p-40;
  tree.moved(1);
  tree.overlapping_pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<Pair>{{0, 1}}));
  tree.query_disc({0, 0}, 0, found);
  EXPECT_EQ(found, (std::vector<std::uint32_t>{1}));
}

TEST(Quadtree, KnowsBoxesWithoutEnd) {
  Discs discs;
  for (const double at : {-1e300, -1e31, -5.0, 0.0, 7.0, 1e31, 1e300}) discs.add({at, -at}, 1);
  Quadtree tree;
  build(tree, discs);
  std::vector<std::uint32_t> found;
  const auto box = [&](Vec2 low, Vec2 high) {
    tree.query_box(low, high, found);
    return found;
  };
  using Found = std::vector<std::uint32_t>;
  EXPECT_EQ(box({-infinity, -infinity}, {infinity, infinity}), (Found{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(box({6, -infinity}, {infinity, infinity}), (Found{4, 5, 6}));
  EXPECT_EQ(box({-infinity, -1}, {infinity, 1}), (Found{3}));
  EXPECT_EQ(box({1e32, -infinity}, {infinity, 0}), (Found{6}));
  EXPECT_EQ(box({-infinity, 1e32}, {infinity, infinity}), (Found{0}));
  EXPECT_EQ(box({infinity, infinity}, {infinity, infinity}), (Found{}));
}

TEST(Quadtree, ShowsItsSquares) {
  Discs discs;
  discs.add({65, 13}, 10);  // squares of 26 px
  discs.add({-1, -1}, 10);
  discs.add({70, 20}, 9);
  discs.add({7, 8}, 5);  // squares of 13 px: radii from 2.5, exclusive, to 5
  discs.add({7, 40}, 3);
  discs.add({1, 0.5}, 0.6);  // of 1.625 px
  Quadtree tree;
  build(tree, discs);
  const std::vector<Quadtree::Square> expected{
      {{-26, -26}, 26, 0}, {{52, 0}, 26, 0}, {{0, 0}, 13, 1}, {{0, 39}, 13, 1}, {{0, 0}, 1.625, 4}};
  EXPECT_EQ(tree.squares(), expected);

  discs.put(1, {26.5, -40});
  tree.moved(1);
  EXPECT_EQ(tree.squares().front(), (Quadtree::Square{{26, -52}, 26, 0}));
}

TEST_P(QuadtreeOf, HasEveryCentreInASquare) {
  const Discs discs = random_discs(numbers_, kind(), 300);
  Quadtree tree;
  build(tree, discs);
  const std::vector<Quadtree::Square> squares = tree.squares();
  const auto in_order = [](const Quadtree::Square& a, const Quadtree::Square& b) {
    if (a.level != b.level) return a.level < b.level;
    return a.low.y != b.low.y ? a.low.y < b.low.y : a.low.x < b.low.x;
  };
  EXPECT_TRUE(std::ranges::is_sorted(squares, in_order));
  EXPECT_EQ(std::ranges::adjacent_find(squares), squares.end());

  std::vector<bool> used(squares.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double diameter = 2 * discs.radius[i];
    if (length(discs.centre(i)) > 1e12) continue;  // beyond 2⁵⁰ sides, perhaps
    int holding = 0;
    for (std::size_t s = 0; s < squares.size(); ++s) {
      const auto& [low, side, level] = squares[s];
      const double hair = 1e-6 * side + 1e-15 * length(discs.centre(i));
      const bool fits = side > 1.299 * diameter && side < 2.601 * diameter;
      const bool inside = discs.x[i] > low.x - hair && discs.x[i] < low.x + side + hair &&
                          discs.y[i] > low.y - hair && discs.y[i] < low.y + side + hair;
      if (!fits || !inside) continue;
      ++holding;
      used[s] = true;
    }
    EXPECT_GE(holding, 1) << "disc " << i;
    if (kind() != Kind::on_sides) {
      EXPECT_EQ(holding, 1) << "disc " << i;
    }
  }
  if (kind() != Kind::outliers) {
    EXPECT_EQ(std::ranges::count(used, false), 0);
  }
}

// Discs of every kind, once there were as many; queries, once there was as much to find.
TEST(Quadtree, AllocatesNothingTheSecondTime) {
  Numbers n(5);
  constexpr std::size_t count = 500;
  std::vector<Discs> all;
  for (int kind = 0; kind < kinds; ++kind)
    all.push_back(random_discs(n, static_cast<Kind>(kind), count - static_cast<std::size_t>(kind)));
  Quadtree tree;
  build(tree, all.front());
  std::vector<std::uint32_t> found;
  found.reserve(10 * count);
  std::vector<Pair> pairs;
  pairs.reserve(count * count);
  const std::size_t before = allocations();
  for (int build_number = 0; build_number < 100; ++build_number)
    for (Discs& discs : all) {
      build(tree, discs);
      tree.overlapping_pairs(pairs);
      tree.query_disc({0, 0}, 100, found);
      tree.query_box({-100, -100}, {100, 100}, found);
      for (std::size_t i = 0; i < 200; ++i) {
        discs.x[i] += 50;
        tree.moved(i);
      }
    }
  EXPECT_EQ(allocations(), before);
}

// A table and a pile that come to rest: what a step needs it keeps. Only more to tell or to find
// than ever before makes an array grow.
TEST(World, AllocatesNothingInASteadyState) {
  for (const double gravity : {0.0, 500.0}) {
    for (const std::size_t count : {std::size_t{100}, std::size_t{200}}) {
      Numbers n(count);
      carom::Scene scene;
      scene.width = scene.height = 30 * std::sqrt(static_cast<double>(count));
      scene.friction = 0.99;
      scene.gravity = gravity;
      scene.holes.push_back({{0, 0}, 5});
      scene.obstacles.push_back({scene.width / 2, 1, 1});
      for (std::size_t i = 0; i < count; ++i)
        scene.balls.push_back(
            worlds::ball({n.uniform(10, scene.width - 10), n.uniform(20, scene.height - 10)},
                         {n.uniform(-500, 500), n.uniform(-500, 500)}));
      carom::World world = worlds::make(scene);
      for (int step = 0; step < 2000; ++step) world.step();
      const std::size_t before = allocations();
      for (int step = 0; step < 200; ++step) world.step();
      EXPECT_EQ(allocations(), before) << count << " balls, gravity " << gravity;
    }
  }
}

}  // namespace
