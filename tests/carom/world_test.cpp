#include "carom/world.hpp"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "allocations.hpp"
#include "carom/trace.hpp"
#include "worlds.hpp"

namespace {

using carom::Vec2;
using carom::World;
using worlds::ball;
using worlds::make;
using worlds::table;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

carom::Scene cue_table() {
  carom::Scene scene = table({ball({200, 200}), ball({400, 200})});
  scene.balls[0].role = carom::Role::cue;
  return scene;
}

TEST(World, ItsBallsAreViewsThatCannotBeWritten) {
  using View = decltype(std::declval<World&>().balls());
  static_assert(!std::is_assignable_v<decltype(std::declval<View&>().x[0]), double>);
  static_assert(!std::is_assignable_v<decltype(std::declval<View&>().role[0]), carom::Role>);
  const World world =
      World::create({.width = 100, .height = 100, .balls = {{.position = {20, 30}}}}).value();
  EXPECT_EQ(world.balls().size(), 1U);
  EXPECT_EQ(world.balls().x.data(), world.balls().x.data()) << "no copies";
  EXPECT_EQ(world.balls()[0].position, (carom::Vec2{20, 30}));
}

TEST(World, RefusesAVelocityAndKeepsItsState) {
  World world = make(cue_table());
  const auto before = world.state_hash();
  for (const Vec2 wrong : {Vec2{nan, 0}, Vec2{0, inf}, Vec2{-inf, 0}, Vec2{100'001, 0},
                           Vec2{80'000, 80'000}, Vec2{1e300, 1e300}}) {
    EXPECT_FALSE(world.set_velocity(0, wrong)) << wrong.x;
    EXPECT_EQ(world.state_hash(), before);
  }
  EXPECT_FALSE(world.set_velocity(2, {1, 0})) << "no such ball";
  EXPECT_TRUE(world.set_velocity(0, {100'000, 0}));
  EXPECT_NE(world.state_hash(), before);
}

// As searches do: one world is set back to the same state again and again.
TEST(World, AssignmentOfTheSameSizeAllocatesNothing) {
  carom::Scene scene = cue_table();
  for (int k = 0; k < 14; ++k) scene.balls.push_back(ball({20.0 + 25 * k, 300}));
  const World start = make(scene);
  World world = start;
  world.run({.rest = true}, 10);
  const std::size_t before = allocations();
  for (int k = 0; k < 100; ++k) world = start;
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(world.state_hash(), start.state_hash());
}

TEST(World, RefusesAPlaceAndKeepsItsState) {
  carom::Scene scene = cue_table();
  scene.obstacles = {{.x = 600, .height = 100, .radius = 10}};
  World world = make(scene);
  const auto before = world.state_hash();
  for (const Vec2 wrong : {Vec2{nan, 100}, Vec2{100, inf}, Vec2{9.99, 200}, Vec2{200, 390.1},
                           Vec2{600, 50}, Vec2{600, 115}, Vec2{2e9, 100}}) {
    EXPECT_FALSE(world.place_lead(wrong)) << wrong.x << ' ' << wrong.y;
    EXPECT_EQ(world.state_hash(), before);
  }
  EXPECT_TRUE(world.place_lead({10, 200})) << "touching a cushion is fine";
  EXPECT_FALSE(make(table({ball({100, 100})})).place_lead({200, 200})) << "no lead";
}

TEST(World, RefusesAWrongScene) {
  carom::Scene scene = table({ball({200, 200}, {nan, 0})});
  EXPECT_FALSE(World::create(scene));
  scene = table({ball({200, 200}, {0, 0}, -1)});
  EXPECT_FALSE(World::create(scene));
  scene = table({});
  scene.friction = 1.5;
  const auto refused = World::create(scene);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors().front().pointer, "/friction");
}

TEST(World, RefusesMoreThanTenMillionBalls) {
  carom::Scene scene = table({});
  scene.balls.assign(carom::max_balls + 1, ball({200, 200}));
  EXPECT_FALSE(World::create(std::move(scene)));
}

TEST(World, IsAValue) {
  World world = make(cue_table());
  ASSERT_TRUE(world.set_velocity(0, {700, 20}));
  World copy = world;
  for (int i = 0; i < 100; ++i) world.step();
  for (int i = 0; i < 100; ++i) copy.step();
  EXPECT_EQ(copy.state_hash(), world.state_hash());
  EXPECT_EQ(copy.steps(), 100U);
}

TEST(World, StopMakesAllSpeedsZero) {
  World world = make(cue_table());
  ASSERT_TRUE(world.set_velocity(1, {700, 20}));
  EXPECT_FALSE(world.at_rest());
  world.stop();
  EXPECT_TRUE(world.at_rest());
  EXPECT_EQ(world.ball(1).velocity, (Vec2{}));
}

TEST(World, RestsBelowRestSpeedOnly) {
  World world = make(cue_table());
  ASSERT_TRUE(world.set_velocity(0, {30, 0}));
  EXPECT_FALSE(world.at_rest());
  ASSERT_TRUE(world.set_velocity(0, {29.999, 0}));
  EXPECT_TRUE(world.at_rest());
}

// By the recipe in the header, a world without balls feeds nine zero bytes.
TEST(StateHash, IsFnv1a) {
  World world = make(table({}));
  std::uint64_t expected = 0xcbf29ce484222325;
  for (int byte = 0; byte < 9; ++byte) expected *= 0x100000001b3;
  EXPECT_EQ(world.state_hash(), expected);
}

TEST(StateHash, DoesNotSeeTheSignOfZero) {
  World a = make(table({ball({100, 100}, {0.0, 5})}));
  World b = make(table({ball({100, 100}, {-0.0, 5})}));
  EXPECT_EQ(a.state_hash(), b.state_hash());
}

TEST(StateHash, SeesEveryField) {
  const carom::Scene scene = table({ball({100, 100}, {3, 5})});
  const auto original = make(scene).state_hash();
  auto changed = [&](auto change) {
    carom::Scene other = scene;
    change(other.balls[0]);
    return make(other).state_hash() != original;
  };
  EXPECT_TRUE(changed([](carom::Ball& b) { b.position.x += 1e-13; }));
  EXPECT_TRUE(changed([](carom::Ball& b) { b.position.y += 1e-13; }));
  EXPECT_TRUE(changed([](carom::Ball& b) { b.velocity.x += 1e-15; }));
  EXPECT_TRUE(changed([](carom::Ball& b) { b.velocity.y += 1e-15; }));
  EXPECT_TRUE(changed([](carom::Ball& b) { b.radius += 1e-14; }));
  EXPECT_TRUE(changed([](carom::Ball& b) { b.solidity = 7; }));
  EXPECT_TRUE(changed([](carom::Ball& b) { b.role = carom::Role::enemy; }));
}

TEST(Trace, HasTheFormOfTheSpec) {
  carom::Scene scene = table({ball({100, 200}, {500, 0}), ball({121, 200})});
  scene.balls[1].solidity = 3000;
  World world = make(scene);
  std::string out;
  carom::append_trace_line(out, world, {});
  EXPECT_EQ(out, "{\"step\":0,\"hash\":\"" + carom::hash_text(world.state_hash()) +
                     "\",\"balls\":["
                     R"({"id":0,"x":100,"y":200,"vx":500,"vy":0,"ax":0,"ay":0,"radius":10,)"
                     R"("solidity":null},)"
                     R"({"id":1,"x":121,"y":200,"vx":0,"vy":0,"ax":0,"ay":0,"radius":10,)"
                     R"("solidity":3000}],"events":[]})"
                     "\n");
  out.clear();
  carom::append_trace_line(out, world, world.step());
  EXPECT_NE(out.find(R"("events":[{"kind":"pair","a":0,"b":1,"dv":[497.5,0]},)"
                     R"({"kind":"damage","ball":1,"ds":1990,"solidity":1010}]})"),
            std::string::npos)
      << out;
}

TEST(Trace, WritesHashesInSixteenDigits) {
  EXPECT_EQ(carom::hash_text(0x1f), "000000000000001f");
  EXPECT_EQ(carom::hash_text(0xfedcba9876543210), "fedcba9876543210");
}

TEST(Run, TakesTheStepsThatStepTakes) {
  World one = worlds::make(worlds::table(
      {worlds::ball({100, 200}, {600, 10}), worlds::ball({300, 205}), worlds::ball({500, 210})}));
  World other = one;
  std::vector<std::pair<std::uint64_t, carom::Event>> expected;
  while (!one.at_rest())
    for (const carom::Event& event : one.step()) expected.emplace_back(one.steps(), event);
  std::vector<std::pair<std::uint64_t, carom::Event>> told;
  const auto sink = [&](std::uint64_t step, std::span<const carom::Event> events) {
    for (const carom::Event& event : events) told.emplace_back(step, event);
  };
  const carom::RunEnd end = other.run({.rest = true}, 100'000, sink);
  EXPECT_EQ(end, (carom::RunEnd{one.steps(), carom::RunEnd::Why::rest}));
  EXPECT_GT(told.size(), 2U);
  EXPECT_EQ(told, expected);
  EXPECT_EQ(other.state_hash(), one.state_hash());
  EXPECT_EQ(other.run({.rest = true}, 10), (carom::RunEnd{0, carom::RunEnd::Why::rest}));
  EXPECT_EQ(other.run({}, 10), (carom::RunEnd{10, carom::RunEnd::Why::steps}));
}

TEST(Run, EndsAfterAnEventOfTheKindsThatAreWanted) {
  const World start =
      worlds::make(worlds::table({worlds::ball({100, 200}, {600, 0}), worlds::ball({300, 200})}));
  using carom::EventKind;
  World world = start;
  const carom::RunEnd first = world.run({.events = EventKind::cushion | EventKind::pair}, 10'000);
  EXPECT_EQ(first.why, carom::RunEnd::Why::event);
  World stepped = start;
  while (stepped.step().empty()) {
  }
  EXPECT_EQ(first.steps, stepped.steps());
  EXPECT_EQ(world.state_hash(), stepped.state_hash());
  world = start;
  EXPECT_EQ(world.run({.events = EventKind::pocketed}, 50),
            (carom::RunEnd{50, carom::RunEnd::Why::steps}));
  EXPECT_EQ(world.run({}, 0).steps, 0U);
}

}  // namespace
