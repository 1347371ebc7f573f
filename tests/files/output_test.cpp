#include "files/output.hpp"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

class OutputTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              (std::string("output-test-") + info->name() + "-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ / name; }
  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name)) << bytes;
  }
  std::string get(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static carom::Status write(const std::string& to, const std::string& bytes) {
    files::Output output(to);
    output.write(bytes);
    return output.commit();
  }

  fs::path folder_;
};

TEST_F(OutputTest, WritesInPlace) {
  put("file", "a long old content");
  ASSERT_EQ(::chmod(path("file").c_str(), 0600), 0);
  fs::create_hard_link(path("file"), path("hard"));
  fs::create_symlink(path("file"), path("link"));
  ASSERT_TRUE(write(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(get("file"), "new");
  EXPECT_EQ(get("hard"), "new");
  struct ::stat status {};
  ASSERT_EQ(::stat(path("file").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0600U);
}

TEST_F(OutputTest, ChangesNothingBeforeTheFirstWrite) {
  put("file", "old");
  {
    const files::Output output(path("file"));
    EXPECT_TRUE(output.opened());
    EXPECT_EQ(output.replaced_size(), 3U);
  }
  EXPECT_EQ(get("file"), "old");
  {
    const files::Output output(path("new"));
    EXPECT_TRUE(output.opened());
    EXPECT_EQ(output.replaced_size(), std::nullopt);
  }
  EXPECT_FALSE(fs::exists(path("new"))) << "not committed";
}

TEST_F(OutputTest, TakesLongNames) {
  const std::string name(250, 'n');
  ASSERT_TRUE(write(path(name), "bytes"));
  EXPECT_EQ(get(name), "bytes");
}

TEST_F(OutputTest, CreatesTheTargetOfALink) {
  fs::create_symlink(path("file"), path("link"));
  ASSERT_TRUE(write(path("link"), "bytes"));
  EXPECT_EQ(get("file"), "bytes");
}

TEST_F(OutputTest, KeepsTheOutputOfADescriptor) {
  for (const int flags : {O_APPEND, O_TRUNC, 0}) {
    const int descriptor = ::open(path("log").c_str(), O_WRONLY | O_CREAT | flags, 0666);
    ASSERT_GE(descriptor, 0);
    ASSERT_EQ(::write(descriptor, "log\n", 4), 4);
    const std::string name = "/dev/fd/" + std::to_string(descriptor);
    fs::create_symlink(name, path("link"));
    EXPECT_EQ(files::own_descriptor(path("link")), descriptor);
    ASSERT_TRUE(write(path("link"), "one\n"));
    ASSERT_TRUE(write(name, "two\n"));
    EXPECT_EQ(get("log"), "log\none\ntwo\n") << flags;
    ::close(descriptor);
    fs::remove(path("link"));
    fs::remove(path("log"));
  }
}

TEST_F(OutputTest, KnowsItsOwnDescriptors) {
  EXPECT_EQ(files::own_descriptor("-"), 1);
  EXPECT_EQ(files::own_descriptor("/dev/stdout"), 1);
  EXPECT_EQ(files::own_descriptor("/dev/stderr"), 2);
  EXPECT_EQ(files::own_descriptor("/proc/self/fd/7"), 7);
  EXPECT_EQ(files::own_descriptor("/dev/null"), std::nullopt);
  EXPECT_EQ(files::own_descriptor(path("1")), std::nullopt);
  fs::create_symlink(path("loop"), path("loop"));
  EXPECT_EQ(files::own_descriptor(path("loop")), std::nullopt);
}

TEST_F(OutputTest, RefusesAnInput) {
  put("file", "input");
  fs::create_hard_link(path("file"), path("hard"));
  fs::create_symlink(path("file"), path("link"));
  const int descriptor = ::open(path("file").c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(descriptor, 0);
  const std::array inputs{path("other"), path("link")};
  for (const std::string& name :
       {path("file"), path("hard"), path("link"), "/dev/fd/" + std::to_string(descriptor)}) {
    files::Output output(name, inputs);
    EXPECT_FALSE(output.opened()) << name;
    output.write("lost");
    EXPECT_FALSE(output.commit());
    EXPECT_EQ(get("file"), "input") << name;
  }
  ::close(descriptor);
  const std::array devices{std::string("/dev/null")};
  EXPECT_TRUE(files::Output("/dev/null", devices).opened());
}

TEST_F(OutputTest, ReportsAFileThatCannotBeWritten) {
  EXPECT_FALSE(files::Output(path("no") + "/folder").opened());
  EXPECT_FALSE(files::Output(folder_).opened());
  EXPECT_FALSE(files::Output("").opened());
  EXPECT_FALSE(files::Output("/dev/fd/987").opened());
  EXPECT_FALSE(write("/dev/full", std::string(100'000, 'x')));
  EXPECT_FALSE(write("/dev/full", "x"));
  EXPECT_TRUE(write("/dev/null", "x"));
  const int descriptor = ::open("/dev/null", O_RDONLY);
  EXPECT_FALSE(files::Output("/dev/fd/" + std::to_string(descriptor)).opened()) << "to be read";
  ::close(descriptor);
}

TEST_F(OutputTest, LeavesNothingWhenASignalEndsIt) {
  for (const int signal : {SIGINT, SIGTERM}) {
    put("old", "old");
    for (const bool exists : {false, true}) {
      const std::string name = path(exists ? "old" : "new");
      const ::pid_t child = ::fork();
      ASSERT_GE(child, 0);
      if (child == 0) {
        files::Output output(name);
        if (!exists) output.write(std::string(100'000, 'x'));
        ::raise(signal);
        ::_exit(9);
      }
      int status = 0;
      ASSERT_EQ(::waitpid(child, &status, 0), child);
      ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    }
    EXPECT_FALSE(fs::exists(path("new"))) << signal;
    EXPECT_EQ(get("old"), "old") << signal;
  }
}

}  // namespace
