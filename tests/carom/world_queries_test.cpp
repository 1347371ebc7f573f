#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "carom/world.hpp"

namespace {

using carom::Contact;
using carom::Vec2;
using carom::World;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

World world_of(carom::Scene scene) { return World::create(std::move(scene)).value(); }

carom::Scene three_balls() {
  carom::Scene scene;
  scene.balls = {{.role = carom::Role::cue, .position = {100, 100}},
                 {.position = {300, 100}},
                 {.position = {500, 100}, .radius = 20}};
  return scene;
}

std::uint32_t next(std::uint32_t& seed) { return seed = seed * 1664525 + 1013904223; }
double between(std::uint32_t& seed, double low, double high) {
  return low + (high - low) * (next(seed) >> 8) / 0x1p24;
}

carom::Scene many_balls(std::size_t count, std::uint32_t seed) {
  carom::Scene scene;
  scene.width = 3000;
  scene.height = 2000;
  scene.friction = 1;
  for (std::size_t i = 0; i < count; ++i)
    scene.balls.push_back({.position = {between(seed, 50, 2950), between(seed, 50, 1950)},
                           .velocity = {between(seed, -500, 500), between(seed, -500, 500)},
                           .radius = between(seed, 2, 30)});
  return scene;
}

// The same question, asked of every ball.
std::vector<std::uint32_t> all_in(const World& world, carom::Disc disc) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    const carom::Ball ball = world.ball(i);
    const double reach = ball.radius + disc.radius;
    if (world.in_play(i) && carom::length_squared(ball.position - disc.centre) < reach * reach)
      found.push_back(i);
  }
  return found;
}

// The distance at which a disc on its way first overlaps a ball, by small steps.
double slow_contact(const World& world, Vec2 from, Vec2 along, double radius, double most) {
  for (double way = 0; way < most; way += 0.5)
    for (std::size_t i = 0; i < world.size(); ++i) {
      const double reach = world.ball(i).radius + radius;
      const Vec2 start = from - world.ball(i).position;
      if (carom::length(start) < reach) continue;  // overlaps already
      if (carom::length(start + way * along) < reach) return way;
    }
  return infinity;
}

