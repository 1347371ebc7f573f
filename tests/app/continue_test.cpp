// A game in progress is kept after every launch and turn, and continued bit by bit at the next
// start.

#include "app/greedy_player.hpp"
#include "app/hud/practice_strip.hpp"
#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/storage/kept_games.hpp"
#include "app/view/level_view.hpp"
#include "app/view/table_view.hpp"
#include "project_file.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using replay::Kind;

constexpr int width = 1000;
constexpr int height = 720;
const std::string table_file = "continue-billiards.json";
const std::string level_file = "continue-level.json";

std::optional<std::string> stored(app::Store& store, const std::string& name) {
  return store.load(name).value();
}

/// The names of the games kept.
std::vector<std::string> kept(app::Store& store) { return app::KeptGames(store).names(); }

/// The game kept that was played last; nothing if there is none.
std::optional<std::string> last(app::Store& store) {
  const auto names = kept(store);
  return names.empty() ? std::nullopt : stored(store, names.front());
}

/// One start of the program.
struct Start : Player {
  explicit Start(app::Store& shared, app::Language language = app::Language::en)
      : Player(language, width, height, {}, shared) {}

  app::View view() const { return app::View::of(width, height); }

  void shoot(carom::Vec2 from, carom::Vec2 drag) {
    app::Rect world = app::GameLayout::of(view()).world;
    if (says("practice")) world.cut_bottom(app::PracticeStrip::height(view()));
    const app::Viewport viewport =
        app::table_viewport(world.inset(view().px(8)), games::billiards::rack());
    const app::Point at = viewport.to_window(from);
    click(at);
    click(at + app::Point{viewport.px(drag.x), -viewport.px(drag.y)});
  }
  void watch() {
    for (int i = 0; i < 4000 && says("watches"); ++i) pass(10ms);
    EXPECT_FALSE(says("watches"));
  }
  void throw_by(float x, float y) {
    const carom::Scene level = app::shipped_levels()[0].scene.value();
    const app::Point at = app::level_viewport(app::GameLayout::of(view()).world, level)
                              .to_window(level.balls[0].position);
    click(at);
    click(at + app::Point{x, -y});
  }
  void load(std::string_view offer) {
    press(offer);
    for (int i = 0; i < 1000 && says("Loading"); ++i) pass(10ms);
  }
};

carom::Vec2 cue_of(app::Store& store) {
  auto player = replay::verify(replay::read_json(last(store).value()).value()).value();
  EXPECT_FALSE(player.divergence());
  EXPECT_TRUE(player.seek(player.turns().size()));
  return replay::world(player.game()).ball(0).position;
}

void first_shot(Start& game) {
  game.press("Billiards");
  game.shoot({200, 200}, {-37, 11});
  game.wait_for("Player 2 aims");
}

TEST(Continue, ATableGoesOnBitByBit) {
  app::MemoryStore straight;
  {
    Start game(straight);
    first_shot(game);
    game.shoot(cue_of(straight), {90, 31});
    game.watch();
  }
  app::MemoryStore broken_off;
  {
    Start game(broken_off);
    first_shot(game);
    game.shoot(cue_of(broken_off), {90, 31});
    game.pass(300ms);  // the window is closed while the balls roll
  }
  Start game(broken_off);
  game.load("Continue: billiards, player 2");
  ASSERT_TRUE(game.says("Player 2 watches")) << "the shot cannot be taken back: " << game.title();
  game.watch();
  EXPECT_EQ(last(broken_off), last(straight));
  EXPECT_EQ(kept(broken_off).size(), 1U);
}

TEST(Continue, TellsWhoPlaysOnUnderTheHouseRule) {
  app::MemoryStore store;
  int shots = 0;
  std::string player;
  {
    Start game(store);
    app::Settings settings = game.app().settings().get();
    settings.keep_turn = true;
    game.app().settings().set(settings);
    game.press("Billiards");
    // Until it is not the one whose turn it would be by turns alone.
    for (; shots == 0 || (game.says("Player 2 aims") == (shots % 2 == 1)); ++shots) {
      ASSERT_LT(shots, 20);
      const auto& table = dynamic_cast<const app::BilliardsScreen&>(game.app().screen());
      if (game.says("places")) game.click(greedy::choose_place(table.game(), table.viewport()));
      const auto shot = greedy::choose_shot(table.game(), table.viewport(), 3);
      game.click(shot.grab);
      game.click(shot.target);
      game.watch();
      if (game.says("places")) game.click(greedy::choose_place(table.game(), table.viewport()));
    }
    player = game.says("Player 2 aims") ? "2" : "1";
  }
  Start game(store);
  EXPECT_FALSE(game.shows("player " + player)) << "it is not known before the game was played";
  for (int i = 0; i < 1000 && game.app().animating(); ++i) game.pass(10ms);
  EXPECT_FALSE(game.app().animating());
  EXPECT_TRUE(game.shows("Continue: billiards, player " + player));
}

