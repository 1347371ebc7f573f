// All that is written is read back: replays with whatever their limits allow, in both forms.

#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "carom/display_text.hpp"
#include "carom/scene_file.hpp"
#include "replay/level_text.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace {

namespace billiards = games::billiards;
namespace angry_balls = games::angry_balls;

/// An extreme, a point of the text's grid, or any finite number but 0.
double any_number() {
  using Limits = std::numeric_limits<double>;
  const double sign = *rc::gen::element(1.0, -1.0);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return sign * *rc::gen::element(Limits::max(), Limits::min(), Limits::denorm_min(), 131'072.0,
                                      131'072 - replay::text_grid, replay::text_grid, 1e-7, 0.1);
    case 1:
      return sign * *rc::gen::inRange(1, 10'000'000) * replay::text_grid;
    default: {
      const auto any = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
      return std::isfinite(any) && any != 0 ? any : 1;
    }
  }
}

std::uint64_t any_steps(std::uint64_t most) {
  return std::min(most, *rc::gen::element<std::uint64_t>(0, 1, 127, 128, 16'383, 16'384, most));
}

/// Characters that need care somewhere: in JSON, in a terminal, in UTF-8.
std::string any_name() {
  const auto parts = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "a", " ", "\"", "\\", "/", "\n", "\r", "\x01", std::string(1, '\0'), "\x7f", "é", "\u2028",
      "\u202e", "\ufeff", "\uffff", "\U0001d11e"));
  std::string name;
  for (const std::string& part : parts)
    if (name.size() + part.size() <= 200) name += part;
  return name;
}

carom::Scene any_level() {
  const auto in = [](int low, int high) { return *rc::gen::inRange(low, high) / 8.0; };
  carom::Scene level;
  level.name = any_name();
  level.width = in(1600, 8000);
  level.height = in(1600, 8000);
  level.gravity = in(0, 8000);
  level.throws = *rc::gen::element(1, 3, 1000);
  level.balls = {
      {.role = carom::Role::projectile, .position = {in(100, 500), in(100, 500)}},
      {.role = carom::Role::enemy,
       .position = {in(600, 1500), in(100, 1500)},
       .solidity = *rc::gen::element(0.0, 1e-300, 1000.5, std::numeric_limits<double>::max(),
                                     carom::infinite_solidity)}};
  return level;
}

replay::Replay any_replay() {
  replay::Replay replay;
  const bool table = *rc::gen::arbitrary<bool>();
  const auto score = [] {
    return *rc::gen::element<std::int64_t>(0, 100, std::int64_t{1} << 31, replay::max_score);
  };
  replay.score = {score(), table ? score() : 0};
  if (table)
    replay.options = {.first_player = *rc::gen::inRange(0, 2),
                      .keep_turn = *rc::gen::arbitrary<bool>()};
  else
    replay.level = any_level();
  std::uint64_t left = replay::max_steps;
  for (int moves = *rc::gen::inRange(0, 20); moves > 0; --moves) {
    replay::Move move{.hash = *rc::gen::arbitrary<std::uint64_t>()};
    const carom::Vec2 at{any_number(), any_number()};
    const bool launch = *rc::gen::arbitrary<bool>();
    if (launch) left -= move.steps = any_steps(std::min(left, replay::max_move_steps));
    if (table)
      move.command = launch ? replay::Command(billiards::Shoot{at}) : billiards::Place{at};
    else
      move.command = launch ? replay::Command(angry_balls::Throw{at}) : angry_balls::Next{};
    replay.moves.push_back(move);
  }
  return replay;
}

RC_GTEST_PROP(RoundTrip, OfAnySoundReplayAsJson, ()) {
  const replay::Replay replay = any_replay();
  RC_ASSERT(replay::check(replay).empty());
  const std::string json = replay::write_json(replay);
  const auto read = replay::read_json(json);
  RC_ASSERT(read.ok());
  RC_ASSERT(read.value() == replay);
  RC_ASSERT(replay::write_json(read.value()) == json);
}

RC_GTEST_PROP(RoundTrip, OfAnySoundReplayAsTextAlsoFolded, ()) {
  replay::Replay replay = any_replay();
  const std::string text = replay::write_text(replay);
  for (std::size_t i = 0; i + 1 < replay.moves.size(); ++i)
    replay.moves[i].hash &= replay::short_hash_mask;
  const auto read = replay::read_text(text);
  RC_ASSERT(read.ok());
  replay.short_hashes = read.value().short_hashes;
  RC_ASSERT(read.value() == replay);

  std::string folded =
      *rc::gen::element<std::string>("", "\xEF\xBB\xBF", "> ", "https://x/#replay=");
  const auto width = *rc::gen::inRange<std::size_t>(1, 100);
  const auto fold = *rc::gen::element<std::string>("\n", "\r\n", "=\r\n", "\n> ", " \n", "\n\t");
  for (std::size_t at = 0; at < text.size(); at += width)
    folded += text.substr(at, width) + (at + width < text.size() ? fold : "\n");
  const auto again = replay::read_replay(folded);
  RC_ASSERT(again.ok());
  RC_ASSERT(again.value() == read.value());
}

RC_GTEST_PROP(RoundTrip, OfAnyLevelAsText, ()) {
  const carom::Scene level = any_level();
  const auto read = replay::read_level_text(replay::write_level_text(level));
  RC_ASSERT(read.ok());
  RC_ASSERT(read.value() == level);
}

}  // namespace
