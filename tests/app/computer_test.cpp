// Games of billiards against a computer.

#include <gtest/gtest.h>

#include "app/greedy_player.hpp"
#include "app/play/table_match.hpp"
#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/staged.hpp"
#include "replay/player.hpp"
#include "replay/replay_file.hpp"
#include "search/match.hpp"

namespace {

using namespace std::chrono_literals;
using app::ComputerTurn;
using app::Key;
using app::Seats;
using games::billiards::Game;
using games::billiards::Phase;
using games::billiards::Rack;

search::Decision decision_in_frames(const Game& game, const replay::Occasion& occasion,
                                    app::nanoseconds frame) {
  carom::Rollouts rollouts;
  auto turn = ComputerTurn::begin(game, occasion);
  while (turn->thinking()) turn->advance(frame, rollouts);
  return turn->decision();
}

TEST(ComputerTurn, InSlicesOfAnotherSize_DecidesTheSame) {
  const Game rack({.rack = Rack::quick});
  for (const int level : {1, 5, 6, 10}) {
    const replay::Occasion occasion{.computer = {level, 0}, .seed = 5};
    const search::Decision once = decision_in_frames(rack, occasion, 1ms);
    const search::Decision again = decision_in_frames(rack, occasion, 1s);
    EXPECT_EQ(once.meant, again.meant) << level;
    EXPECT_EQ(once.drag, again.drag) << level;
  }
}

TEST(ComputerTurn, OfAPerson_IsNone) {
  const Game rack;
  EXPECT_FALSE(ComputerTurn::begin(rack, {.computer = {0, 5}}));
  EXPECT_TRUE(ComputerTurn::begin(rack, {.computer = {5, 0}}));
}

TEST(ComputerTurn, ThinksForAWhileThenAimsThenIsReady) {
  carom::Rollouts rollouts;
  auto turn = ComputerTurn::begin(Game(), {.computer = {1, 0}});
  ASSERT_TRUE(turn->cue());
  app::nanoseconds thought{};
  for (; turn->thinking(); thought += 10ms) turn->advance(10ms, rollouts);
  EXPECT_EQ(thought, ComputerTurn::least_thought);
  EXPECT_FALSE(turn->ready());
  turn->advance(ComputerTurn::aim_time - 1ms, rollouts);
  EXPECT_FALSE(turn->ready());
  // Just before the shot the cue points where it is meant to go.
  EXPECT_GT(carom::dot(turn->cue()->way, carom::unit(search::drag(turn->decision().meant.aim))),
            0.9999);
  turn->advance(1ms, rollouts);
  EXPECT_TRUE(turn->ready());
}

TEST(TableMatch, TwoOfThree_DecideItAndTheBreakAlternates) {
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session(store, clipboard, {});
  app::Settings settings;
  settings.seats = Seats::computer;
  settings.opponent = 7;
  settings.match = app::BestOf::three;
  session.settings.set(settings);
  app::BilliardsRecorder game = app::new_table(session, false);
  EXPECT_EQ(game.occasion().computer, (std::array{0, 7}));
  EXPECT_EQ(game.occasion().best_of, 3);
  EXPECT_EQ(game.game().options().first_player, 0);
  const std::uint64_t seed = game.occasion().seed;
  EXPECT_FALSE(app::match_winner(game.occasion(), 1));

  game = app::next_table(session, game, 1);
  EXPECT_EQ(game.occasion().won, (std::array{0, 1}));
  EXPECT_EQ(game.game().options().first_player, 1);
  EXPECT_NE(game.occasion().seed, seed) << "another game has other luck";

  game = app::next_table(session, game, std::nullopt);
  EXPECT_EQ(game.occasion().won, (std::array{0, 1})) << "a draw counts for nobody";
  EXPECT_EQ(game.game().options().first_player, 0);

  EXPECT_EQ(app::match_winner(game.occasion(), 1), 1);
  EXPECT_FALSE(app::match_winner(game.occasion(), 0));
  game = app::next_table(session, game, 1);
  EXPECT_EQ(game.occasion().won, (std::array{0, 0})) << "another match";
  EXPECT_EQ(game.occasion().computer, (std::array{0, 7})) << "against the same";
}

/// Both sides of a game are computers: it is the one that `carom strength` plays.
TEST(ComputerGame, OfTwoLevels_IsTheGameOfTheMatch) {
  const std::uint64_t seed = 11;
  carom::Rollouts rollouts;
  const search::GameResult expected =
      search::play_game({search::levels[0], search::levels[4]}, 0, seed, rollouts);

  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session(store, clipboard, {});
  Staged<app::BilliardsScreen> screen(
      app::Words(app::Language::en), session,
      app::BilliardsRecorder(Game(), {.computer = {1, 5}, .seed = seed}));
  screen.event(app::CommandPressed{app::Command::fast});
  for (int i = 0; i < 200'000 && screen.game().phase() != Phase::over; ++i) screen.iterate(20ms);
  ASSERT_EQ(screen.game().phase(), Phase::over) << screen.describe();
  EXPECT_EQ(screen.game().score(0), expected.points[0]);
  EXPECT_EQ(screen.game().score(1), expected.points[1]);
  EXPECT_EQ(screen.game().tally(0).shots, expected.turns[0]);
  EXPECT_EQ(screen.game().tally(1).shots, expected.turns[1]);
  EXPECT_EQ(screen.game().tally(1).fouls, expected.fouls[1]);
}

/// A start of the program that plays against a computer by the mouse.
struct Against : Player {
  explicit Against(app::Store& shared) : Player(app::Language::en, 1280, 720, {}, shared) {}

  void choose(int level, app::BestOf match = app::BestOf::one) {
    app::Settings settings = app().settings().get();
    settings.seats = Seats::computer;
    settings.opponent = level;
    settings.rack = Rack::quick;
    settings.match = match;
    app().settings().set(settings);
  }
  const app::BilliardsScreen& table() {
    return dynamic_cast<const app::BilliardsScreen&>(app().screen());
  }
  bool over() { return says("wins") || says("draw"); }
  /// What the person does, if it is the person's turn.
  void play_own() {
    if (says("Player 1 places")) click(greedy::choose_place(table().game(), table().viewport()));
    if (!says("Player 1 aims")) return;
    const greedy::Shot shot = greedy::choose_shot(table().game(), table().viewport(), 3);
    click(shot.grab);
    click(shot.target);
  }
  void play_on(app::nanoseconds frame) {
    play_own();
    key(Key::f);
    pass(frame);
  }
  void play_to_end(app::nanoseconds frame = 16ms) {
    for (int i = 0; i < 60'000 && !over(); ++i) play_on(frame);
  }
};

/// The moves of a game that was played to its end, from its replay.
replay::Replay finished(Against& game) {
  game.press("Watch replay");
  game.press("Copy");
  game.key(Key::escape);
  return replay::read_replay(game.clipboard().text().value()).value();
}

TEST(ComputerGame, AgainstLevels1And5And10_IsPlayedToTheEndAndRecorded) {
  for (const int level : {1, 5, 10}) {
    app::MemoryStore store;
    Against game(store);
    game.choose(level);
    game.press("Billiards");
    game.play_to_end();
    ASSERT_TRUE(game.over()) << game.title();
    EXPECT_TRUE(game.shows("Computer " + std::to_string(level)));
    EXPECT_TRUE(app::KeptGames(store).names().empty());
    const replay::Replay replay = finished(game);
    EXPECT_EQ(replay.occasion.computer, (std::array{0, level}));
    EXPECT_FALSE(replay::verify(replay).value().divergence());
  }
}

TEST(ComputerGame, BrokenOffAtAnyTime_GoesOnTheSame) {
  std::optional<replay::Replay> straight;
  for (const bool broken : {false, true}) {
    app::MemoryStore store;
    auto game = std::make_unique<Against>(store);
    game->choose(4);
    game->press("Billiards");
    for (int i = 0; i < 60'000 && !game->over(); ++i) {
      game->play_on(16ms);
      // In all states: thinking, aiming, while the balls roll, and in the person's own turns.
      if (!broken || i % 997 != 0 || !app::KeptGames(store).latest()) continue;
      game.reset();
      game = std::make_unique<Against>(store);
      game->press("Continue: billiards, computer 4");
      for (int k = 0; k < 1000 && game->says("Loading"); ++k) game->pass(10ms);
    }
    ASSERT_TRUE(game->over()) << game->title();
    const replay::Replay replay = finished(*game);
    if (!straight) straight = replay;
    EXPECT_EQ(replay.moves, straight->moves) << broken;
  }
}

class ComputerScreen : public testing::Test {
 protected:
  ComputerScreen() { game.choose(3); }
  app::MemoryStore store;
  Against game{store};
};

TEST_F(ComputerScreen, WhileTheComputerPlays_ThePersonCannotShootButPause) {
  app::Settings settings = game.app().settings().get();
  settings.breaks = app::Breaks::player_2;
  game.app().settings().set(settings);
  game.press("Billiards");
  ASSERT_TRUE(game.says("Computer 3 thinks")) << game.title();
  EXPECT_FALSE(game.app().screen().aim_prompt());
  const app::Point cue = game.table().viewport().to_window(games::billiards::cue_start);
  game.click(cue);
  game.click(cue + app::Point{90, 3});
  game.key(Key::enter);
  game.key(Key::space);
  EXPECT_EQ(game.table().game().phase(), Phase::aim);
  game.key(Key::p);
  game.pass(5s);
  EXPECT_TRUE(game.says("paused")) << game.title();
  EXPECT_EQ(game.table().game().phase(), Phase::aim);
  game.key(Key::p);
  game.wait_for("Computer 3 aims");
  EXPECT_EQ(game.table().game().phase(), Phase::aim);
  game.wait_for("Computer 3 watches");
  game.wait_for("Player 1 aims");
}

TEST_F(ComputerScreen, Resigning_LosesTheGameAndARematchIsOffered) {
  game.press("Billiards");
  game.play_own();
  game.pass(1s);
  ASSERT_FALSE(app::KeptGames(store).names().empty());
  game.key(Key::escape);
  game.press("Resign");
  game.press("Keep playing");
  EXPECT_TRUE(game.says("Player 1 watches")) << game.title();
  game.key(Key::escape);
  game.press("Resign");
  game.press("Resign");
  EXPECT_TRUE(game.says("Computer 3 wins")) << game.title();
  EXPECT_TRUE(app::KeptGames(store).names().empty());
  game.pass(1s);
  game.press("Rematch");
  EXPECT_TRUE(game.says("Player 1 aims")) << game.title();
  EXPECT_TRUE(game.shows("Computer 3"));
}

TEST_F(ComputerScreen, AMatchOfThree_GoesOnUntilOneHasWonTwo) {
  game.choose(3, app::BestOf::three);
  game.press("Billiards");
  const auto resign = [&] {
    game.key(Key::escape);
    game.press("Resign");
    game.press("Resign");
  };
  resign();
  EXPECT_TRUE(game.shows("Games won")) << game.title();
  game.press("Next game");
  EXPECT_TRUE(game.says("Computer 3 thinks")) << "the break alternates: " << game.title();
  resign();
  EXPECT_TRUE(game.says("Computer 3 wins the match")) << game.title();
  game.press("Rematch");
  EXPECT_TRUE(game.says("Player 1 aims")) << game.title();
}

TEST_F(ComputerScreen, AReplayNamesItsPlayers) {
  game.press("Billiards");
  game.play_own();
  game.wait_for("Computer 3 aims");
  game.leave();
  const auto kept = app::KeptGames(store).latest();
  ASSERT_TRUE(kept);
  (void)game.clipboard().set_text(replay::write_json(kept->game));
  game.key(Key::paste);
  EXPECT_TRUE(game.says("Player 1 – Computer 3")) << game.title();
}

TEST_F(ComputerScreen, IsChosenUnderNewGame) {
  game.choose(5);
  game.press("…");
  EXPECT_TRUE(game.says("Players: Computer · Level: 5 · League")) << game.title();
  game.press("Level");
  EXPECT_TRUE(game.shows("hand 3 px, looks at 250 shots"));
  EXPECT_TRUE(game.shows("exact hand, looks at 22 shots"));
  game.press("Casual");
  EXPECT_TRUE(game.says("Level: 1 · Casual")) << game.title();
  game.press("Match");
  EXPECT_TRUE(game.says("Match: Best of 3")) << game.title();
  game.press("Start");
  EXPECT_TRUE(game.shows("Computer 1"));
  game.leave();
  Player later(app::Language::en, 1280, 720, {}, store);
  later.press("Billiards");
  EXPECT_TRUE(later.shows("Computer 1")) << "one tap plays what was chosen last";
}

}  // namespace