TEST(Continue, ALevelGoesOnBitByBit) {
  const auto begin = [](Start& game) {
    game.press("Angry Balls");
    game.press("First steps");
    game.throw_by(-60, 10);
    game.wait_for("next throw");
  };
  const auto end = [](Start& game) {
    game.key(app::Key::n);
    game.throw_by(-50, 20);
    game.wait_for("next throw");
  };
  app::MemoryStore straight;
  Start whole(straight);
  begin(whole);
  end(whole);
  app::MemoryStore broken_off;
  {
    Start game(broken_off);
    begin(game);
  }
  Start game(broken_off);
  game.load("Continue: level 1");
  ASSERT_TRUE(game.says("First steps")) << game.title();
  EXPECT_TRUE(game.says("throws left: 2"));
  end(game);
  EXPECT_EQ(last(broken_off), last(straight));
}

TEST(Continue, ALevelThatIsNoLongerOnOffer) {
  app::MemoryStore store;
  replay::Replay kept =
      replay::read_json(project_file("tests/replays/level-random-lost.json")).value();
  kept.moves.resize(1);
  auto player = replay::Player::create(kept).value();
  while (player.step()) {
  }
  kept = replay::read_json(project_file("tests/replays/level-random-lost.json")).value();
  kept.moves.resize(1);
  kept.score = replay::score(player.game());
  ASSERT_TRUE(store.save(level_file, replay::write_json(kept)));
  Start game(store);
  game.load("Continue: Random");
  EXPECT_TRUE(game.says("Level 11: “Random”")) << game.title();
}

TEST(Continue, ALevelWithoutANameIsOfferedAllTheSame) {
  app::MemoryStore store;
  replay::Replay kept =
      replay::read_json(project_file("tests/replays/level-random-lost.json")).value();
  kept.level->name.clear();
  ASSERT_TRUE(store.save(level_file, replay::write_json(kept)));
  Start game(store);
  EXPECT_TRUE(game.shows("Continue: Unnamed level"));
}

TEST(Continue, LeavingKeepsTheGameWithNoQuestion) {
  app::MemoryStore store;
  Start game(store);
  first_shot(game);
  const auto before = last(store);
  game.leave();
  EXPECT_TRUE(game.says("title screen")) << game.title();
  EXPECT_EQ(last(store), before);
  game.load("Continue: billiards, player 2");
  EXPECT_TRUE(game.says("Player 2 aims"));
  game.press("Leave");
  EXPECT_TRUE(game.shows("Continue: billiards, player 2"));

  game.press("Angry Balls");
  game.press("First steps");
  game.throw_by(-60, 10);
  game.pass(100ms);
  game.leave();
  EXPECT_TRUE(game.says("level menu")) << game.title();
  game.key(app::Key::escape);
  EXPECT_TRUE(game.shows("Continue: level 1")) << "the game played last";
  game.load("Continue: level 1");
  EXPECT_TRUE(game.says("throws left: 2")) << "leaving takes no throw back";
  EXPECT_TRUE(game.says("watching the throw"));
  EXPECT_EQ(kept(store).size(), 2U);
}

TEST(Continue, ALaunchIsKeptWhenItIsMade) {
  app::MemoryStore store;
  {
    Start game(store);
    game.press("Billiards");
    game.shoot({200, 200}, {-37, 11});
  }
  const auto kept_shot = replay::read_json(last(store).value()).value();
  ASSERT_EQ(kept_shot.moves.size(), 1U);
  EXPECT_EQ(kept_shot.moves[0].steps, 0U);
  Start game(store);
  game.load("Continue: billiards, player 1");
  ASSERT_TRUE(game.says("Player 1 watches")) << game.title();
  game.wait_for("Player 2 aims");
  app::MemoryStore straight;
  Start whole(straight);
  first_shot(whole);
  EXPECT_EQ(last(store), last(straight));
}

TEST(Continue, ANewGameLeavesTheOthersAlone) {
  app::MemoryStore store;
  {
    Start game(store);
    first_shot(game);
    game.leave();
  }
  const auto first = last(store);
  Start game(store);
  EXPECT_FALSE(game.shows("Saved games"));
  game.press("Billiards");
  EXPECT_TRUE(game.says("Player 1 aims")) << game.title();
  game.shoot({200, 200}, {-80, 3});
  game.watch();
  game.leave();
  ASSERT_EQ(kept(store).size(), 2U);
  EXPECT_EQ(stored(store, kept(store)[1]), first);

  game.press("Saved games");
  EXPECT_TRUE(game.says("games: 2")) << game.title();
  const auto names = kept(store);
  game.press("Delete");  // the lower one: the first game
  EXPECT_TRUE(game.says("Delete this game?"));
  game.press("Cancel");
  EXPECT_EQ(kept(store), names);
  game.press("1 turn");
  for (int i = 0; i < 1000 && game.says("Loading"); ++i) game.pass(10ms);
  EXPECT_TRUE(game.says("aims")) << game.title();
  game.leave();
  game.press("Saved games");
  game.press("Delete");
  game.key(app::Key::enter);  // the first button
  EXPECT_TRUE(game.says("games: 1")) << game.title();
  EXPECT_EQ(kept(store), std::vector{names[0]});
}

