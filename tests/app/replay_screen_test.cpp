#include "app/screens/replay_screen.hpp"

#include "app/graphics/palette.hpp"
#include "app/player.hpp"
#include "app/screens/timeline.hpp"
#include "project_file.hpp"
#include "replay/replay_file.hpp"
#include "replay/replay_text.hpp"

namespace {

using namespace std::chrono_literals;
using app::Key;

replay::Replay sound(const std::string& name) {
  return replay::read_replay(replay_file(name)).value();
}

class ReplayScreenTest : public testing::TestWithParam<const char*> {
 protected:
  explicit ReplayScreenTest(replay::Replay shown) : replay(std::move(shown)) {
    screen.resize(app::View::of(1280, 720));
  }
  ReplayScreenTest() : ReplayScreenTest(sound(GetParam())) {}

  app::Navigation key(Key key) {
    return screen.event(*app::KeyBindings{}.meaning(app::KeyPressed{key}));
  }
  void look_ahead() {
    for (int i = 0; i < 10'000 && screen.describe().find("Verifying") != std::string::npos; ++i)
      screen.iterate(0ns);
  }
  std::uint64_t hash() const { return replay::world(screen.player().game()).state_hash(); }
  bool says(const std::string& text) const {
    return screen.describe().find(text) != std::string::npos;
  }
  /// Hash of the state before the turn.
  std::uint64_t hash_before(std::size_t turn) const {
    const std::size_t move = screen.player().turns()[turn].first_move;
    if (move > 0) return replay.moves[move - 1].hash;
    return replay::world(replay::start(replay).value()).state_hash();
  }

  replay::Replay replay;
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, {}};
  app::ReplayScreen screen{app::Words(app::Language::en), session,
                           replay::Player::create(replay).value()};
};

TEST_P(ReplayScreenTest, GoesToEveryTurnBitByBit) {
  look_ahead();
  key(Key::space);
  EXPECT_TRUE(says("Verified")) << screen.describe();
  EXPECT_TRUE(says("paused"));
  const std::size_t turns = screen.player().turns().size();
  for (std::size_t turn = 0; turn < turns; ++turn) {
    EXPECT_EQ(screen.player().turn(), turn);
    EXPECT_EQ(hash(), hash_before(turn)) << "turn " << turn;
    key(Key::right);
  }
  EXPECT_EQ(hash(), replay.moves.back().hash);
  key(Key::right);
  EXPECT_EQ(hash(), replay.moves.back().hash);
  for (std::size_t turn = turns; turn-- > 0;) {
    key(Key::left);
    EXPECT_EQ(hash(), hash_before(turn)) << "turn " << turn;
  }
  key(Key::left);
  EXPECT_EQ(screen.player().steps(), 0u);
}

TEST_P(ReplayScreenTest, PlaysToTheEndAtEverySpeed) {
  for (int faster = 0; faster < 5; ++faster) {
    for (int i = 0; i < 100'000 && says("playing"); ++i) screen.iterate(16ms);
    EXPECT_EQ(hash(), replay.moves.back().hash);
    EXPECT_TRUE(says("paused"));
    EXPECT_FALSE(says("diverged"));
    key(Key::plus);
    key(Key::space);  // from the start again
    EXPECT_EQ(screen.player().steps(), 0u);
    EXPECT_TRUE(says("playing"));
    if (std::string_view(GetParam()).starts_with("billiards-whole")) break;
  }
}

TEST_P(ReplayScreenTest, StepsOneByOne) {
  key(Key::space);
  auto other = replay::Player::create(replay).value();
  for (int i = 0; i < 100; ++i) {
    key(Key::period);
    ASSERT_TRUE(other.step());
    EXPECT_EQ(screen.player().steps(), other.steps());
    EXPECT_EQ(hash(), replay::world(other.game()).state_hash());
  }
}

TEST_P(ReplayScreenTest, SpeedIsWhatItSays) {
  const auto steps_in_a_second = [&] {
    const auto before = screen.player().steps();
    for (int i = 0; i < 100; ++i) screen.iterate(10ms);
    return screen.player().steps() - before;
  };
  for (int i = 0; i < 9; ++i) key(Key::minus);
  EXPECT_TRUE(says("playing ×¼"));
  EXPECT_EQ(steps_in_a_second(), 25u);
  key(Key::plus);
  EXPECT_EQ(steps_in_a_second(), 50u);
  key(Key::plus);
  EXPECT_EQ(steps_in_a_second(), 100u);
}

TEST_P(ReplayScreenTest, IsSavedUnderANameOfItsOwnAndCopiedAsText) {
  ASSERT_TRUE(store.save("replays/replay-0004.json", "mine"));
  const auto press = [&](std::string_view text) {
    app::Atlas atlas;
    app::Font font{atlas};
    app::DrawList list;
    const app::View view = app::View::of(1280, 720);
    app::Canvas canvas{list, font, view};
    screen.draw(canvas);
    for (const app::Box& box : list.boxes) {
      if (box.kind != app::Box::Kind::button || box.text != text) continue;
      screen.event(app::PointerPressed{box.area.center()});
      screen.event(app::PointerReleased{box.area.center()});
      return;
    }
    ADD_FAILURE() << "no button " << text;
  };
  press("Save");
  press("Save");
  EXPECT_EQ(store.load("replays/replay-0004.json").value(), "mine");
  const std::string json = replay::write_json(replay);
  EXPECT_EQ(store.load("replays/replay-0005.angry-replay").value(), json);
  EXPECT_EQ(store.load("replays/replay-0006.angry-replay").value(), json);
  press("Copy");
  EXPECT_EQ(clipboard.text(), replay::write_text(replay));
}

TEST_P(ReplayScreenTest, OneFromATextIsSavedWithAllBits) {
  app::ReplayScreen pasted{
      app::Words(app::Language::en), session,
      replay::Player::create(replay::read_replay(replay::write_text(replay)).value()).value()};
  pasted.resize(app::View::of(800, 600));
  for (int i = 0; i < 10'000; ++i) {
    pasted.iterate(0ns);
    if (pasted.describe().find("Verifying") == std::string::npos) break;
  }
  for (int i = 0; i < 7; ++i) pasted.event(app::KeyPressed{Key::tab});
  pasted.event(app::KeyPressed{Key::enter});
  EXPECT_EQ(store.load("replays/replay-0001.angry-replay").value(), replay::write_json(replay));
}

TEST(SavedReplays, OfBothEndings_AreListedAndReadEach) {
  app::MemoryStore store;
  const std::string won = project_file("tests/replays/level-09-won.json");
  const std::string table = project_file("tests/replays/billiards-whole.json");
  ASSERT_TRUE(store.save("replays/a.angry-replay", won));
  ASSERT_TRUE(store.save("replays/a.json", table));
  ASSERT_TRUE(store.save("replays/b.json", table));
  ASSERT_TRUE(store.save("replays/c.angry-level", "{}"));
  const app::SavedReplays saved(store);
  EXPECT_EQ(saved.names(), (std::vector<std::string>{"a", "a.json", "b"}));
  EXPECT_TRUE(saved.load("a").value().level);
  EXPECT_FALSE(saved.load("a.json").value().level);
  EXPECT_FALSE(saved.load("b").value().level);
  EXPECT_FALSE(saved.load("c"));
}

INSTANTIATE_TEST_SUITE_P(All, ReplayScreenTest,
                         testing::Values("billiards-whole.json",
                                         "billiards-left-in-the-middle.json", "level-06-won.json",
                                         "level-random-lost.json"));

struct Diverging : ReplayScreenTest {
  Diverging() : ReplayScreenTest(sound("diverging/another-hash.json")) {}
};

TEST_F(Diverging, TellsTheTurnAndShowsNothingBeyond) {
  look_ahead();
  EXPECT_TRUE(says("Diverged in turn 5")) << screen.describe();
  for (int i = 0; i < 20; ++i) key(Key::right);
  EXPECT_TRUE(says("Turn 5 of 7")) << screen.describe();
  key(Key::left);
  EXPECT_EQ(screen.player().turn(), 4u);
  key(Key::space);
  EXPECT_TRUE(says("playing"));
}

/// The timeline of a window of 1280 × 720.
app::Rect timeline() {
  const app::View view = app::View::of(1280, 720);
  app::Rect bottom = view.area();
  bottom = bottom.cut_bottom(view.button(40) + view.px(84));
  return app::centered(bottom.center(), std::min(bottom.w, view.px(1120)), bottom.h)
      .inset(view.px(8), view.px(6))
      .cut_top(view.px(24));
}
/// A place on it, from 0 to 1.
app::Point at(float part) {
  const app::Rect all = timeline();
  return {all.x + part * all.w, all.center().y};
}
const app::Point late = at(0.98f);

struct LongGame : ReplayScreenTest {
  LongGame() : ReplayScreenTest(sound("billiards-whole.json")) {}
};

TEST_F(LongGame, ShowsItsTurnsAndPointsOnAPhoneToo) {
  look_ahead();
  app::Atlas atlas;
  app::Font font{atlas};
  for (const auto& [width, height] : {std::pair{1280, 720}, {390, 844}, {320, 568}}) {
    const app::View view = app::View::of(width, height);
    screen.resize(view);
    app::DrawList list;
    app::Canvas canvas{list, font, view};
    screen.draw(canvas);
    const auto lit = std::ranges::count_if(list.vertices, [&](const app::Vertex& vertex) {
      return vertex.position.y > view.height / 2 && vertex.color == app::palette::brass_lit;
    });
    EXPECT_GT(lit, 40) << width;
  }
}

TEST_F(LongGame, IsSoughtInPartsWithItsProgressInSight) {
  const auto drawn = [&] {
    app::Atlas atlas;
    app::Font font{atlas};
    app::DrawList list;
    const app::View view = app::View::of(1280, 720);
    app::Canvas canvas{list, font, view};
    screen.draw(canvas);
    return list.vertices;
  };
  key(Key::space);
  screen.event(app::PointerPressed{late, app::PointerButton::left});
  EXPECT_FALSE(says("Turn 1 ")) << screen.describe();
  EXPECT_EQ(screen.player().steps(), 0U) << "it takes longer than a picture";
  const std::size_t wanted = app::turn_at(timeline(), screen.player(), late);
  int pictures = 0;
  int changes = 0;
  for (auto before = drawn(); screen.player().turn() != wanted && pictures < 1'000; ++pictures) {
    screen.iterate(0ns);
    auto after = drawn();
    const bool changed =
        !std::ranges::equal(before, after, {}, &app::Vertex::color, &app::Vertex::color);
    changes += changed ? 1 : 0;
    before = std::move(after);
  }
  EXPECT_GT(pictures, 2);
  EXPECT_GT(changes, 2) << "the timeline shows how far it is";
  EXPECT_EQ(hash(), hash_before(wanted));
}

TEST_F(LongGame, IsSoughtElsewhereInstead) {
  key(Key::space);
  screen.event(app::PointerPressed{late, app::PointerButton::left});
  while (screen.player().reached_turns() < 10) screen.iterate(0ns);
  ASSERT_EQ(screen.player().turn(), 0U) << "still on the way";
  screen.event(app::PointerPressed{at(0.02f), app::PointerButton::left});
  screen.iterate(0ns);
  EXPECT_LT(screen.player().turn(), 4U);
  EXPECT_GT(screen.player().turn(), 0U);
  EXPECT_TRUE(says("Verifying")) << "the end is not waited for";
}

TEST(Replays, ALongSearchIsLeftAtOnce) {
  app::MemoryStore store;
  Player game(app::Language::en, 1280, 720, {}, store);
  game.app().open_file("x.json", replay_file("billiards-whole.json"));
  game.key(Key::space);
  game.click(late);
  EXPECT_TRUE(game.says("Verifying")) << game.title();
  EXPECT_FALSE(game.says("Turn 1 ")) << game.title();
  game.key(Key::escape);
  EXPECT_TRUE(game.says("title screen")) << game.title();
}

TEST(Replays, AreWatchedAfterAGameAndFromTheList) {
  const std::string easy = R"({"carom": 1, "name": "Easy", "width": 1000, "height": 500,
    "balls": [{"x": 110, "y": 120, "role": "projectile", "radius": 12},
              {"x": 200, "y": 120, "role": "enemy", "solidity": 10}]})";
  Player game(app::Language::en, 1000, 720, {app::read_level("easy.json", easy)});
  game.press("Angry Balls");
  game.press("Easy");
  game.pass(3s);
  // The projectile lies at (110, 120) of a level that is shown pixel by pixel.
  const app::GameLayout layout = app::GameLayout::of(app::View::of(1000, 720));
  const app::Point at{layout.world.center().x - 500 + 110, 0};
  for (float y = layout.world.y; y < layout.world.bottom(); y += 10) {
    if (!game.says("click the angry ball")) break;
    game.click({at.x, y});
    game.click({at.x + 300, y});
  }
  game.wait_for("Level won!");
  game.pass(2s);
  game.press("Watch replay");
  EXPECT_TRUE(game.says("replay · “Easy” (your level) · Turn 1 of 1")) << game.title();
  game.wait_for("paused");
  EXPECT_TRUE(game.says("Score 100 · Verified")) << game.title();
  game.press("Save");
  EXPECT_TRUE(game.shows("Saved as replay-0001."));
  game.key(Key::escape);
  EXPECT_TRUE(game.says("Level won!")) << "back to where one came from";
  game.press("Menu");
  game.key(Key::escape);
  game.press("Replays");
  EXPECT_TRUE(game.says("1 replay"));
  game.press("replay-0001");
  EXPECT_TRUE(game.says("replay · “Easy” (your level)"));
  game.press("Close");
  EXPECT_TRUE(game.says("Saved replays"));
}