TEST(BallsIn, ADiscGivesWhatOverlapsItAndNoMore) {
  World world = world_of(three_balls());
  EXPECT_EQ(world.balls_in(carom::Disc{{300, 100}, 1}).value(), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(world.balls_in(carom::Disc{{400, 100}, 90}).value(), (std::vector<std::uint32_t>{2}))
      << "ball 1 is only touched";
  EXPECT_TRUE(world.balls_in(carom::Disc{{400, 300}, 5}).value().empty());
}

TEST(BallsIn, ABoxGivesWhatReachesIntoIt) {
  World world = world_of(three_balls());
  EXPECT_EQ(world.balls_in(carom::Box{{110, 0}, {290, 200}}).value(),
            (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(world.balls_in(carom::Box{{-infinity, -infinity}, {infinity, infinity}}).value().size(),
            3U);
}

TEST(BallsIn, AWorldThatMovesIsAskedAnew) {
  World world = world_of(many_balls(300, 5));
  for (int step = 0; step < 200; ++step) {
    const carom::Disc disc{{1500, 1000}, 300};
    ASSERT_EQ(world.balls_in(disc).value(), all_in(world, disc)) << step;
    world.step();
  }
}

TEST(BallsIn, AnAssignedWorldKeepsNothingOfTheOther) {
  World one = world_of(many_balls(100, 1));
  const World other = world_of(many_balls(100, 2));
  const carom::Disc disc{{1500, 1000}, 500};
  (void)one.balls_in(disc).value();
  one = other;
  EXPECT_EQ(one.balls_in(disc).value(), all_in(other, disc));
}

TEST(BallsIn, ALeadOutOfPlayIsNotFound) {
  World world = world_of(three_balls());
  ASSERT_TRUE(world.remove(0).ok());
  EXPECT_TRUE(world.balls_in(carom::Disc{{100, 100}, 50}).value().empty());
  EXPECT_EQ(world.first_contact({50, 100}, {1, 0}, 5).value()->index, 1U);
  ASSERT_TRUE(world.place_lead({100, 100}).ok());
  EXPECT_EQ(world.balls_in(carom::Disc{{100, 100}, 50}).value().size(), 1U);
}

TEST(BallsIn, WrongNumbersAreRefused) {
  World world = world_of(three_balls());
  EXPECT_FALSE(world.balls_in(carom::Disc{{nan, 0}, 1}));
  EXPECT_FALSE(world.balls_in(carom::Disc{{0, infinity}, 1}));
  EXPECT_FALSE(world.balls_in(carom::Disc{{0, 0}, -1}));
  EXPECT_FALSE(world.balls_in(carom::Disc{{0, 0}, nan}));
  EXPECT_FALSE(world.balls_in(carom::Box{{0, 0}, {nan, 1}}));
  EXPECT_FALSE(world.balls_in(carom::Box{{2, 0}, {1, 1}}));
}

TEST(FirstContact, ABallInTheWayStopsTheDiscWhereTheyTouch) {
  World world = world_of(three_balls());
  const auto contact = world.first_contact({100, 100}, {3, 0}, 10).value();
  ASSERT_TRUE(contact);
  EXPECT_EQ(*contact, (Contact{Contact::With::ball, 1, 180, {280, 100}}))
      << "its own place, which ball 0 takes, is no contact";
}

TEST(FirstContact, ASolidEdgeIsMetAndAnOpenOneIsNot) {
  carom::Scene scene;
  scene.edges.top = carom::Edge::open;
  World world = world_of(scene);
  EXPECT_EQ(
      world.first_contact({100, 100}, {0, -1}, 10).value(),
      (Contact{Contact::With::edge, static_cast<std::size_t>(carom::Side::bottom), 90, {100, 10}}));
  EXPECT_FALSE(world.first_contact({100, 100}, {0, 1}, 10).value().has_value());
}

TEST(FirstContact, AnObstacleHasASideAndACap) {
  carom::Scene scene;
  scene.obstacles = {{.x = 400, .height = 100, .radius = 12}};
  World world = world_of(scene);
  EXPECT_EQ(world.first_contact({100, 50}, {1, 0}, 10).value(),
            (Contact{Contact::With::obstacle, 0, 278, {378, 50}}));
  EXPECT_EQ(world.first_contact({400, 300}, {0, -1}, 10).value(),
            (Contact{Contact::With::obstacle, 0, 178, {400, 122}}));
}

TEST(FirstContact, AmongManyBallsItIsTheOneFoundBySmallSteps) {
  World world = world_of(many_balls(400, 9));
  std::uint32_t seed = 3;
  int met = 0;
  for (int n = 0; n < 25; ++n) {
    const Vec2 from{between(seed, 100, 2900), between(seed, 100, 1900)};
    const Vec2 along = carom::unit({between(seed, -1, 1), between(seed, -1, 1)});
    const double radius = n % 3 == 0 ? 0 : between(seed, 1, 40);
    const auto contact = world.first_contact(from, 1e-5 * along, radius).value();
    ASSERT_TRUE(contact);
    const double slow = slow_contact(world, from, along, radius, contact->distance + 1);
    if (contact->with == Contact::With::ball) {
      ++met;
      // A graze between two steps is met by the exact way only.
      EXPECT_GE(slow, contact->distance - 1e-6);
      const carom::Ball ball = world.ball(contact->index);
      EXPECT_NEAR(carom::length(contact->position - ball.position), ball.radius + radius, 1e-9);
    } else {
      EXPECT_GE(slow, contact->distance);
    }
  }
  EXPECT_GT(met, 15);
}

TEST(FirstContact, WrongNumbersAreRefused) {
  World world = world_of(three_balls());
  EXPECT_FALSE(world.first_contact({0, 0}, {0, 0}, 1));
  EXPECT_FALSE(world.first_contact({0, 0}, {nan, 1}, 1));
  EXPECT_FALSE(world.first_contact({0, 0}, {infinity, 1}, 1));
  EXPECT_FALSE(world.first_contact({2e9, 0}, {1, 0}, 1));
  EXPECT_FALSE(world.first_contact({0, 0}, {1, 0}, -1));
  EXPECT_TRUE(world.first_contact({0, 0}, {1e-310, 1e-310}, 1));
  EXPECT_TRUE(world.first_contact({0, 0}, {1e300, -1e300}, 1));
}

TEST(FirstContact, AnsweringChangesNothingThatFollows) {
  World asked = world_of(many_balls(120, 4));
  World quiet = asked;
  for (int step = 0; step < 300; ++step) {
    (void)asked.first_contact({1500, 1000}, {1, step - 150.0}, 5).value();
    asked.step();
    quiet.step();
    ASSERT_EQ(asked.state_hash(), quiet.state_hash()) << step;
  }
}

TEST(IndexOf, FollowsABallThatWasMovedInTheArray) {
  World world = world_of(three_balls());
  ASSERT_TRUE(world.remove(1).ok());
  EXPECT_EQ(world.index_of(2), 1U);
  EXPECT_FALSE(world.index_of(1));
  EXPECT_EQ(world.index_of(0), 0U);
  ASSERT_TRUE(world.remove(0).ok());
  EXPECT_FALSE(world.index_of(0)) << "a lead that waits is not in play";
  EXPECT_FALSE(world.index_of(77));
}

TEST(EventParts, EachKindTellsItsOwn) {
  const auto event = [](carom::EventKind kind) {
    return carom::Event{.kind = kind, .ball = 1, .other = 3};
  };
  using enum carom::EventKind;
  EXPECT_EQ(event(cushion).side(), carom::Side::top);
  EXPECT_EQ(event(floor).side(), carom::Side::top);
  EXPECT_FALSE(event(pair).side());
  EXPECT_EQ(event(pocketed).hole(), 3U);
  EXPECT_FALSE(event(cushion).hole());
  EXPECT_EQ(event(wall).obstacle(), 3U);
  EXPECT_EQ(event(cap).obstacle(), 3U);
  EXPECT_FALSE(event(pocketed).obstacle());
}

}  // namespace
