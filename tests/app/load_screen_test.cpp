#include "app/screens/load_screen.hpp"

#include <gtest/gtest.h>

#include "app/staged.hpp"
#include "project_file.hpp"
#include "replay/replay_file.hpp"

namespace {

using namespace std::chrono_literals;
using app::ReplayFault;

const std::string table = "continue-billiards-0007.json";
const std::string level = "continue-level-0003.json";

replay::Replay read(const std::string& name) {
  return replay::read_replay(replay_file(name)).value();
}

class LoadScreenTest : public testing::Test {
 protected:
  /// Saves `game` and loads it until the screen wants to go elsewhere.
  app::Navigation load(const std::string& name, const replay::Replay& game) {
    EXPECT_TRUE(store.save(name, replay::write_json(game)));
    return until_done({{name, replay::write_json(game)}, game});
  }
  app::Navigation until_done(app::KeptGames::Kept kept) {
    Staged<app::LoadScreen> screen(app::Words(app::Language::en), session, std::move(kept));
    for (int i = 0; i < 100'000; ++i) {
      app::Navigation request = screen.iterate(0ns);
      if (!asks_for<app::Stay>(request)) return request;
      EXPECT_TRUE(screen.animating());
    }
    return app::Stay{};
  }
  void expect_refused(const app::Navigation& request, ReplayFault fault) {
    EXPECT_TRUE(asks_for<app::ShowTitle>(request));
    const auto refused = session.kept.take_refused();
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->fault, fault);
    EXPECT_TRUE(refused->set_aside);
    EXPECT_TRUE(session.kept.names().empty());
  }

  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, app::shipped_levels()};
};

TEST_F(LoadScreenTest, ABilliardsGameIsResumedInItsLastState) {
  const replay::Replay game = read("billiards-left-in-the-middle.json");
  const app::Navigation request = load(table, game);
  ASSERT_TRUE(asks_for<app::Resume>(request));
  const auto& resume = std::get<app::Resume>(request);
  EXPECT_EQ(resume.place.name, table);
  const auto* recorder = std::get_if<app::BilliardsRecorder>(&resume.game);
  ASSERT_NE(recorder, nullptr);
  EXPECT_EQ(recorder->game().world().state_hash(), game.moves.back().hash);
  EXPECT_EQ(recorder->replay().moves, game.moves);
}

TEST_F(LoadScreenTest, ALevelThatIsOnOfferBecomesTheCurrentOne) {
  replay::Replay game = read("level-06-won.json");
  game.moves.resize(1);
  app::LevelRecorder recorder{games::angry_balls::Game::create(*game.level).value()};
  ASSERT_TRUE(recorder.apply(std::get<games::angry_balls::Throw>(game.moves[0].command)));
  for (int i = 0; i < 50; ++i) recorder.step();
  const std::size_t levels = session.campaign.levels.size();
  const app::Navigation request = load(level, recorder.replay());
  ASSERT_TRUE(asks_for<app::Resume>(request));
  const auto* resumed = std::get_if<app::LevelRecorder>(&std::get<app::Resume>(request).game);
  ASSERT_NE(resumed, nullptr);
  EXPECT_EQ(resumed->game().world().state_hash(), recorder.game().world().state_hash());
  EXPECT_EQ(session.campaign.current, 5U);
  EXPECT_EQ(session.campaign.levels.size(), levels);
}

TEST_F(LoadScreenTest, ALevelThatIsNotOnOfferIsAdded) {
  carom::Scene other = app::shipped_levels()[0].scene.value();
  other.name = "Another";
  other.gravity = 123;
  app::LevelRecorder recorder{games::angry_balls::Game::create(other).value()};
  ASSERT_TRUE(recorder.apply(games::angry_balls::Throw{{100, 100}}));
  recorder.step();
  const std::size_t levels = session.campaign.levels.size();
  ASSERT_TRUE(asks_for<app::Resume>(load(level, recorder.replay())));
  ASSERT_EQ(session.campaign.levels.size(), levels + 1);
  EXPECT_EQ(session.campaign.current, levels);
  EXPECT_EQ(session.campaign.levels.back().name, "Another");
}

TEST_F(LoadScreenTest, AGameThatGoesAnotherWayIsRefused) {
  replay::Replay game = read("billiards-left-in-the-middle.json");
  game.moves.back().hash ^= 1;
  expect_refused(load(table, game), ReplayFault::diverged);
}

TEST_F(LoadScreenTest, AGameThatIsOverIsRefused) {
  expect_refused(load(level, read("level-01-won.json")), ReplayFault::finished);
}

TEST_F(LoadScreenTest, AGameThatCannotBeginIsRefused) {
  replay::Replay game = read("level-01-won.json");
  const std::string text = replay::write_json(game);
  ASSERT_TRUE(store.save(level, text));
  game.level->balls.clear();
  expect_refused(until_done({{level, text}, game}), ReplayFault::damaged);
}

TEST_F(LoadScreenTest, EscapeLeadsToTheTitleAndTheGameStaysSaved) {
  const replay::Replay game = read("billiards-whole.json");
  ASSERT_TRUE(store.save(table, replay::write_json(game)));
  Staged<app::LoadScreen> screen(app::Words(app::Language::en), session,
                                 app::KeptGames::Kept{{table, replay::write_json(game)}, game});
  EXPECT_TRUE(asks_for<app::Stay>(screen.iterate(0ns)));
  EXPECT_TRUE(asks_for<app::ShowTitle>(screen.event(app::KeyPressed{app::Key::escape})));
  EXPECT_EQ(session.kept.names(), std::vector{table});
  EXPECT_FALSE(session.kept.take_refused());
}

TEST_F(LoadScreenTest, EnterPressesCancel) {
  const replay::Replay game = read("billiards-whole.json");
  Staged<app::LoadScreen> screen(app::Words(app::Language::en), session,
                                 app::KeptGames::Kept{{table, ""}, game});
  EXPECT_TRUE(asks_for<app::ShowTitle>(screen.event(app::KeyPressed{app::Key::enter})));
}

TEST_F(LoadScreenTest, ThePictureCountsTheTurnsThatWereProved) {
  const replay::Replay game = read("billiards-whole.json");
  Staged<app::LoadScreen> screen(app::Words(app::Language::en), session,
                                 app::KeptGames::Kept{{table, ""}, game});
  app::Atlas atlas;
  app::Font font{atlas};
  const auto shown = [&] {
    app::DrawList list;
    app::Canvas canvas{list, font, app::View::of(1280, 720)};
    screen.draw(canvas);
    std::string all;
    for (const app::Box& box : list.boxes) all += box.text + '\n';
    return all;
  };
  const std::string before = shown();
  screen.iterate(0ns);
  EXPECT_NE(shown(), before);
  EXPECT_NE(before.find("Cancel"), std::string::npos);
}

}  // namespace