TEST(Continue, ARestartGivesTheGameUpOnceTheNewOneHasALaunch) {
  app::MemoryStore store;
  Start game(store);
  first_shot(game);
  const auto first = last(store);
  game.press("Restart");
  game.press("Keep playing");
  game.press("Restart");
  game.press("New game");
  EXPECT_EQ(last(store), first);
  game.shoot({200, 200}, {-80, 3});
  EXPECT_NE(last(store), first);
  EXPECT_EQ(kept(store).size(), 1U);
}

TEST(Continue, TwoWindowsThatGoOnWithTheSameGameKeepBoth) {
  app::MemoryStore store;
  {
    Start game(store);
    first_shot(game);
  }
  const carom::Vec2 cue = cue_of(store);
  Start one(store);
  Start two(store);
  one.load("Continue: billiards");
  two.load("Continue: billiards");
  one.shoot(cue, {44, -60});
  one.watch();
  const auto by_one = last(store);
  two.shoot(cue, {90, 31});
  two.watch();
  ASSERT_EQ(kept(store).size(), 2U);
  EXPECT_NE(last(store), by_one);
  EXPECT_EQ(stored(store, kept(store)[1]), by_one);
  // And the other way round: who began the game plays on while another window continues it.
  Start three(store);
  three.load("Continue: billiards");
  const auto by_two = last(store);
  for (Start* game : {&three, &two}) {
    SCOPED_TRACE(game->title());
    const auto& table = dynamic_cast<const app::BilliardsScreen&>(game->app().screen());
    if (game->says("places")) game->click(greedy::choose_place(table.game(), table.viewport()));
    const auto shot = greedy::choose_shot(table.game(), table.viewport(), 3);
    game->click(shot.grab);
    game->click(shot.target);
    EXPECT_TRUE(game->says("watches")) << game->title();
    game->watch();
  }
  EXPECT_EQ(kept(store).size(), 3U);
}

TEST(Continue, AFileThatCannotBeReadStaysInItsPlace) {
  struct ShutStore : app::MemoryStore {
    carom::Result<std::optional<std::string>> load(const std::string& name) override {
      if (shut && name == table_file)
        return carom::Error{.pointer = name, .problem = "cannot be read"};
      return MemoryStore::load(name);
    }
    bool shut = true;
  } store;
  ASSERT_TRUE(
      store.save(table_file, project_file("tests/replays/billiards-left-in-the-middle.json")));
  {
    Start game(store);
    EXPECT_TRUE(game.shows("Its file stays as it is."));
    game.press("OK");
    first_shot(game);
  }
  store.shut = false;
  EXPECT_FALSE(stored(store, table_file + ".broken"));
  EXPECT_EQ(stored(store, table_file),
            project_file("tests/replays/billiards-left-in-the-middle.json"));
  EXPECT_EQ(kept(store).size(), 2U);
}

TEST(Continue, AFinishedLevelIsNoLongerOffered) {
  app::MemoryStore store;
  Start game(store);
  game.press("Angry Balls");
  game.press("First steps");
  for (int i = 0; i < 3; ++i) {
    game.throw_by(-60, 10);
    game.wait_for(i == 2 ? "click to end" : "next throw");
    EXPECT_TRUE(last(store));
    game.key(app::Key::n);
  }
  EXPECT_TRUE(game.says("Level lost"));
  EXPECT_FALSE(last(store));
}

TEST(Continue, PracticeKeepsNothing) {
  app::MemoryStore store;
  Start game(store);
  game.press("Practice");
  ASSERT_TRUE(game.says("practice"));
  game.shoot({200, 200}, {-37, 11});
  game.wait_for("Player 1 aims");
  const auto& table = dynamic_cast<const app::BilliardsScreen&>(game.app().screen());
  game.shoot(table.game().world().ball(0).position, {13, -70});
  EXPECT_TRUE(game.says("Player 1 watches")) << "who practises alone has every turn";
  EXPECT_TRUE(kept(store).empty());
  game.press("Leave");
  EXPECT_TRUE(game.says("title screen"));
}

