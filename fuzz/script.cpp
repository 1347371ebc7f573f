#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

#include "play.hpp"

namespace {

// A script may play for a day; here it ends early.
constexpr std::chrono::seconds longest{30};
constexpr std::size_t most_actions = 100;

}  // namespace

// Reads any bytes as a script, and plays it if it is one.
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
  fuzz::play(script);
  return 0;
}
