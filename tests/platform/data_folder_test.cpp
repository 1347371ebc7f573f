#include "platform/data_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <sys/wait.h>
#include <unistd.h>

#include "app/storage/best_scores.hpp"
#include "app/storage/kept_games.hpp"
#include "app/storage/settings.hpp"
#include "replay/recorder.hpp"

namespace {

namespace fs = std::filesystem;

class DataFolder : public testing::Test {
 protected:
  DataFolder() { fs::remove_all(folder); }
  ~DataFolder() override { fs::remove_all(folder); }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(folder);
    std::ofstream(folder / name) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(folder / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder =
      fs::path(testing::TempDir()) / ("data-" + std::to_string(::getpid())) / "angry-balls";
  platform::FolderStore store{folder};
};

TEST_F(DataFolder, NothingIsThereAtFirst) {
  const auto loaded = store.load("a.json");
  ASSERT_TRUE(loaded);
  EXPECT_FALSE(loaded.value());
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(DataFolder, ASavedTextIsLoaded) {
  ASSERT_TRUE(store.save("a.json", "one"));
  ASSERT_TRUE(store.save("a.json", "two"));
  EXPECT_EQ(store.load("a.json").value(), "two");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "nothing else is left behind";
}

TEST_F(DataFolder, SetsAsideWithoutOverwriting) {
  write("a.json", "first");
  ASSERT_TRUE(store.set_aside("a.json"));
  write("a.json", "second");
  ASSERT_TRUE(store.set_aside("a.json"));
  EXPECT_EQ(read("a.json.broken"), "first");
  EXPECT_EQ(read("a.json.broken-2"), "second");
  EXPECT_FALSE(store.load("a.json").value());
}

TEST_F(DataFolder, SavesANewFileOnlyWhereNoneIs) {
  EXPECT_TRUE(store.save_new("replays/a.json", "one").value());
  EXPECT_FALSE(store.save_new("replays/a.json", "two").value());
  EXPECT_EQ(read("replays/a.json"), "one");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "replays"), {}), 1)
      << "nothing else is left behind";
}

TEST_F(DataFolder, RemovesHalfWrittenFilesAtTheStart) {
  const ::pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  const std::string left = ".json.part-" + std::to_string(child);
  ASSERT_TRUE(store.save_new("replays/a.json", "x").value());
  for (const char* name : {"scores", "replays/b", "levels/c"}) {
    fs::create_directories((folder / name).parent_path());
    write(name + left, "half");
  }
  const platform::FolderStore next(folder);
  EXPECT_FALSE(fs::exists(folder / ("scores" + left)));
  EXPECT_FALSE(fs::exists(folder / ("replays/b" + left)));
  EXPECT_TRUE(fs::exists(folder / "replays/a.json"));
  EXPECT_TRUE(fs::exists(folder / ("levels/c" + left))) << "the player's own";
}

TEST_F(DataFolder, ListsTheFilesOfAFolderInOrder) {
  EXPECT_TRUE(store.list("replays/").empty());
  for (const char* name : {"replays/b.json", "replays/a.json", "replays/c.txt", "d.json"})
    ASSERT_TRUE(store.save(name, "x"));
  fs::create_directories(folder / "replays" / "folder.json");
  EXPECT_EQ(store.list("replays/"), (std::vector<std::string>{"replays/a.json", "replays/b.json"}));
}

TEST_F(DataFolder, RemovingWorksWhetherTheFileExistsOrNot) {
  ASSERT_TRUE(store.save("a.json", "one"));
  EXPECT_TRUE(store.remove("a.json"));
  EXPECT_TRUE(store.remove("a.json"));
  EXPECT_FALSE(store.load("a.json").value());
}

TEST_F(DataFolder, AHugeFileIsNotRead) {
  write("a.json", "");
  fs::resize_file(folder / "a.json", platform::FolderStore::max_text);
  EXPECT_TRUE(store.load("a.json"));
  fs::resize_file(folder / "a.json", platform::FolderStore::max_text + 1);
  EXPECT_FALSE(store.load("a.json"));
}

