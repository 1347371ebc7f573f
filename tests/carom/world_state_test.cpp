#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "carom/state_bytes.hpp"
#include "carom/world.hpp"
#include "random_worlds.hpp"
#include "worlds.hpp"

namespace {

using carom::Ball;
using carom::World;

std::string text(const carom::Errors& errors) { return carom::to_string(errors.front()); }

World reloaded(const World& world) {
  auto loaded = World::load_state(world.save_state());
  if (!loaded) throw std::invalid_argument(text(loaded.errors()));
  return std::move(loaded).value();
}

TEST(WorldState, ALoadedWorldIsTheSavedOneNowAndAThousandStepsLater) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    World world = worlds::make(random_worlds::scene(seed, 60));
    world.run({}, seed * 7);
    World loaded = reloaded(world);
    ASSERT_EQ(loaded.state_hash(), world.state_hash()) << seed;
    ASSERT_EQ(loaded.steps(), world.steps());
    ASSERT_EQ(loaded.scene(), world.scene());
    ASSERT_EQ(loaded.save_state(), world.save_state());
    world.run({}, 1000);
    loaded.run({}, 1000);
    ASSERT_EQ(loaded.state_hash(), world.state_hash()) << seed;
  }
}

TEST(WorldState, ALeadOutOfPlayStaysOut) {
  World world = worlds::make(worlds::table({{.role = carom::Role::cue, .position = {50, 50}}}));
  ASSERT_TRUE(world.remove(0).ok());
  World loaded = reloaded(world);
  EXPECT_FALSE(loaded.in_play(0));
  EXPECT_EQ(loaded.state_hash(), world.state_hash());
}

TEST(WorldState, ANewIdIsNewAfterLoading) {
  World world = worlds::make(worlds::table({worlds::ball({50, 50}), worlds::ball({90, 50})}));
  ASSERT_TRUE(world.remove(1).ok());
  EXPECT_EQ(reloaded(world).add(worlds::ball({200, 200})).value(), 2U);
}

TEST(WorldState, EveryChangedOrMissingByteIsRefused) {
  World world = worlds::make(worlds::level({worlds::ball({50, 50}), worlds::ball({90, 50})}));
  const std::string state = world.save_state();
  for (std::size_t i = 0; i < state.size(); ++i) {
    std::string changed = state;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_FALSE(World::load_state(changed)) << i;
    EXPECT_FALSE(World::load_state(state.substr(0, i))) << i;
  }
  EXPECT_FALSE(World::load_state(state + '\0'));
}

// The payload of a world with two balls, changed and sealed anew: the checksum is right.
carom::Status loaded_with(std::size_t from_end, const std::string& bytes) {
  World world = worlds::make(worlds::table({worlds::ball({50, 50}), worlds::ball({90, 50})}));
  std::string payload(carom::bytes::unseal('w', world.save_state()).value());
  payload.replace(payload.size() - from_end, bytes.size(), bytes);
  auto loaded = World::load_state(carom::bytes::seal('w', payload));
  if (!loaded) return loaded.errors();
  return carom::Done{};
}

TEST(WorldState, ImpossibleBallsAreRefused) {
  constexpr std::size_t ball = 69;
  const auto number = [](double value) {
    carom::bytes::Writer writer;
    writer.number(value);
    return writer.take();
  };
  EXPECT_TRUE(loaded_with(8, number(3)).ok()) << "the solidity of the last";
  EXPECT_FALSE(loaded_with(8, number(-1)));
  EXPECT_FALSE(loaded_with(8, number(std::nan(""))));
  EXPECT_FALSE(loaded_with(16, number(0))) << "its radius";
  EXPECT_FALSE(loaded_with(64, number(std::nan("")))) << "its x";
  EXPECT_FALSE(loaded_with(64, number(1e300)));
  EXPECT_FALSE(loaded_with(65, "\x05")) << "its role";
  EXPECT_FALSE(loaded_with(65, "\x01")) << "a cue ball that is not the first";
  EXPECT_FALSE(loaded_with(ball, std::string(4, '\0'))) << "the first one's id";
  EXPECT_FALSE(loaded_with(ball, std::string("\x09\0\0\0", 4))) << "an id that was never given";
  EXPECT_FALSE(loaded_with(2 * ball + 8, "\x03")) << "the number of balls";
  EXPECT_FALSE(loaded_with(2 * ball + 21, "\x01")) << "no lead to be out of play";
}

TEST(WorldState, AHeapThatWouldTakeMinutesIsRefused) {
  carom::bytes::Writer out;
  World empty = worlds::make(worlds::table({}));
  std::string payload(carom::bytes::unseal('w', empty.save_state()).value());
  payload.resize(payload.size() - 12);
  out.number(std::uint32_t{5000});
  out.number(std::uint64_t{5000});
  for (std::uint32_t i = 0; i < 5000; ++i) {
    out.number(i);
    out.number(std::uint8_t{0});
    for (const double number : {100.0, 100.0, 0.0, 0.0, 0.0, 0.0, 10.0, 1.0}) out.number(number);
  }
  const auto loaded = World::load_state(carom::bytes::seal('w', payload + out.take()));
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.errors().front().problem.code, carom::MessageCode::has_overlapping_pairs);
}

