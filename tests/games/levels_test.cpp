#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "games/angry_balls.hpp"
#include "games/level_check.hpp"
#include "project_file.hpp"

namespace {

using carom::Vec2;
using games::angry_balls::Game;
using games::angry_balls::Next;
using games::angry_balls::Phase;
using games::angry_balls::Throw;

const std::filesystem::path folder = std::filesystem::path(SOURCE_DIR) / "levels";

std::vector<std::filesystem::path> level_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".proof" &&
        entry.path().filename() != "pack.json")
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class Level : public testing::TestWithParam<std::filesystem::path> {
 protected:
  static carom::Scene scene() {
    std::ifstream file(GetParam(), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    auto read = carom::read_scene(bytes);
    if (!read) throw std::invalid_argument(carom::to_string(read.errors()[0], GetParam().string()));
    return std::move(read).value();
  }
};

TEST(Levels, AreAtLeastEightWithNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const auto& file : level_files()) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    names.insert(carom::read_scene(bytes).value().name);
  }
  EXPECT_GE(level_files().size(), 8U);
  EXPECT_EQ(names.size(), level_files().size());
  EXPECT_FALSE(names.contains(""));
}

TEST_P(Level, HasNothingToWarnOf) {
  for (const carom::Error& warning : games::angry_balls::level_warnings(scene()))
    ADD_FAILURE() << carom::to_string(warning);
}

TEST(OriginalLevels, AreWonByTheirRecordedThrows) {
  int won = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(SOURCE_DIR "/tests/levels/original")) {
    if (entry.path().extension() != ".throws") continue;
    const std::string name = entry.path().stem().string() + ".json";
    Game game = Game::create(carom::read_scene(project_file("levels/" + name)).value()).value();
    std::ifstream file(entry.path());
    for (Vec2 drag; file >> drag.x >> drag.y;) {
      if (game.phase() == Phase::offer) {
        ASSERT_TRUE(game.apply(Next{}));
      }
      ASSERT_TRUE(game.apply(Throw{drag}));
      while (game.phase() == Phase::fly) game.step();
    }
    EXPECT_EQ(game.phase(), Phase::won) << name;
    ++won;
  }
  EXPECT_EQ(won, 10);
}

void expect_sound(const carom::World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!world.in_play(i)) continue;
    const carom::Ball ball = world.ball(i);
    // Comparisons that NaN fails.
    ASSERT_TRUE(std::abs(ball.position.x) < 1e5 && ball.position.y < 1e5);
    ASSERT_TRUE(carom::length(ball.velocity) < 1e5);
    ASSERT_GE(ball.position.y, ball.radius) << "below the floor";
    for (const carom::Obstacle& obstacle : world.scene().obstacles) {
      const double reach = (obstacle.radius + ball.radius) * (1 - 1e-12);
      if (ball.position.y < obstacle.height)
        ASSERT_GE(std::abs(ball.position.x - obstacle.x), reach) << "inside a wall";
      else
        ASSERT_GE(carom::length(ball.position - Vec2{obstacle.x, obstacle.height}), reach)
            << "inside a cap";
    }
  }
}

TEST_P(Level, StaysSoundIn1000RandomThrows) {
  const Game fresh = Game::create(scene()).value();
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  Game game = fresh;
  for (int n = 0; n < 1000; ++n) {
    if (game.phase() == Phase::won || game.phase() == Phase::lost) game = fresh;
    ASSERT_TRUE(game.apply(Throw{{uniform(-400, 400), uniform(-400, 400)}}));
    std::uint64_t steps = 0;
    while (game.phase() == Phase::fly) {
      game.step();
      ASSERT_LE(++steps, games::angry_balls::offer_steps) << "the turn does not end";
      expect_sound(game.world());
      if (HasFatalFailure()) return;
    }
    if (game.phase() == Phase::offer) {
      ASSERT_TRUE(game.apply(Next{}));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Level, testing::ValuesIn(level_files()), [](const auto& level) {
  std::string name = level.param.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