TEST_F(DataFolder, KeepsAGameAndSetsABrokenOneAside) {
  write("continue-billiards.json", "{");
  app::KeptGames kept(store);
  EXPECT_FALSE(kept.latest());
  EXPECT_TRUE(kept.take_refused());
  EXPECT_EQ(read("continue-billiards.json.broken"), "{");
  replay::Recorder<games::billiards::Game> game{games::billiards::Game()};
  ASSERT_TRUE(game.apply(games::billiards::Shoot{{20, 1}}));
  while (replay::moves(game.game())) game.step();
  app::KeptGames::Place place;
  ASSERT_TRUE(kept.keep(place, game.replay()));
  app::KeptGames next(store);
  auto latest = next.latest();
  EXPECT_FALSE(next.take_refused());
  ASSERT_TRUE(latest);
  EXPECT_EQ(latest->game, game.replay());
  next.forget(latest->place);
  EXPECT_FALSE(app::KeptGames(store).latest());
}

TEST_F(DataFolder, AFileThatCannotBeReadIsNotRenamed) {
  fs::create_directories(folder / "continue-level-0007.json");  // root reads even mode 000
  app::KeptGames kept(store);
  write("continue-billiards.json", std::string(platform::FolderStore::max_text + 1, ' '));
  EXPECT_FALSE(kept.latest());
  EXPECT_TRUE(fs::exists(folder / "continue-billiards.json"));
  const auto refused = kept.take_refused();
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->set_aside);
  EXPECT_EQ(refused->fault, app::ReplayFault::unreadable);
  EXPECT_FALSE(kept.latest());
  EXPECT_FALSE(kept.take_refused()) << "it is told once";
}

/// Runs `work` in processes of its own, each with a store of the same folder, at the same time.
void in_windows(const fs::path& folder, int count,
                const std::function<void(app::Store&, int)>& work) {
  std::vector<pid_t> windows;
  for (int i = 0; i < count; ++i) {
    const pid_t window = fork();
    if (window == 0) {
      platform::FolderStore store(folder);
      work(store, i);
      _exit(0);
    }
    windows.push_back(window);
  }
  for (const pid_t window : windows) {
    int status = 0;
    EXPECT_EQ(waitpid(window, &status, 0), window);
    EXPECT_EQ(status, 0);
  }
}

std::string identity(int number) {
  std::string digits = std::to_string(number);
  return std::string(16 - digits.size(), '0') + digits;
}

TEST_F(DataFolder, RecordsMadeByThreeWindowsAtOnceAreAllKept) {
  constexpr int records = 40;
  in_windows(folder, 3, [](app::Store& shared, int window) {
    app::BestScores scores(shared);
    for (int i = 0; i < records; ++i) scores.record(identity(window * records + i), 100 + i);
  });
  const app::BestScores scores(store);
  for (int i = 0; i < 3 * records; ++i) EXPECT_TRUE(scores.of(identity(i))) << i;
}

TEST_F(DataFolder, GamesKeptByThreeWindowsAtOnceAreAllKept) {
  in_windows(folder, 3, [](app::Store& shared, int window) {
    app::KeptGames kept(shared);
    for (int i = 0; i < 10; ++i) {
      replay::Recorder<games::billiards::Game> game{games::billiards::Game()};
      static_cast<void>(game.apply(games::billiards::Shoot{{20.0 + window, 1.0 + i}}));
      app::KeptGames::Place place;
      if (!kept.keep(place, game.replay())) _exit(1);
    }
  });
  EXPECT_EQ(app::KeptGames(store).names().size(), 30U);
}

