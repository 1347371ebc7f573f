#include <gtest/gtest.h>
#include <string>

#include "games/random.hpp"
#include "replay/games.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace {

using namespace recorded;

// Changes, removes, adds, doubles or swaps a few bytes.
std::string mutated(std::string text, games::Random& random) {
  for (auto times = 1 + random.below(3); times > 0 && !text.empty(); --times) {
    const std::size_t at = random.below(text.size());
    const std::size_t length = 1 + random.below(8);
    const char c =
        random.one_in(4) ? static_cast<char>(random.below(256)) : text[random.below(text.size())];
    switch (random.below(6)) {
      case 0:
        text[at] = c;
        break;
      case 1:
        text[at] = static_cast<char>(text[at] ^ 1 << random.below(8));
        break;
      case 2:
        text.insert(at, 1, c);
        break;
      case 3:
        text.erase(at, length);
        break;
      case 4:
        text.insert(at, text.substr(random.below(text.size()), length));
        break;
      default:
        std::swap(text[at], text[random.below(text.size())]);
    }
  }
  return text;
}

int accepted_of_1000(const replay::Replay& original, const std::string& written,
                     std::uint64_t seed) {
  games::Random random(seed);
  int verified = 0;
  for (int n = 0; n < 1000; ++n) {
    const std::string changed = mutated(written, random);
    const auto full = [&]() -> carom::Result<replay::Replay> {
      auto read = replay::read_replay(changed);
      return read ? replay::with_full_hashes(std::move(read).value()) : read;
    }();
    if (!full) continue;
    ++verified;
    EXPECT_EQ(full.value(), original) << "accepted as verified:\n" << changed;
  }
  return verified;
}

TEST(Mutation, NoJsonIsVerifiedAsAnotherGame) {
  for (const replay::Replay& original : both())
    // White space may change.
    EXPECT_LT(accepted_of_1000(original, replay::write_json(original), 1), 300);
}

TEST(Mutation, NoTextIsVerifiedAsAnotherGame) {
  for (const replay::Replay& original : both())
    // A mutation may swap equals, or add white space at an end.
    EXPECT_LT(accepted_of_1000(original, replay::write_text(original), 2), 50);
}

}  // namespace
