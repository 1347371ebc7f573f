#include "files/files.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

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

TEST_F(Files, ReadsWhatItWrote) {
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

TEST_F(Files, ReplacesWhatALinkPointsTo) {
  ASSERT_TRUE(files::write(folder_ / "file", "old"));
  fs::create_symlink(folder_ / "file", folder_ / "link");
  ASSERT_TRUE(files::write(folder_ / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(files::read(folder_ / "file").value(), "new");
}

TEST_F(Files, TellsWhatCannotBeRead) {
  EXPECT_FALSE(files::read(folder_ / "nothing"));
  EXPECT_FALSE(files::read(folder_)) << "a folder";
}

TEST_F(Files, TellsWhatCannotBeWritten) {
  EXPECT_FALSE(files::write(folder_ / "no" / "folder", "bytes"));
  EXPECT_FALSE(files::write(folder_, "bytes")) << "a folder";
  EXPECT_FALSE(files::write("/dev/full", std::string(100'000, 'x')));
  EXPECT_TRUE(files::write("/dev/null", "bytes"));
  EXPECT_TRUE(fs::is_character_file("/dev/null")) << "a device is written, not replaced";
}

}  // namespace
