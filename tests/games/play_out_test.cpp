#include "games/play_out.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "games/launch.hpp"
#include "games/random.hpp"

namespace {

using carom::Vec2;
using games::Outcome;

bool is_loss(const carom::Event& event) {
  return event.kind == carom::EventKind::pocketed || event.kind == carom::EventKind::destroyed ||
         event.kind == carom::EventKind::left;
}

/// The first turn of a game, told by the game itself.
template <class Game>
Outcome turn_of(Game game, carom::Vec2 drag) {
  using Phase = decltype(game.phase());
  constexpr bool table = std::is_same_v<Game, games::billiards::Game>;
  if constexpr (table)
    EXPECT_TRUE(game.apply(games::billiards::Shoot{drag}));
  else
    EXPECT_TRUE(game.apply(games::angry_balls::Throw{drag}));
  const Phase moving = game.phase();
  Outcome outcome;
  while (game.phase() == moving) {
    game.step();
    for (const carom::Event& event : game.physics_events()) {
      if (is_loss(event) && event.ball != 0) ++outcome.balls_out;
      if (event.kind == carom::EventKind::pair && (event.ball == 0 || event.other == 0))
        outcome.touched = true;
    }
    for (const auto& event : game.events()) outcome.points += event.points;
  }
  if constexpr (table) outcome.foul = game.phase() == Phase::place || !game.world().in_play(0);
  outcome.steps = game.world().steps();
  return outcome;
}

Outcome played_out(const carom::Scene& scene, Vec2 drag) {
  carom::World world = carom::World::create(scene).value();
  return games::play_out(world, games::launch_velocity(drag)).value();
}

Vec2 random_drag(games::Random& random) {
  return {random.uniform(-400, 400), random.uniform(-400, 400)};
}

TEST(PlayOut, EndsAndCountsAsAGameOfBilliardsDoes) {
  games::Random random(1);
  int fouls = 0;
  std::int64_t points = 0;
  const auto compare = [&](const carom::Scene& table, Vec2 drag) {
    const Outcome outcome = played_out(table, drag);
    EXPECT_EQ(outcome, turn_of(games::billiards::Game::create(table).value(), drag));
    fouls += outcome.foul ? 1 : 0;
    points += outcome.points;
  };
  for (int n = 0; n < 20; ++n) compare(games::billiards::rack(), random_drag(random));
  // Few balls, some of them before a hole; an open side; balls that move before the shot.
  for (int n = 0; n < 200; ++n) {
    carom::Scene table = games::billiards::rack();
    table.balls.resize(4);
    table.balls[0].position = {random.uniform(60, 160), random.uniform(60, 340)};
    table.balls[1].position = {36, random.uniform(30, 50)};
    table.balls[2].position = {400, random.uniform(40, 60)};
    table.balls[3].position = {600, 300};
    table.balls[3].velocity = {random.uniform(-300, 300), 0};
    if (n % 4 == 0) table.edges.right = carom::Edge::open;
    if (n % 8 == 0) table.balls.resize(2);
    compare(table, n % 5 == 0 ? random_drag(random) * 0.01 : random_drag(random));
  }
  EXPECT_GT(fouls, 10);
  EXPECT_GT(points, 1000);
}

TEST(PlayOut, EndsAndCountsAsAThrowInEachOfTheLevels) {
  games::Random random(2);
  std::int64_t points = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/levels")) {
    if (entry.path().stem().extension() == ".proof" || entry.path().filename() == "pack.json")
      continue;
    if (entry.path().extension() != ".json") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string json(std::istreambuf_iterator<char>(file), {});
    const carom::Scene level = carom::read_scene(json).value();
    for (int n = 0; n < 10; ++n) {
      const Vec2 drag = random_drag(random);
      const Outcome outcome = played_out(level, drag);
      EXPECT_EQ(outcome, turn_of(games::angry_balls::Game::create(level).value(), drag))
          << entry.path();
      points += outcome.points;
    }
  }
  EXPECT_GT(points, 1000);
}

TEST(PlayOut, RefusesAWorldWithoutLeadAndAVelocityThatIsNone) {
  carom::Scene scene;
  scene.balls = {{.position = {100, 100}}};
  carom::World world = carom::World::create(scene).value();
  EXPECT_FALSE(games::play_out(world, {1, 1}));
  carom::World table = carom::World::create(games::billiards::rack()).value();
  const auto before = table.state_hash();
  EXPECT_FALSE(games::play_out(table, {200'000, 0}));
  EXPECT_EQ(table.state_hash(), before);
  EXPECT_EQ(table.steps(), 0U);
}

}  // namespace
