#include "files/files.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A folder of its own for every test, gone afterwards.
class Files : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              (std::string("files-test-") + info->name() + "-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(Files, ReadsAFileThatItWrote) {
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(files::write(folder_ / "new", bytes));
  EXPECT_EQ(files::read(folder_ / "new").value(), bytes);
  EXPECT_EQ(entries(), 1U) << "nothing is left aside";
}

TEST_F(Files, KeepsTheOldFileUntilTheCommit) {
  ASSERT_TRUE(files::write(folder_ / "file", "old"));
  {
    files::Writer writer(folder_ / "file");
    writer.write("new");
    EXPECT_EQ(files::read(folder_ / "file").value(), "old");
  }
  EXPECT_EQ(files::read(folder_ / "file").value(), "old") << "never committed";
  EXPECT_EQ(entries(), 1U);
  ASSERT_TRUE(files::write(folder_ / "file", "new"));
  EXPECT_EQ(files::read(folder_ / "file").value(), "new");
}

TEST_F(Files, ReplacesTheTargetOfALink) {
  ASSERT_TRUE(files::write(folder_ / "file", "old"));
  fs::create_symlink(folder_ / "file", folder_ / "link");
  ASSERT_TRUE(files::write(folder_ / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(files::read(folder_ / "file").value(), "new");
}

TEST_F(Files, ReportsAFileThatCannotBeRead) {
  EXPECT_FALSE(files::read(folder_ / "nothing"));
  EXPECT_FALSE(files::read(folder_)) << "a folder";
}

TEST_F(Files, ReportsAFileThatCannotBeWritten) {
  EXPECT_FALSE(files::write(folder_ / "no" / "folder", "bytes"));
  EXPECT_FALSE(files::write(folder_, "bytes")) << "a folder";
  EXPECT_FALSE(files::write("/dev/null", "bytes")) << "a device";
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, KeepsThePermissionsOfAReplacedFile) {
  ASSERT_TRUE(files::write(folder_ / "file", "old"));
  fs::permissions(folder_ / "file", fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(files::write(folder_ / "file", "new"));
  EXPECT_EQ(fs::status(folder_ / "file").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Files, RefusesTooLargeFilesUnread) {
  ASSERT_TRUE(files::write(folder_ / "file", "12345"));
  EXPECT_TRUE(files::read(folder_ / "file", 5));
  EXPECT_FALSE(files::read(folder_ / "file", 4));
  EXPECT_FALSE(files::read("/dev/zero", 100'000));
}

TEST_F(Files, ReadsATextUpToAZeroByte) {
  const auto text = files::read_text("/dev/zero");
  ASSERT_TRUE(text) << "without end otherwise";
  EXPECT_LT(text.value().size(), 1U << 20);
}

TEST_F(Files, WritesANewFileOnlyWhereNoneIs) {
  EXPECT_TRUE(files::write_new(folder_ / "file", "one").value());
  EXPECT_FALSE(files::write_new(folder_ / "file", "two").value());
  EXPECT_EQ(files::read(folder_ / "file").value(), "one");
  EXPECT_EQ(entries(), 1U) << "nothing is left aside";
  EXPECT_FALSE(files::write_new(folder_ / "no" / "folder", "bytes"));
}

TEST_F(Files, RemovesOnlyHalfWrittenFilesOfKilledProcesses) {
  const ::pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // Killed in the middle, as it were: nothing is committed, nothing cleared away.
    files::Writer writer(folder_ / "save.json");
    writer.write("half");
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const std::string dead = std::to_string(child);
  ASSERT_EQ(entries(), 1U);
  const std::string aside = fs::directory_iterator(folder_)->path().filename();
  ASSERT_TRUE(aside.starts_with("save.json.part-" + dead + "-")) << aside;

  const std::string alive = "save.json.part-" + std::to_string(::getpid());
  const std::vector<std::string> others{alive,
                                        "save.json",
                                        "video.part-" + dead,
                                        "save.json.part-",
                                        ".part-" + dead,
                                        "save.json.part-0x10",
                                        "save.json.part--" + dead,
                                        "save.json.part-0",
                                        "save.json.part",
                                        "save.json-" + dead,
                                        "save.json.part-" + dead + "~",
                                        "save.json.part-" + dead + "-0123456",
                                        "save.json.part-" + dead + "-0123456g"};
  for (const std::string& name : others) std::ofstream(folder_ / name) << "x";
  fs::create_directory(folder_ / ("folder.json.part-" + dead));
  files::remove_abandoned(folder_, ".json");
  EXPECT_FALSE(fs::exists(folder_ / aside));
  for (const std::string& name : others) EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_EQ(entries(), others.size() + 1);
  files::remove_abandoned(folder_ / "nothing", ".json");
}

}  // namespace
