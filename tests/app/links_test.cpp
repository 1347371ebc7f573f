#include "app/storage/links.hpp"

#include "app/play/session.hpp"
#include "app/player.hpp"
#include "project_file.hpp"
#include "replay/level_text.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace {

const std::string own_level =
    R"({"carom": 1, "name": "Mine", "width": 600, "height": 300, "gravity": 600, "balls": [
      {"x": 100, "y": 12, "role": "projectile"}, {"x": 400, "y": 12, "role": "enemy", "solidity": 900}]})";

struct Links : testing::Test {
  app::MemoryStore store;
  Player game{app::Language::en, 1280, 720, {}, store};
};

TEST_F(Links, ALinkToAReplayShowsItAndProvesIt) {
  const auto replay = replay::read_replay(project_file("tests/replays/level-09-won.json")).value();
  game.app().open_link("#replay=" + replay::write_text(replay));
  game.wait_for("Verified");
  game.key(app::Key::escape);
  EXPECT_TRUE(game.says("title screen"));
}

/// Two files dropped together: the second lies over the first, and the game over none is lost.
TEST_F(Links, AReplayOpenedOverAnotherOrOverTheSettingsLeadsBack) {
  const std::string replay = project_file("tests/replays/level-09-won.json");
  game.press("Billiards");
  const std::string table = game.title();
  for (int i = 0; i < 2; ++i) game.app().open_file("x.json", replay);
  game.key(app::Key::escape);
  EXPECT_NE(game.title(), table);
  game.key(app::Key::escape);
  EXPECT_EQ(game.title(), table);
  game.key(app::Key::settings);
  game.app().open_file("x.json", replay);
  game.key(app::Key::escape);
  EXPECT_TRUE(game.says("Settings")) << game.title();
  game.key(app::Key::escape);
  EXPECT_EQ(game.title(), table);
}

TEST_F(Links, AnOpenedLevelClosesTheHelp) {
  game.key(app::Key::help);
  game.app().open_link("#level=" +
                       replay::write_level_text(games::angry_balls::read_level(own_level).value()));
  game.app().draw();
  EXPECT_TRUE(game.says("Mine")) << game.title();
}

TEST_F(Links, ALinkToALevelPlaysItAndKeepsNothing) {
  const auto level = games::angry_balls::read_level(own_level).value();
  game.app().open_link("#level=" + replay::write_level_text(level));
  EXPECT_TRUE(game.says("Mine")) << game.title();
  EXPECT_TRUE(store.list("levels/").empty());
}

TEST_F(Links, AWrongLinkIsToldOnTheTitleScreen) {
  const std::string right = replay::write_text({});
  const std::string long_one(1 << 20, 'A');
  for (const std::string& link :
       {"#replay=" + right.substr(1), std::string("#replay="), "#level=" + right,
        std::string("#level=%00<script>"), "#replay=" + long_one, "#level=" + long_one}) {
    game.app().open_link(link);
    EXPECT_TRUE(game.says("This link cannot be opened")) << link.substr(0, 40) << game.title();
    game.press("OK");
    EXPECT_TRUE(game.says("title screen"));
  }
}

TEST_F(Links, ALinkToNothingChangesNothing) {
  game.press("Billiards");
  const std::string before = game.title();
  for (const char* link : {"", "#", "#else", "#Replay=x"}) game.app().open_link(link);
  EXPECT_EQ(game.title(), before);
}

TEST_F(Links, AFileIsOpenedByItsContents) {
  game.app().open_file("x.txt", project_file("tests/replays/level-09-won.txt"));
  game.wait_for("Verified");
  game.app().open_file("mine.json", own_level);
  EXPECT_TRUE(game.says("Mine")) << game.title();
  game.app().open_file("mine.json", own_level);
  ASSERT_EQ(store.list("levels/").size(), 1U);
  const auto kept = app::kept_levels(store);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].name, "Mine");
  EXPECT_TRUE(store.list("levels/")[0].ends_with(".angry-level"));
  for (const char* wrong : {"", "{}", "\xff\xfe", "[[[[", "no file of ours"}) {
    game.app().open_file("wrong", wrong);
    EXPECT_TRUE(game.says("This file cannot be opened")) << game.title();
  }
  EXPECT_EQ(store.list("levels/").size(), 1U);
}

TEST_F(Links, ALevelThatAnEarlierVersionSaved_IsNotSavedAgain) {
  const std::string name = "levels/" + app::read_level("mine.json", own_level).identity + ".json";
  ASSERT_TRUE(store.save(name, own_level));
  game.app().open_file("mine.json", own_level);
  EXPECT_EQ(store.list("levels/"), std::vector<std::string>{name});
}

TEST_F(Links, ACopiedReplayIsALinkOnAPage) {
  app::Session session{store, game.clipboard(), {}};
  session.host.link_prefix = "https://example.org/x/";
  const std::string text = replay::write_text({});
  const std::string link = app::shared_text(session, {});
  EXPECT_EQ(link, "https://example.org/x/#replay=" + text);
  session.host = {};
  EXPECT_EQ(app::shared_text(session, {}), text);
  // Either can be pasted anywhere.
  for (const std::string& shared : {text, link}) {
    game.clipboard().set_text(shared);
    EXPECT_TRUE(app::read_pasted(session).replay);
  }
}

}  // namespace
