#pragma once

#include <string>

#include "app/storage/kept_games.hpp"
#include "app/storage/saved_replays.hpp"
#include "platform/null_platform.hpp"
#include "require.hpp"

namespace fuzz {

/// Plays a script. Whatever the player does, there is a picture of it, words for it, and what is
/// saved can be read.
inline void play(const platform::Script& script) {
  app::MemoryStore store;
  platform::NullPlatform game(app::Language::fr, 800, 600, {}, store);
  const auto look = [&](const std::string& words) {
    require(!words.empty(), "there are words for what is on screen");
    require(!game.app().draw().vertices.empty(), "there is a picture of it");
  };
  require(game.run(script, look).ok(), "the script is played to its end");
  look(game.app().describe());
  const app::KeptGames kept(store);
  for (const std::string& name : kept.names())
    require(kept.load(name).ok(), "a game kept can be read");
  const app::SavedReplays saved(store);
  for (const std::string& name : saved.names())
    require(saved.load(name).ok(), "a replay saved can be read");
}

}  // namespace fuzz