TEST(Continue, ADiskThatCannotBeWrittenIsTold) {
  struct FullStore : app::MemoryStore {
    carom::Status save(const std::string&, const std::string&) override {
      return carom::Error{.problem = "cannot be written"};
    }
    carom::Result<bool> save_new(const std::string&, const std::string&) override {
      return carom::Error{.problem = "cannot be written"};
    }
  } store;
  Start game(store);
  game.press("Billiards");
  game.shoot({200, 200}, {-37, 11});
  game.pass(500ms);
  EXPECT_TRUE(game.shows("This game cannot be saved"));
}

// Twenty ways in which a file can be wrong.

std::string sound() { return project_file("tests/replays/billiards-left-in-the-middle.json"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A replay as it would be written if its moves were these, checksum included.
std::string rewritten(void (*change)(replay::Replay&)) {
  replay::Replay replay = replay::read_json(sound()).value();
  change(replay);
  return replay::write_json(replay);
}

std::vector<std::string> broken_saves() {
  const std::string text = sound();
  std::string flipped = text;
  flipped[text.size() / 2] = static_cast<char>(flipped[text.size() / 2] ^ 1);
  std::vector<std::string> saves{
      "",
      "{",
      "null",
      "[1, 2]",
      std::string(3, '\0'),
      "\xff\xfe{\0}",
      text.substr(0, text.size() - 3),
      text.substr(0, text.size() / 2),
      text.substr(1),
      text + "x",
      text + text,
      flipped,
      replaced(text, "\"angry-balls-replay\": 1", "\"angry-balls-replay\": 2"),
      replaced(text, "\"physics\": 1", "\"physics\": 2"),
      replaced(text, "\"rules\": 1", "\"rules\": 99999999999999999999"),
      replaced(text, "\"game\": \"billiards\"", "\"game\": \"chess\""),
      replaced(text, "\"steps\": ", "\"steps\": 1"),
      std::string(1'000'000, '['),
      std::string(5'000'000, ' ') + text,
      project_file("tests/replays/level-01-won.json"),
      project_file("scenes/break.json"),
      project_file("tests/replays/billiards-left-in-the-middle.txt"),
      // Whole, but no game goes that way, or it is over: found out when it is continued.
      rewritten([](replay::Replay& replay) { replay.moves[0].hash ^= 1; }),
      rewritten([](replay::Replay& replay) { replay.moves[0].steps += 1; }),
      rewritten([](replay::Replay& replay) { replay.score[1] += 100; }),
      rewritten([](replay::Replay& replay) {
        replay.moves.insert(replay.moves.begin(), {games::billiards::Place{{1, 1}}, 0, 0});
      }),
      project_file("tests/replays/billiards-whole.json"),
  };
  return saves;
}

class BrokenSave : public testing::TestWithParam<std::size_t> {};

TEST_P(BrokenSave, IsRefusedSetAsideAndNeverOverwritten) {
  const std::string broken = broken_saves()[GetParam()];
  for (const auto language : {app::Language::en, app::Language::fr}) {
    const bool french = language == app::Language::fr;
    app::MemoryStore store;
    ASSERT_TRUE(store.save(table_file, broken));
    Start game(store, language);
    if (game.shows(french ? "Reprendre : billard" : "Continue: billiards")) {
      game.press(french ? "Reprendre : billard" : "Continue: billiards");
      for (int i = 0; i < 100; ++i) game.pass(10ms);
    }
    EXPECT_TRUE(game.says(french ? "Billard : pas de reprise" : "Billiards: not continued"))
        << game.title();
    EXPECT_TRUE(game.shows("continue-billiards.json.broken"));
    EXPECT_FALSE(stored(store, table_file));
    EXPECT_EQ(stored(store, table_file + ".broken"), broken);
    game.press("OK");
    EXPECT_TRUE(game.says(french ? "écran titre" : "title screen"));
    if (french) continue;
    first_shot(game);
    EXPECT_EQ(kept(store).size(), 1U);
    EXPECT_EQ(stored(store, table_file + ".broken"), broken);
  }
}

INSTANTIATE_TEST_SUITE_P(All, BrokenSave, testing::Range(std::size_t{0}, broken_saves().size()));

TEST(BrokenSaves, AFileThatCannotBeMovedIsNeverOverwritten) {
  struct FixedStore : app::MemoryStore {
    carom::Status set_aside(const std::string&) override {
      return carom::Error{.problem = "cannot be moved"};
    }
  } store;
  ASSERT_TRUE(store.save(table_file, "{"));
  Start game(store);
  EXPECT_TRUE(game.shows("Its file stays as it is."));
  game.press("OK");
  first_shot(game);
  EXPECT_EQ(stored(store, table_file), "{");
  game.press("Leave");
  EXPECT_EQ(stored(store, table_file), "{");
  EXPECT_TRUE(game.shows("Continue: billiards, player 2"));
}

}  // namespace
