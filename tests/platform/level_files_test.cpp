#include "platform/level_files.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

class LevelFiles : public testing::Test {
 protected:
  LevelFiles() {
    fs::remove_all(folder);
    fs::create_directories(folder / "inner");
    for (const char* name : {"b.json", "a.json", "inner/c.json"})
      fs::copy_file(SOURCE_DIR "/levels/01-first-steps.json", folder / name);
    std::ofstream(folder / "notes.txt") << "no level";
    std::ofstream(folder / "a.proof.json") << "{}";
    std::ofstream(folder / "pack.json") << "{}";
    std::ofstream(folder / "aa.json") << "{";
  }
  ~LevelFiles() override { fs::remove_all(folder); }

  fs::path folder = fs::path(testing::TempDir()) / ("levels-" + std::to_string(::getpid()));
};

TEST_F(LevelFiles, OfAFolderByName) {
  const auto levels = platform::read_levels(folder);
  ASSERT_EQ(levels.size(), 3u) << "*.json, no proofs, and not those of inner folders";
  EXPECT_TRUE(levels[0].scene);
  EXPECT_FALSE(levels[1].scene);
  EXPECT_TRUE(levels[1].problem.starts_with("aa.json:1:")) << levels[1].problem;
  EXPECT_TRUE(levels[2].scene);
}

TEST_F(LevelFiles, InTheOrderGiven) {
  const auto levels =
      platform::read_levels(std::vector{folder / "inner", folder / "none.json", folder / "a.json"});
  ASSERT_EQ(levels.size(), 3u);
  EXPECT_TRUE(levels[0].scene);
  EXPECT_EQ(levels[1].problem, "none.json: cannot be opened: No such file or directory");
  EXPECT_EQ(levels[1].name, "none");
  EXPECT_TRUE(levels[2].scene);
}

TEST_F(LevelFiles, AnEmptyFolderHasNone) {
  fs::create_directories(folder / "empty");
  EXPECT_TRUE(platform::read_levels(folder / "empty").empty());
}

TEST_F(LevelFiles, AreWatchedForChanges) {
  platform::LevelWatch watch({folder / "inner", folder / "a.json", folder / "none.json"});
  EXPECT_FALSE(watch.changed());
  std::ofstream(folder / "a.json") << "{}";
  EXPECT_TRUE(watch.changed());
  EXPECT_FALSE(watch.changed());
  std::ofstream(folder / "inner/d.angry-level") << "{}";
  EXPECT_TRUE(watch.changed());
  fs::remove(folder / "inner/c.json");
  EXPECT_TRUE(watch.changed());
  std::ofstream(folder / "none.json") << "{}";
  EXPECT_TRUE(watch.changed());
  std::ofstream(folder / "notes.txt") << "not watched";
  EXPECT_FALSE(watch.changed());
}

TEST_F(LevelFiles, ADeviceIsNotALevel) {
  const auto levels = platform::read_levels("/dev/zero");
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_FALSE(levels[0].scene);
}

}  // namespace
