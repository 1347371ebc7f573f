#include "replay/recorder.hpp"

#include <gtest/gtest.h>

#include "games/random.hpp"
#include "replay/games.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"
#include "soak/random_game.hpp"

namespace {

using namespace recorded;

void expect_verified(const replay::Replay& replay) {
  const auto verified = replay::verify(replay);
  ASSERT_TRUE(verified) << carom::to_string(verified.errors().front());
  EXPECT_FALSE(verified.value().divergence())
      << to_string(*verified.value().divergence(), verified.value().turns().size());
}

TEST(Recorder, WritesDownBilliards) {
  const auto recorder = short_billiards();
  const replay::Replay replay = recorder.replay();
  EXPECT_EQ(replay.kind(), replay::Kind::billiards);
  ASSERT_EQ(replay.moves.size(), 4U);
  EXPECT_EQ(replay.moves[0].command, replay::Command(billiards::Shoot{{-10, 3}}));
  EXPECT_EQ(replay.moves[2].command, replay::Command(billiards::Place{{200, 100.1}}));
  EXPECT_EQ(replay.moves[2].steps, 0U);
  EXPECT_EQ(replay.moves[0].steps + replay.moves[1].steps + replay.moves[3].steps,
            recorder.game().world().steps());
  EXPECT_EQ(replay.moves[3].hash, recorder.game().world().state_hash());
  EXPECT_EQ(replay.score[0], recorder.game().score(0));
  EXPECT_EQ(replay.score[1], recorder.game().score(1));
  expect_verified(replay);
}

TEST(Recorder, WritesDownALevelWithTheStepsOfWaiting) {
  const auto recorder = short_level();
  const replay::Replay replay = recorder.replay();
  EXPECT_EQ(replay.level, first_steps());
  ASSERT_EQ(replay.moves.size(), 3U);
  EXPECT_GT(replay.moves[0].steps, 25U);
  EXPECT_EQ(replay.moves[1].command, replay::Command(angry_balls::Next{}));
  EXPECT_EQ(replay.moves[1].steps, 0U);
  EXPECT_EQ(replay.moves[2].steps, 60U) << "left in the middle";
  expect_verified(replay);
}

TEST(Recorder, GivesAReplayAtAnyTime) {
  replay::Recorder<billiards::Game> recorder{billiards::Game()};
  expect_verified(recorder.replay());
  ASSERT_TRUE(recorder.apply(billiards::Shoot{{300, 5}}));
  expect_verified(recorder.replay());
  for (int step = 0; step < 10; ++step) {
    recorder.step();
    expect_verified(recorder.replay());
  }
}

TEST(Recorder, DoesNotRecordCommandsThatTheGameRefuses) {
  replay::Recorder<billiards::Game> recorder{billiards::Game()};
  EXPECT_FALSE(recorder.apply(billiards::Place{{100, 100}}));
  EXPECT_FALSE(recorder.apply(billiards::Shoot{{0, 0}}));
  recorder.step();
  EXPECT_TRUE(recorder.replay().moves.empty());
}

TEST(Recorder, RestartBeginsAnotherReplay) {
  auto recorder = short_level();
  ASSERT_TRUE(recorder.apply(angry_balls::Restart{}));
  EXPECT_TRUE(recorder.replay().moves.empty());
  EXPECT_EQ(recorder.replay().level, first_steps());
  ASSERT_TRUE(recorder.apply(angry_balls::Throw{{155, -14}}));
  recorder.step();
  EXPECT_EQ(recorder.replay().moves.size(), 1U);
  expect_verified(recorder.replay());
}

TEST(Recorder, ACopyTakesATurnBack) {
  auto recorder = short_billiards();
  const auto before = recorder;
  ASSERT_TRUE(recorder.apply(billiards::Shoot{{-100, 40}}));
  for (int step = 0; step < 30; ++step) recorder.step();
  EXPECT_NE(recorder.replay(), before.replay());
  recorder = before;
  EXPECT_EQ(recorder.replay(), before.replay());
  ASSERT_TRUE(recorder.apply(billiards::Shoot{{-100, 41}}));
  recorder.step();
  expect_verified(recorder.replay());
}

TEST(Recorder, GoesOnWithASavedGame) {
  const replay::Replay kept = short_billiards().replay();
  auto player = replay::verify(kept).value();
  ASSERT_TRUE(player.seek(player.turns().size()));
  replay::Recorder<billiards::Game> recorder(std::get<billiards::Game>(player.game()), kept);
  EXPECT_EQ(recorder.replay(), kept);
  ASSERT_TRUE(recorder.apply(billiards::Shoot{{-100, 40}}));
  recorder.step();
  EXPECT_EQ(recorder.replay().moves.size(), 5U);
  expect_verified(recorder.replay());
}

TEST(Recorder, TellsWhenTheNextStepWouldGoBeyondTheLimits) {
  const auto recorder = short_level();
  EXPECT_TRUE(recorder.has_room());
  replay::Replay longest = recorder.replay();
  longest.moves.back().steps = replay::max_move_steps - 1;
  EXPECT_TRUE(replay::Recorder(recorder.game(), longest).has_room());
  longest.moves.back().steps = replay::max_move_steps;
  EXPECT_TRUE(check(longest).empty());
  EXPECT_FALSE(replay::Recorder(recorder.game(), longest).has_room());

  longest.moves.assign(replay::max_steps / replay::max_move_steps + 1, longest.moves[0]);
  for (replay::Move& move : longest.moves) move.steps = replay::max_move_steps;
  longest.moves.back().steps = replay::max_steps % replay::max_move_steps;
  EXPECT_TRUE(check(longest).empty());
  EXPECT_FALSE(replay::Recorder(recorder.game(), longest).has_room());
  --longest.moves.back().steps;
  EXPECT_TRUE(replay::Recorder(recorder.game(), longest).has_room());
}

/// Whole random games: played, written in both forms, read, played again.
TEST(Recorder, WritesDownTheOptionsOfBilliards) {
  for (const billiards::Options options :
       {billiards::Options{}, {.first_player = 1}, {.keep_turn = true}, {1, true}}) {
    games::Random random(4);
    replay::Recorder<billiards::Game> recorder{billiards::Game(options)};
    while (recorder.game().phase() != billiards::Phase::over) {
      if (const auto command = soak::random_command(recorder.game(), random)) {
        ASSERT_TRUE(recorder.apply(*command));
      }
      recorder.step();
    }
    const replay::Replay replay = recorder.replay();
    EXPECT_EQ(replay.options, options);
    for (const std::string& written : {replay::write_json(replay), replay::write_text(replay)}) {
      const auto read = replay::read_replay(written);
      ASSERT_TRUE(read) << carom::to_string(read.errors().front());
      EXPECT_EQ(read.value().options, options);
      auto player = replay::verify(read.value());
      ASSERT_TRUE(player);
      EXPECT_FALSE(player.value().divergence());
      ASSERT_TRUE(player.value().seek(player.value().turns().size()));
      const auto& played = std::get<billiards::Game>(player.value().game());
      for (int of = 0; of < 2; ++of) EXPECT_EQ(played.tally(of), recorder.game().tally(of));
      EXPECT_EQ(player.value().turns().front().player, options.first_player);
      // By other rules the points fall to other players.
      replay::Replay other = read.value();
      other.options.keep_turn = !options.keep_turn;
      EXPECT_TRUE(replay::verify(other).value().divergence());
    }
    ASSERT_TRUE(recorder.apply(billiards::Restart{}));
    EXPECT_EQ(recorder.replay().options, options);
  }
}

TEST(Recorder, AGameBeyondTheLimitsIsFoundOut) {
  replay::Replay replay = short_level().replay();
  EXPECT_TRUE(check(replay).empty());
  replay.moves[0].steps = replay::max_move_steps + 1;
  EXPECT_EQ(check(replay).size(), 1U);
}

}  // namespace
