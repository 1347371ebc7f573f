#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "replay/recorder.hpp"
#include "replay/replay.hpp"

/// Games to make replays of.
namespace recorded {

namespace angry_balls = games::angry_balls;
namespace billiards = games::billiards;

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline carom::Scene first_steps() {
  return angry_balls::read_level(content(SOURCE_DIR "/levels/01-first-steps.json")).value();
}

/// Three turns of billiards: a shot, one that pockets the cue ball, a placement with a shot.
inline replay::Recorder<billiards::Game> short_billiards() {
  replay::Recorder<billiards::Game> recorder{billiards::Game()};
  const auto play = [&](billiards::Command command) {
    const bool accepted = recorder.apply(command).ok();
    while (recorder.game().phase() == billiards::Phase::roll) recorder.step();
    return accepted;
  };
  play(billiards::Shoot{{-10, 3}});
  const carom::Vec2 cue = recorder.game().world().ball(0).position;
  play(billiards::Shoot{carom::Vec2{10, 10} - cue});
  play(billiards::Place{{200, 100.1}});
  play(billiards::Shoot{{340, 100}});
  return recorder;
}

/// Level 1: two weak throws, some steps of waiting in between, the second left in the middle.
inline replay::Recorder<angry_balls::Game> short_level() {
  replay::Recorder<angry_balls::Game> recorder(angry_balls::Game::create(first_steps()).value());
  static_cast<void>(recorder.apply(angry_balls::Throw{{-20, 0.3}}));
  while (recorder.game().phase() == angry_balls::Phase::fly) recorder.step();
  for (int step = 0; step < 25; ++step) recorder.step();
  static_cast<void>(recorder.apply(angry_balls::Next{}));
  static_cast<void>(recorder.apply(angry_balls::Throw{{120, 31}}));
  for (int step = 0; step < 60; ++step) recorder.step();
  return recorder;
}

inline std::vector<replay::Replay> both() {
  return {short_billiards().replay(), short_level().replay()};
}

/// The part of a replay that a text keeps.
inline replay::Replay with_short_hashes(replay::Replay replay) {
  for (replay::Move& move : replay.moves)
    if (&move != &replay.moves.back()) move.hash &= replay::short_hash_mask;
  replay.short_hashes = true;
  return replay;
}

}  // namespace recorded