TEST(WorldEdit, AnAddedBallIsAsIfItHadBeenInTheScene) {
  World whole = worlds::make(
      worlds::table({worlds::ball({50, 50}, {300, 10}), worlds::ball({200, 52}, {-100, 0})}));
  World grown = worlds::make(worlds::table({worlds::ball({50, 50}, {300, 10})}));
  EXPECT_EQ(grown.add(worlds::ball({200, 52}, {-100, 0})).value(), 1U);
  for (int step = 0; step < 500; ++step) {
    ASSERT_EQ(grown.state_hash(), whole.state_hash()) << step;
    whole.step();
    grown.step();
  }
}

// What a step keeps must not outlive the balls that it knows: an edited world goes on as one that
// was loaded, which keeps nothing.
TEST(WorldEdit, AnEditedWorldGoesOnAsALoadedOne) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    World world = worlds::make(random_worlds::scene(seed, seed % 2 == 0 ? 40 : 200));
    random_worlds::Numbers n(seed);
    for (int round = 0; round < 20; ++round) {
      world.run({}, n.below(30));
      const Ball added{.position = {n.uniform(0, 3000), n.uniform(0, 2000)},
                       .radius = n.uniform(1, 200)};
      (void)world.add(added).ok();
      if (world.size() > 1) {
        (void)world.remove(n.below(world.size())).ok();
        const std::size_t index = n.below(world.size());
        Ball changed = world.ball(index);
        changed.radius = n.uniform(1, 60);
        (void)world.set_ball(index, changed).ok();
      }
      World fresh = reloaded(world);
      world.run({}, 20);
      fresh.run({}, 20);
      ASSERT_EQ(world.state_hash(), fresh.state_hash()) << seed << ", round " << round;
    }
  }
}

TEST(WorldEdit, SetBallKeepsIdAndAcceleration) {
  World world = worlds::make(worlds::level({worlds::ball({50, 300}), worlds::ball({90, 300})}));
  world.step();
  const Ball before = world.ball(1);
  ASSERT_TRUE(world.set_ball(1, worlds::ball({200, 200}, {1, 2}, 5)).ok());
  const Ball after = world.ball(1);
  EXPECT_EQ(after.id, before.id);
  EXPECT_EQ(after.acceleration, before.acceleration);
  EXPECT_EQ(after.position, (carom::Vec2{200, 200}));
  EXPECT_EQ(after.radius, 5);
}

TEST(WorldEdit, WrongBallsAreRefusedAndChangeNothing) {
  World world = worlds::make(
      worlds::table({{.role = carom::Role::cue, .position = {50, 50}}, {.position = {300, 300}}}));
  const auto hash = world.state_hash();
  const auto refused = [&](const Ball& ball, const std::string& pointer) {
    const auto added = world.add(ball);
    const auto set = world.set_ball(1, ball);
    ASSERT_FALSE(added);
    ASSERT_FALSE(set);
    EXPECT_EQ(added.errors().front().pointer, pointer);
    EXPECT_EQ(set.errors().front().pointer, pointer);
  };
  refused(worlds::ball({5, 50}), "ball");
  refused(worlds::ball({std::nan(""), 50}), "ball/x");
  refused(worlds::ball({50, 50}, {2e5, 0}), "ball/vx");
  refused(worlds::ball({50, 50}, {}, 0), "ball/radius");
  refused({.role = carom::Role::projectile, .position = {90, 90}}, "ball/role");
  EXPECT_FALSE(world.set_ball(2, worlds::ball({90, 90})));
  EXPECT_FALSE(world.remove(2));
  ASSERT_TRUE(world.remove(0).ok());
  EXPECT_FALSE(world.remove(0)) << "it is out of play";
  EXPECT_FALSE(world.set_ball(0, worlds::ball({90, 90})));
  ASSERT_TRUE(world.place_lead({50, 50}).ok());
  EXPECT_EQ(world.state_hash(), hash);
}

TEST(WorldEdit, ALeadCanBeAddedToAnEmptyWorld) {
  World world = worlds::make(worlds::table({}));
  EXPECT_TRUE(world.add({.role = carom::Role::cue, .position = {50, 50}}).ok());
  EXPECT_TRUE(world.has_lead());
}

TEST(WorldEdit, EventsOfAStepOutliveARemoval) {
  World world = worlds::make(
      worlds::table({worlds::ball({100, 100}, {500, 0}), worlds::ball({121, 100}, {-500, 0})}));
  const auto events = world.step();
  ASSERT_FALSE(events.empty());
  for (const carom::Event& event : events)
    if (const auto index = world.index_of(event.ball)) {
      ASSERT_TRUE(world.remove(*index).ok());
    }
  EXPECT_EQ(events.front().kind, carom::EventKind::pair);
}

}  // namespace
