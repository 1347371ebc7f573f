#pragma once

#include <string>

#include "replay/player.hpp"
#include "replay/replay.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"
#include "require.hpp"

namespace fuzz {

/// Properties of any replay that was read: it can be written, in both forms, and read as the
/// same; playing it ends somewhere.
inline void check_replay(const replay::Replay& read) {
  const std::string text = replay::write_text(read);
  const auto from_text = replay::read_text(text);
  require(from_text.ok(), "the text that is written is read");
  require(replay::write_text(from_text.value()) == text, "it is written as the same text");
  require(from_text.value().moves.size() == read.moves.size(), "no move is lost");

  if (!read.short_hashes) {
    const std::string json = replay::write_json(read);
    const auto from_json = replay::read_json(json);
    require(from_json.ok() || json.size() > replay::max_bytes, "the JSON that is written is read");
    if (from_json) {
      require(from_json.value() == read, "it is the same replay");
      require(replay::write_json(from_json.value()) == json, "it is written as the same JSON");
    }
  } else {
    require(from_text.value() == read, "it is the same replay");
  }

  auto player = replay::Player::create(read);
  require(player.ok(), "a replay that is read can be played");
  if (replay::world(player.value().game()).size() > 100) return;
  player.value().look_ahead(200);
  for (int step = 0; step < 20; ++step) player.value().step();
  const std::size_t reached = player.value().reached_turns();
  require(reached == 0 || player.value().seek(reached / 2), "a turn that is reached can be shown");
}

}  // namespace fuzz
