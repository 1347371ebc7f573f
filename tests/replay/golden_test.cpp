#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "replay/games.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> golden_replays() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(SOURCE_DIR "/tests/replays"))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

class Golden : public testing::TestWithParam<fs::path> {};

// They verify for ever: a step or a rule that gives other bits needs a new physics_version or
// rules_version, and then new files.
TEST_P(Golden, VerifiesInBothForms) {
  const std::string json = recorded::content(GetParam());
  const auto read = replay::read_replay(json);
  ASSERT_TRUE(read) << carom::to_string(read.errors().front());
  EXPECT_EQ(replay::write_json(read.value()), json);
  const auto verified = replay::verify(read.value());
  ASSERT_TRUE(verified);
  EXPECT_FALSE(verified.value().divergence()) << to_string(*verified.value().divergence(), 0);

  const std::string text = recorded::content(fs::path(GetParam()).replace_extension(".txt"));
  const auto from_text = replay::read_replay(text);
  ASSERT_TRUE(from_text) << carom::to_string(from_text.errors().front());
  EXPECT_EQ(from_text.value(), recorded::with_short_hashes(read.value()));
  const auto full = replay::with_full_hashes(from_text.value());
  ASSERT_TRUE(full) << carom::to_string(full.errors().front());
  EXPECT_EQ(full.value(), read.value());
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::ValuesIn(golden_replays()), [](const auto& tested) {
  std::string name = tested.param.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(Golden, AreThere) { EXPECT_GE(golden_replays().size(), 6U); }

}  // namespace
