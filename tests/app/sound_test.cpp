#include "app/audio/sound.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "app/player.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/view/game_sounds.hpp"
#include "games/billiards.hpp"
#include "games/launch.hpp"

namespace {

using app::SoundEvent;
using app::SoundKind;
using app::Sounds;
using namespace std::chrono_literals;

TEST(Sounds, OfEveryKindTheStrongestAreTaken) {
  Sounds sounds;
  for (int i = 0; i < 100; ++i)
    sounds.note({SoundKind::ball, 0.01f * static_cast<float>(i * 37 % 100), 0});
  sounds.note({SoundKind::cue, 0.3f, 0.5f});
  const auto taken = sounds.take();
  ASSERT_EQ(taken.size(), Sounds::most_a_kind + 1);
  for (std::size_t i = 0; i < Sounds::most_a_kind; ++i)
    EXPECT_EQ(taken[i],
              (SoundEvent{SoundKind::ball, 0.01f * static_cast<float>(99 - static_cast<int>(i))}));
  EXPECT_EQ(taken.back(), (SoundEvent{SoundKind::cue, 0.3f, 0.5f}));
  EXPECT_TRUE(sounds.take().empty());
}

TEST(Sounds, FaintSoundsAreDropped) {
  Sounds sounds;
  sounds.note({SoundKind::ball, 0.5f * Sounds::faintest, 0});
  EXPECT_TRUE(sounds.empty());
}

/// A break's sounds, a list per step.
std::vector<std::vector<SoundEvent>> break_at(double speed) {
  games::billiards::Game game;
  EXPECT_TRUE(game.apply(games::billiards::Shoot{{speed / games::launch_factor, 0}}).ok());
  std::vector<std::vector<SoundEvent>> steps;
  Sounds sounds;
  while (game.phase() == games::billiards::Phase::roll && game.world().steps() < 300) {
    game.step();
    app::note_contacts(sounds, game.physics_events(), game.world().scene(), false);
    steps.push_back(sounds.take());
  }
  return steps;
}

TEST(GameSounds, ABreakIsStrongerTheQuickerItIs) {
  float before = 0;
  for (const double speed : {400.0, 700.0, 1200.0, 2000.0}) {
    const auto steps = break_at(speed);
    float strongest = 0;
    std::size_t balls = 0;
    for (const auto& step : steps) {
      for (const SoundEvent& event : step) {
        EXPECT_GT(event.strength, 0);
        EXPECT_LE(event.strength, 1);
        EXPECT_LE(std::abs(event.pan), 1);
        if (event.kind != SoundKind::ball) continue;
        strongest = std::max(strongest, event.strength);
        ++balls;
      }
      EXPECT_LE(step.size(), app::sound_kinds * Sounds::most_a_kind);
    }
    EXPECT_GT(strongest, 1.2f * before) << speed;
    EXPECT_GT(balls, 5u) << speed;
    before = strongest;
  }
  EXPECT_EQ(before, 1);
}

TEST(GameSounds, ComeFromWhereTheyAre) {
  Sounds sounds;
  const carom::Scene table = games::billiards::rack();
  const std::array events{
      carom::Event{.kind = carom::EventKind::cushion, .position = {20, 9}, .deviation = {0, 900}},
      carom::Event{.kind = carom::EventKind::pair, .position = {780, 200}, .deviation = {750, 0}}};
  app::note_contacts(sounds, events, table, false);
  const auto taken = sounds.take();
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(taken[0].kind, SoundKind::ball);
  EXPECT_FLOAT_EQ(taken[0].strength, 0.5f);
  EXPECT_GT(taken[0].pan, 0.6f);
  EXPECT_EQ(taken[1].kind, SoundKind::cushion);
  EXPECT_FLOAT_EQ(taken[1].strength, 0.3f);
  EXPECT_LT(taken[1].pan, -0.6f);
}

TEST(GameSounds, AreHeardWhereTheyAreSeenOnATableThatStandsUpright) {
  app::MemoryStore store;
  app::MemoryClipboard clipboard;
  app::Session session{store, clipboard, {}};
  app::BilliardsScreen screen{app::Words(app::Language::en), session};
  const carom::Scene table = games::billiards::rack();
  const auto pan_of = [&](carom::Vec2 at) {
    const carom::Event event{
        .kind = carom::EventKind::cushion, .position = at, .deviation = {0, 900}};
    app::note_contacts(session.sounds, {&event, 1}, table, false);
    return session.sounds.take().front().pan;
  };
  screen.resize(app::View::of(390, 844));
  EXPECT_NEAR(pan_of({790, 200}), 0, 1e-6) << "the far end";
  EXPECT_LT(pan_of({200, 390}), -0.6f) << "its left rail";
  EXPECT_GT(pan_of({200, 10}), 0.6f);
  screen.resize(app::View::of(1280, 720));
  EXPECT_GT(pan_of({790, 200}), 0.6f);
}

TEST(GameSounds, ABallThatComesToLieFallsSilent) {
  const carom::Scene level;
  Sounds sounds;
  const auto bounce = [&](double speed) {
    const carom::Event event{.kind = carom::EventKind::floor, .deviation = {0, 2 * speed}};
    app::note_contacts(sounds, {&event, 1}, level, true);
    return sounds.take().size();
  };
  EXPECT_EQ(bounce(20), 0u);
  EXPECT_EQ(bounce(40), 1u);
}

std::size_t count(const Player& player, SoundKind kind) {
  return static_cast<std::size_t>(std::ranges::count(player.sounds(), kind, &SoundEvent::kind));
}

TEST(Sound, ButtonsClickUnderThePointerAndUnderKeys) {
  Player game(app::Language::en, 1280, 720);
  game.picture();
  game.key(app::Key::space);  // nothing has the focus
  game.pass(20ms);
  EXPECT_EQ(count(game, SoundKind::click), 0u);
  game.click({1, 1});
  game.pass(20ms);
  EXPECT_EQ(count(game, SoundKind::click), 0u);
  game.press("Replays");
  game.pass(20ms);
  EXPECT_EQ(count(game, SoundKind::click), 1u);
  game.key(app::Key::escape);
  game.picture();
  game.key(app::Key::enter);
  game.pass(20ms);
  EXPECT_EQ(count(game, SoundKind::click), 2u);
}

TEST(Sound, AReplaySoundsAsTheGameDidToItsEnd) {
  for (const bool lost : {true, false}) {
    std::ifstream file(std::string(SOURCE_DIR "/tests/replays/") +
                       (lost ? "level-random-lost.json" : "level-09-won.json"));
    Player game(app::Language::en, 1280, 720);
    ASSERT_TRUE(game.clipboard().set_text({std::istreambuf_iterator<char>(file), {}}));
    game.key(app::Key::paste);
    for (int i = 0; i < 3; ++i) game.key(app::Key::plus);
    for (int i = 0; i < 100 && !game.says("paused"); ++i) game.pass(1s);
    ASSERT_TRUE(game.says("paused")) << game.title();
    EXPECT_EQ(count(game, SoundKind::lose), lost ? 1u : 0u);
    EXPECT_EQ(count(game, SoundKind::win), lost ? 0u : 1u);
    game.key(app::Key::period);
    game.pass(20ms);
    EXPECT_EQ(count(game, SoundKind::lose), lost ? 1u : 0u) << "once";
  }
}

TEST(Sound, AButtonBelowAWindowDoesNotClick) {
  Player game(app::Language::en, 1280, 720);
  game.clipboard().set_text("no replay");
  app::Rect quit;
  for (const app::Box& box : game.boxes())
    if (box.text == "Quit") quit = box.area;
  game.key(app::Key::paste);
  ASSERT_TRUE(game.shows("OK"));
  game.click(quit.center());
  game.pass(20ms);
  EXPECT_EQ(count(game, SoundKind::click), 0u);
  game.press("OK");
  game.pass(20ms);
  EXPECT_EQ(count(game, SoundKind::click), 1u);
}

TEST(Sound, AnMInANameDoesNotMute) {
  Player game(app::Language::en, 1280, 720);
  game.key(app::Key::settings);
  game.press("Players");
  game.press("Name of player 1");
  game.key(app::Key::m);
  game.app().event(app::TextTyped{"m"});
  EXPECT_EQ(game.app().volume(), 80);
  EXPECT_TRUE(game.shows("m"));
  game.press("General");
  game.key(app::Key::m);
  EXPECT_EQ(game.app().volume(), 0);
}

TEST(Sound, MutesAnywhereAndSaysSo) {
  Player game(app::Language::en, 1280, 720);
  EXPECT_EQ(game.app().volume(), 80);
  game.key(app::Key::m);
  EXPECT_EQ(game.app().volume(), 0);
  EXPECT_TRUE(game.shows("Sound off"));
  EXPECT_TRUE(game.app().animating());
  game.press("Replays");
  game.pass(2s);
  EXPECT_TRUE(game.sounds().empty());
  EXPECT_FALSE(game.shows("Sound off"));
  EXPECT_FALSE(game.app().animating());
  game.key(app::Key::m);
  EXPECT_EQ(game.app().volume(), 80);
  EXPECT_TRUE(game.shows("Sound on"));
  game.pass(20ms);
  EXPECT_TRUE(game.sounds().empty()) << "what was muted is not heard later";
}

}  // namespace
