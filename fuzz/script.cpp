#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "app/kept_games.hpp"
#include "app/saved_replays.hpp"
#include "platform/null_platform.hpp"
#include "require.hpp"

namespace {

// A script may play for a day; here it ends early.
constexpr std::chrono::seconds longest{30};
constexpr std::size_t most_actions = 100;

}  // namespace

// Whatever the player does, there is a picture of it, words for it, and what is saved can be read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto read = platform::parse_script({reinterpret_cast<const char*>(data), size});
  if (!read) return 0;
  platform::Script script;
  for (platform::ScriptLine& line : read.value()) {
    if (line.at > longest || script.size() == most_actions) break;
    // No files are written here; the picture is drawn, though.
    if (std::holds_alternative<platform::Screenshot>(line.action)) line.action = platform::Print{};
    script.push_back(std::move(line));
  }
  app::MemoryStore store;
  platform::NullPlatform game(app::Language::french, 800, 600, {}, store);
  const auto look = [&](const std::string& words) {
    fuzz::require(!words.empty(), "there are words for what is on screen");
    fuzz::require(!game.app().draw().vertices.empty(), "there is a picture of it");
  };
  fuzz::require(game.run(script, look).ok(), "the script is played to its end");
  look(game.app().describe());
  fuzz::require(!app::KeptGames(store).take_refused(), "a game kept can be read");
  const app::SavedReplays saved(store);
  for (const std::string& name : saved.names())
    fuzz::require(saved.load(name).ok(), "a replay saved can be read");
  return 0;
}
