#include "app/play/foresight.hpp"

#include <gtest/gtest.h>

namespace {

namespace angry_balls = games::angry_balls;
using app::Foresight;
using Ahead = Foresight<angry_balls::Game>;

/// A level that one throw wins.
carom::Scene one_enemy() {
  carom::Scene level;
  level.friction = 1;
  level.balls = {{.role = carom::Role::projectile, .position = {100, 200}},
                 {.role = carom::Role::enemy, .position = {820, 200}, .solidity = 10}};
  level.width = 1000;
  return level;
}

angry_balls::Game thrown(const carom::Scene& level) {
  auto game = angry_balls::Game::create(level).value();
  EXPECT_TRUE(game.apply(angry_balls::Throw{{200, 0}}));
  return game;
}

TEST(Foresight, ADecisiveMomentIsKnownSoManyStepsBefore) {
  auto game = thrown(one_enemy());
  Ahead foresight;
  foresight.begin(game);
  bool known = false;
  for (int i = 0; i < 200 && !known; ++i) {
    game.step();
    known = foresight.step();
  }
  ASSERT_TRUE(known);
  for (std::uint64_t i = 0; i < Ahead::steps; ++i) {
    EXPECT_EQ(game.enemies_left(), 1) << i;
    game.step();
  }
  EXPECT_EQ(game.enemies_left(), 0);
}

TEST(Foresight, BeforeItBeginsAndAfterItEndsNothingIsKnown) {
  auto game = thrown(one_enemy());
  Ahead foresight;
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(foresight.step());
  foresight.begin(game);
  foresight.end();
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(foresight.step());
}

TEST(Foresight, AWorldOfVeryManyBallsIsNotPlayedAhead) {
  carom::Scene level = one_enemy();
  level.height = 2000;
  for (std::size_t i = 0; i < Ahead::most_balls; ++i)
    level.balls.push_back({.position = {20 + 30 * static_cast<double>(i % 25),
                                        500 + 30 * static_cast<double>(i / 25)}});
  Ahead foresight;
  foresight.begin(thrown(level));
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(foresight.step());
}

}  // namespace
