#include "replay/player.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "replay/games.hpp"

namespace {

using namespace recorded;

std::uint64_t hash(const replay::Player& player) {
  return replay::world(player.game()).state_hash();
}

std::string divergence(const replay::Replay& replay) {
  const auto player = replay::verify(replay);
  EXPECT_TRUE(player);
  if (!player || !player.value().divergence()) return "verified";
  return to_string(*player.value().divergence(), player.value().turns().size());
}

TEST(Player, KnowsTheTurnsOfBilliards) {
  const replay::Replay replay = short_billiards().replay();
  const auto player = replay::verify(replay).value();
  const auto& turns = player.turns();
  ASSERT_EQ(turns.size(), 3U) << "a placement is part of its player's turn";
  EXPECT_EQ(player.reached_turns(), 3U);
  EXPECT_EQ(turns[0].first_move, 0U);
  EXPECT_EQ(turns[1].first_move, 1U);
  EXPECT_EQ(turns[2].first_move, 2U);
  EXPECT_EQ(turns[1].first_step, replay.moves[0].steps);
  EXPECT_EQ(turns[2].steps, replay.moves[3].steps);
  EXPECT_EQ(turns[0].player, 0);
  EXPECT_EQ(turns[1].player, 1);
  EXPECT_EQ(turns[2].player, 0);
  EXPECT_EQ(turns[2].score, replay.score);
  std::int64_t points = 0;
  for (const replay::Turn& turn : turns) points += turn.points;
  EXPECT_EQ(points, replay.score[0] + replay.score[1]);
}

TEST(Player, KnowsTheTurnsOfALevel) {
  const replay::Replay replay = short_level().replay();
  const auto player = replay::verify(replay).value();
  ASSERT_EQ(player.turns().size(), 2U);
  EXPECT_EQ(player.turns()[1].first_move, 2U) << "Next ends a turn";
  EXPECT_EQ(player.turns()[1].steps, 60U);
}

TEST(Player, StepsThroughTheWholeGame) {
  for (const replay::Replay& played : both()) {
    auto player = replay::Player::create(played).value();
    std::uint64_t steps = 0;
    EXPECT_EQ(player.steps(), 0U);
    while (player.step()) EXPECT_EQ(player.steps(), ++steps);
    EXPECT_EQ(player.steps(), replay::world(player.game()).steps());
    EXPECT_EQ(hash(player), played.moves.back().hash);
    EXPECT_EQ(replay::score(player.game()), played.score);
    EXPECT_FALSE(player.divergence());
    EXPECT_EQ(player.turn(), player.turns().size() - 1);
  }
}

TEST(Player, GoesToAnyTurnInAnyOrder) {
  for (const replay::Replay& played : both()) {
    auto straight = replay::Player::create(played).value();
    std::vector<std::uint64_t> hashes{hash(straight)};
    for (std::size_t turn = 1; turn < straight.turns().size(); ++turn) {
      ASSERT_TRUE(straight.seek(turn));
      hashes.push_back(hash(straight));
      EXPECT_EQ(straight.steps(), straight.turns()[turn].first_step);
      EXPECT_EQ(straight.turn(), turn);
      EXPECT_EQ(hash(straight), played.moves[straight.turns()[turn].first_move - 1].hash);
    }
    auto player = replay::Player::create(played).value();
    const std::size_t last = player.turns().size();
    for (const std::size_t turn : {last, std::size_t{0}, last - 1, std::size_t{1}, last}) {
      ASSERT_TRUE(player.seek(turn));
      EXPECT_EQ(hash(player), turn == last ? played.moves.back().hash : hashes[turn]);
    }
    EXPECT_FALSE(player.step());
    EXPECT_FALSE(player.seek(last + 1));
    ASSERT_TRUE(player.seek(1));
    while (player.step()) {
    }
    EXPECT_EQ(hash(player), played.moves.back().hash);
  }
}

TEST(Player, ShowsTheEndAfterCommandsWithoutSteps) {
  auto recorder = short_level();
  while (recorder.game().phase() == angry_balls::Phase::fly) recorder.step();
  ASSERT_TRUE(recorder.apply(angry_balls::Next{}));
  auto player = replay::Player::create(recorder.replay()).value();
  while (player.step()) {
  }
  EXPECT_EQ(std::get<angry_balls::Game>(player.game()).phase(), angry_balls::Phase::aim);
  EXPECT_EQ(hash(player), recorder.game().world().state_hash());
}

TEST(Player, LooksAheadInPieces) {
  const replay::Replay replay = short_billiards().replay();
  auto player = replay::Player::create(replay).value();
  int pieces = 1;
  while (player.look_ahead(100)) ++pieces;
  EXPECT_GT(pieces, 3);
  EXPECT_EQ(player.reached_turns(), player.turns().size());
  EXPECT_EQ(player.steps(), 0U) << "what is shown stays";
}

TEST(Player, SeeksInPartsAndShowsNothingOfTheWay) {
  constexpr std::uint64_t part = 50;
  for (const replay::Replay& played : both()) {
    const auto verified = replay::verify(played).value();
    auto player = replay::Player::create(played).value();
    const std::uint64_t start = hash(player);
    const std::size_t end = player.turns().size();
    std::uint64_t parts = 0;
    std::size_t reached = 0;
    while (player.seek(end, part) == replay::Sought::on_way) {
      ++parts;
      ASSERT_EQ(hash(player), start) << "what is shown stays until it is there";
      ASSERT_EQ(player.steps(), 0U);
      ASSERT_GE(player.reached_turns(), reached) << "the progress goes one way";
      reached = player.reached_turns();
    }
    EXPECT_GE(parts, verified.turns().back().first_step / part / 2) << "each part is small";
    EXPECT_EQ(hash(player), played.moves.back().hash);
  }
}

TEST(Player, SeeksAnotherTurnInstead) {
  const replay::Replay played = short_billiards().replay();
  auto player = replay::Player::create(played).value();
  const std::size_t end = player.turns().size();
  ASSERT_EQ(player.seek(end, 10), replay::Sought::on_way);
  while (player.reached_turns() < 2) ASSERT_EQ(player.seek(end, 10), replay::Sought::on_way);
  auto sought = replay::Sought::on_way;
  while (sought == replay::Sought::on_way) sought = player.seek(1, 10);
  EXPECT_EQ(sought, replay::Sought::shown);
  EXPECT_EQ(player.turn(), 1U);
  EXPECT_EQ(player.steps(), player.turns()[1].first_step);
  EXPECT_LT(player.reached_turns(), end) << "nobody waits for the end any more";
  EXPECT_EQ(player.seek(end + 1, 10), replay::Sought::nowhere);
  EXPECT_EQ(player.turn(), 1U);
}

TEST(Player, PlaysAGameWithoutMoves) {
  auto player = replay::verify({}).value();
  EXPECT_TRUE(player.turns().empty());
  EXPECT_FALSE(player.step());
  EXPECT_TRUE(player.seek(0));
  EXPECT_EQ(player.turn(), 0U);
  EXPECT_FALSE(player.divergence());
}

TEST(Verify, NamesTheTurnAndTheStepsOfAnotherHash) {
  replay::Replay replay = short_billiards().replay();
  EXPECT_EQ(divergence(replay), "verified");
  const std::uint64_t first = replay.moves[0].steps;
  const std::uint64_t second = first + replay.moves[1].steps;
  std::get<billiards::Shoot>(replay.moves[1].command).drag.x += 0x1p-20;
  replay.moves[1].hash = 0xfedcba9876543210;
  EXPECT_TRUE(divergence(replay).starts_with(
      "diverged in turn 2 of 3, steps " + std::to_string(first) + " to " + std::to_string(second) +
      ": expected hash fedcba9876543210, got hash "))
      << divergence(replay);
}

TEST(Verify, NoticesATurnOfAnotherLength) {
  replay::Replay longer = short_billiards().replay();
  ++longer.moves[0].steps;
  const std::string text = divergence(longer);
  EXPECT_NE(text.find("diverged in turn 1 of 3"), std::string::npos) << text;
  EXPECT_NE(text.find("expected 1 more steps of this turn, got a game that stands still"),
            std::string::npos)
      << text;
  replay::Replay shorter = short_billiards().replay();
  --shorter.moves[0].steps;
  EXPECT_TRUE(divergence(shorter).starts_with("diverged in turn 1 of 3, steps 0 to "));
}

TEST(Verify, NoticesACommandThatTheRulesRefuse) {
  replay::Replay replay = short_billiards().replay();
  std::get<billiards::Place>(replay.moves[2].command).position = {10, 10};
  const std::string text = divergence(replay);
  EXPECT_NE(text.find("expected \"place\", got its refusal: position: is not free"),
            std::string::npos)
      << text;
}

TEST(Verify, NoticesAnotherScore) {
  replay::Replay replay = short_level().replay();
  replay.score[0] += 100;
  EXPECT_NE(divergence(replay).find(": expected score 100, got score 0"), std::string::npos)
      << divergence(replay);
  replay = {};
  replay.score = {0, 100};
  EXPECT_EQ(divergence(replay),
            "diverged in turn 1 at step 0: expected score 0 : 100, got score 0 : 0");
}

TEST(Verify, ComparesTheKnownBitsOfShortHashes) {
  const replay::Replay full = short_billiards().replay();
  replay::Replay replay = with_short_hashes(full);
  EXPECT_EQ(divergence(replay), "verified");
  EXPECT_EQ(replay::with_full_hashes(replay).value(), full);
  replay.moves[1].hash ^= 1;
  EXPECT_NE(divergence(replay).find("diverged in turn 2 of 3"), std::string::npos);
  EXPECT_NE(divergence(replay).find("expected hash …"), std::string::npos);
  EXPECT_FALSE(replay::with_full_hashes(replay));
  replay = with_short_hashes(full);
  replay.moves.back().hash ^= std::uint64_t{1} << 63;
  EXPECT_NE(divergence(replay).find("diverged in turn 3 of 3"), std::string::npos);
}

TEST(Player, ShowsAGameUpToItsDivergence) {
  replay::Replay replay = short_billiards().replay();
  replay.moves[1].hash ^= 1;
  auto player = replay::Player::create(replay).value();
  std::uint64_t steps = 0;
  while (player.step()) ++steps;
  EXPECT_EQ(steps, replay.moves[0].steps + replay.moves[1].steps);
  EXPECT_TRUE(player.divergence());
  EXPECT_FALSE(player.seek(2));
  EXPECT_TRUE(player.seek(1));
}

TEST(Player, RefusesAnUnsoundReplay) {
  const auto problem = [](const replay::Replay& replay) {
    const auto player = replay::Player::create(replay);
    return player ? "" : carom::to_string(player.errors().front());
  };
  replay::Replay replay = short_level().replay();
  replay.level->friction = 2;
  EXPECT_EQ(problem(replay),
            "/level/friction: is 2; expected a number greater than 0 and at most 1");
  replay.level = games::billiards::rack();
  EXPECT_TRUE(problem(replay).starts_with("/level/balls: have no projectile"));
  replay.level.reset();
  EXPECT_EQ(problem(replay),
            "/moves/0/command: is \"throw\"; expected \"shoot\" or \"place\" in billiards");
  replay = short_billiards().replay();
  std::get<billiards::Shoot>(replay.moves[0].command).drag.x =
      std::numeric_limits<double>::infinity();
  EXPECT_TRUE(problem(replay).starts_with("/moves/0: has a place or drag that is not finite"));
  replay = short_billiards().replay();
  replay.moves[2].steps = 1;
  EXPECT_EQ(problem(replay), "/moves/2/steps: is 1; expected a whole number from 0 to 0");
  replay = short_billiards().replay();
  replay.score[1] = -1;
  EXPECT_TRUE(problem(replay).starts_with("/score/1: is -1"));
  replay.score[1] = 0;
  replay.moves.resize(replay::max_moves + 1);
  EXPECT_TRUE(problem(replay).starts_with("/moves: has 10001 elements"));
  replay.moves.resize(6);
  for (replay::Move& move : replay.moves)
    move = {.command = billiards::Shoot{{1, 1}}, .steps = replay::max_move_steps};
  EXPECT_TRUE(problem(replay).starts_with("/moves/5/steps: makes the game longer than 2000000"));
}

}  // namespace