TEST_F(DataFolder, SettingsChangedByThreeWindowsAtOnceAreAllKept) {
  in_windows(folder, 3, [](app::Store& shared, int window) {
    app::KeptSettings kept(shared);
    for (int i = 0; i <= 20; ++i) {
      app::Settings settings = kept.get();
      if (window == 0) settings.volume = i;
      if (window == 1) settings.names[0] = "Zoé " + std::to_string(i);
      if (window == 2) settings.names[1] = "Max " + std::to_string(i);
      kept.set(settings);
    }
  });
  const app::KeptSettings settings(store);
  EXPECT_EQ(settings.get().volume, 20);
  EXPECT_EQ(settings.get().names[0], "Zoé 20");
  EXPECT_EQ(settings.get().names[1], "Max 20");
}

TEST_F(DataFolder, AWindowThatDoesNotLetGoIsNotWaitedForForever) {
  const auto held = store.lock();
  ASSERT_TRUE(held);
  EXPECT_FALSE(store.lock());
}

TEST_F(DataFolder, SettingsLieElsewhere) {
  const fs::path config = folder.parent_path() / "config";
  platform::FolderStore both(folder, config);
  ASSERT_TRUE(both.save("settings.json", "one"));
  ASSERT_TRUE(both.save("a.json", "two"));
  EXPECT_TRUE(fs::exists(config / "settings.json"));
  EXPECT_FALSE(fs::exists(folder / "settings.json"));
  EXPECT_TRUE(fs::exists(folder / "a.json"));
  EXPECT_EQ(both.load("settings.json").value(), "one");
  ASSERT_TRUE(both.set_aside("settings.json"));
  EXPECT_TRUE(fs::exists(config / "settings.json.broken"));
  fs::remove_all(config);
}

TEST_F(DataFolder, AFolderInTheWayIsAnError) {
  fs::create_directories(folder / "a.json");
  EXPECT_FALSE(store.load("a.json"));
  EXPECT_FALSE(store.save("a.json", "x"));
}

TEST_F(DataFolder, AFileInTheFoldersPlaceIsAnError) {
  fs::create_directories(folder.parent_path());
  std::ofstream(folder) << "no folder";
  EXPECT_FALSE(store.save("a.json", "x"));
  fs::remove(folder);
}

TEST_F(DataFolder, KeepsBestScores) {
  write("scores.json", "not ours");
  app::BestScores scores(store);
  EXPECT_TRUE(scores.record("0123456789abcdef", 1200));
  EXPECT_EQ(read("scores.json.broken"), "not ours");
  EXPECT_EQ(app::BestScores(store).of("0123456789abcdef"), 1200);
}

TEST(DataFolderPlace, FollowsTheEnvironment) {
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  const std::string data = std::getenv("XDG_DATA_HOME") ? std::getenv("XDG_DATA_HOME") : "";
  ::setenv("HOME", "/home/someone", 1);
  ::setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(platform::data_folder(), fs::path("/data/angry-balls"));
  for (const char* ignored : {"", "relative"}) {
    ::setenv("XDG_DATA_HOME", ignored, 1);
    EXPECT_EQ(platform::data_folder(), fs::path("/home/someone/.local/share/angry-balls"));
  }
  const std::string config = std::getenv("XDG_CONFIG_HOME") ? std::getenv("XDG_CONFIG_HOME") : "";
  ::setenv("XDG_CONFIG_HOME", "/config", 1);
  EXPECT_EQ(platform::config_folder(), fs::path("/config/angry-balls"));
  ::setenv("XDG_CONFIG_HOME", "relative", 1);
  EXPECT_EQ(platform::config_folder(), fs::path("/home/someone/.config/angry-balls"));
  ::unsetenv("HOME");
  EXPECT_FALSE(platform::data_folder());
  EXPECT_FALSE(platform::config_folder());
  ::setenv("XDG_CONFIG_HOME", config.c_str(), 1);
  ::setenv("HOME", home.c_str(), 1);
  ::setenv("XDG_DATA_HOME", data.c_str(), 1);
}

}  // namespace