TEST(Replays, ArePastedOnTitleAndList) {
  Player game(app::Language::en, 1280, 720);
  for (const bool list : {false, true}) {
    if (list) game.press("Replays");
    for (const std::string& wrong :
         {std::string(), std::string("hello"), replay_file("level-06-won.txt").substr(0, 60)}) {
      ASSERT_TRUE(game.clipboard().set_text(wrong));
      game.key(Key::paste);
      EXPECT_TRUE(game.shows("The text is not a complete replay."));
      if (!list) game.press("OK");
    }
    for (const char* name : {"level-06-won.txt", "billiards-whole.json"}) {
      ASSERT_TRUE(game.clipboard().set_text("\n " + replay_file(name) + "\n"));
      game.key(Key::paste);
      EXPECT_TRUE(game.says("replay · ")) << game.title();
      game.key(Key::escape);
    }
    ASSERT_TRUE(game.says(list ? "Saved replays" : "title screen"));
  }
}

TEST(Replays, OneSavedWhileItIsWatchedFromTheListIsThere) {
  Player game(app::Language::en, 1280, 720);
  ASSERT_TRUE(game.store().save("replays/a.json", replay_file("level-01-won.json")));
  game.press("Replays");
  game.key(Key::tab);
  game.key(Key::enter);
  game.wait_for("Verified");
  game.press("Save");
  game.key(Key::escape);
  EXPECT_TRUE(game.says("2 replays")) << game.title();
  EXPECT_TRUE(game.shows("replay-0001"));
  bool focused = false;
  for (const app::Box& box : game.boxes()) focused |= box.focused && box.text.starts_with("a\n");
  EXPECT_TRUE(focused) << "where the player came from";
}

TEST(Replays, ABrokenFileInTheListSaysSo) {
  Player game(app::Language::en, 1280, 720);
  ASSERT_TRUE(game.store().save("replays/bad.json", "{"));
  ASSERT_TRUE(game.store().save("replays/new.json", R"({"angry-balls-replay": 7})"));
  game.press("Replays");
  game.press("bad");
  EXPECT_TRUE(game.says("Saved replays"));
  EXPECT_TRUE(game.shows("Cannot be shown: it is damaged."));
  EXPECT_TRUE(game.shows("Cannot be shown: it was made by another version."));
}

TEST(Replays, ManyArePaged) {
  Player game(app::Language::en, 800, 600);
  for (int i = 10; i < 60; ++i)
    ASSERT_TRUE(game.store().save("replays/r" + std::to_string(i) + ".json",
                                  replay_file("level-01-won.json")));
  game.press("Replays");
  EXPECT_TRUE(game.shows("r59")) << "the last page first";
  game.press("Next");
  EXPECT_TRUE(game.shows("r10"));
  game.press("r11");
  EXPECT_TRUE(game.says("replay · First steps"));
  game.key(Key::escape);
  EXPECT_TRUE(game.shows("r11"));
}

}  // namespace
