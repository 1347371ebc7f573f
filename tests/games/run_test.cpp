#include <array>
#include <cstdint>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"

namespace {

namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;

template <class Event>
std::vector<Event> list(std::span<const Event> events) {
  return {events.begin(), events.end()};
}

/// Runs one game in parts of random lengths and steps the other as often; both are equal after
/// every part, and where a run ends early, something is told.
template <class Game>
void let_roll(Game& run, Game& stepped, std::mt19937& random) {
  const auto phase = run.phase();
  while (run.phase() == phase) {
    const std::uint64_t most = 1 + random() % 400;
    const std::uint64_t taken = run.run(most);
    ASSERT_TRUE(taken > 0U);
    ASSERT_TRUE(taken <= most);
    for (std::uint64_t i = 1; i < taken; ++i) {
      stepped.step();
      ASSERT_TRUE(stepped.events().empty());
    }
    stepped.step();
    ASSERT_TRUE(taken == most || !run.events().empty());
    ASSERT_TRUE(list(run.events()) == list(stepped.events()));
    ASSERT_TRUE(list(run.physics_events()) == list(stepped.physics_events()));
    ASSERT_TRUE(run.save_state() == stepped.save_state());
    if (phase != run.phase() || run.world().steps() > 20'000) break;
  }
  ASSERT_TRUE(run.phase() == stepped.phase());
}

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

/// Also one so weak that all is at rest at once.
carom::Vec2 drag(std::mt19937& random) {
  constexpr std::array most{4.0, 60.0, 400.0};
  const double long_as = most[random() % most.size()];
  return {uniform(random, -long_as, long_as), uniform(random, -long_as, long_as)};
}

void play_table(std::uint32_t seed) {
  std::mt19937 random(seed);
  billiards::Options options;
  options.rack = billiards::Rack::quick;
  options.keep_turn = seed % 2 == 0;
  options.touch_red = seed % 3 == 0;
  billiards::Game run(options);
  billiards::Game stepped = run;
  for (int turn = 0; turn < 6 && run.phase() != billiards::Phase::over; ++turn) {
    if (run.phase() == billiards::Phase::place) {
      carom::Vec2 at;
      do at = {uniform(random, 20, 780), uniform(random, 20, 380)};
      while (run.obstruction(at) != billiards::Obstruction::none);
      ASSERT_TRUE(run.apply(billiards::Place{at}).ok());
      ASSERT_TRUE(stepped.apply(billiards::Place{at}).ok());
    }
    const carom::Vec2 shot = drag(random);
    ASSERT_TRUE(run.apply(billiards::Shoot{shot}).ok());
    ASSERT_TRUE(stepped.apply(billiards::Shoot{shot}).ok());
    let_roll(run, stepped, random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

void play_level(std::uint32_t seed) {
  std::mt19937 random(seed);
  constexpr std::array names{"01-first-steps", "05-over-the-wall", "09-the-crown"};
  const std::string name = names[seed % names.size()];
  std::ifstream file(SOURCE_DIR "/levels/" + name + ".json");
  ASSERT_TRUE(file.good());
  const std::string text(std::istreambuf_iterator<char>(file), {});
  auto run = angry_balls::Game::create(angry_balls::read_level(text).value()).value();
  auto stepped = run;
  while (run.phase() == angry_balls::Phase::aim) {
    const carom::Vec2 thrown = drag(random);
    ASSERT_TRUE(run.apply(angry_balls::Throw{thrown}).ok());
    ASSERT_TRUE(stepped.apply(angry_balls::Throw{thrown}).ok());
    let_roll(run, stepped, random);
    if (testing::Test::HasFatalFailure()) return;
    if (run.phase() == angry_balls::Phase::offer) {
      // What still moves goes on for as long as the player waits.
      const std::uint64_t wait = 1 + random() % 300;
      for (std::uint64_t waited = 0; waited < wait && run.phase() == angry_balls::Phase::offer;) {
        const std::uint64_t taken = run.run(wait - waited);
        for (std::uint64_t i = 0; i < taken; ++i) stepped.step();
        waited += taken;
      }
      ASSERT_TRUE(run.save_state() == stepped.save_state());
      if (run.phase() == angry_balls::Phase::offer) {
        ASSERT_TRUE(run.apply(angry_balls::Next{}).ok());
        ASSERT_TRUE(stepped.apply(angry_balls::Next{}).ok());
      }
    }
  }
}

TEST(Run, OfAnyGame_GivesTheSameBitsAndEventsAsSteps) {
  for (std::uint32_t seed = 0; seed < 60 && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE(seed);
    play_table(seed);
    play_level(seed);
  }
}

TEST(Run, WhereNothingMoves_TakesNoStep) {
  billiards::Game game;
  EXPECT_EQ(game.run(100), 0U);
  ASSERT_TRUE(game.apply(billiards::Shoot{{100, 0}}));
  EXPECT_EQ(game.run(0), 0U);
  EXPECT_EQ(game.phase(), billiards::Phase::roll);
}

}  // namespace
