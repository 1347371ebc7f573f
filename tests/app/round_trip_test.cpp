// All that is written is read back: what the program keeps, whatever the player does.

#include <bit>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "app/storage/best_scores.hpp"
#include "app/storage/kept_games.hpp"
#include "app/storage/level.hpp"
#include "app/storage/saved_replays.hpp"
#include "app/storage/settings.hpp"
#include "carom/scene_file.hpp"
#include "games/random.hpp"
#include "replay/player.hpp"
#include "replay/recorder.hpp"
#include "replay/replay_file.hpp"
#include "soak/random_game.hpp"

namespace {

using app::KeptSettings;
using app::MemoryStore;

/// What is typed or pasted, as likely as not to be no name.
std::string any_name() {
  const auto parts = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "a", "Z", " ", "\"", "\\", "\n", "\x01", std::string(1, '\0'), "\x7f", "é", "\u202e",
      "\u200d", "\ufeff", "\U0001d11e", "\xff", "\xe2\x82", "\xed\xa0\x80"));
  std::string name;
  for (const std::string& part : parts) name += part;
  return name;
}

app::Settings any_settings() {
  const auto yes = [] { return *rc::gen::arbitrary<bool>(); };
  const auto one_of = [](int count) { return *rc::gen::inRange(0, count); };
  app::Settings settings;
  if (yes()) settings.language = static_cast<app::Language>(one_of(app::language_codes.size()));
  settings.volume = *rc::gen::arbitrary<int>();
  settings.mute = yes();
  settings.reduced_motion = static_cast<app::ReducedMotion>(one_of(3));
  settings.screen_shake = yes();
  settings.colours = static_cast<app::Colours>(one_of(4));
  settings.aiming = {static_cast<app::PreviewLength>(one_of(4)),
                     static_cast<app::AimWay>(one_of(4))};
  settings.hints = yes();
  settings.taught = yes();
  settings.names = {any_name(), any_name()};
  settings.breaks = static_cast<app::Breaks>(one_of(4));
  settings.keep_turn = yes();
  settings.seats = static_cast<app::Seats>(one_of(2));
  settings.rack = static_cast<games::billiards::Rack>(one_of(2));
  settings.touch_red = yes();
  settings.go_on = yes();
  settings.go_on_offered = yes();
  settings.quick_rolling = yes();
  for (const app::Command command : app::all_commands)  // a letter that is taken changes nothing
    static_cast<void>(settings.keys.bind(
        command, static_cast<app::Key>(static_cast<int>(app::Key::a) + one_of(26))));
  return settings;
}

RC_GTEST_PROP(RoundTrip, OfAnySettings, ()) {
  MemoryStore store;
  KeptSettings settings(store);
  settings.set(any_settings());
  const KeptSettings read(store);
  RC_ASSERT(read.trouble() == KeptSettings::Trouble::none);
  // What was never changed from the defaults is not saved, and need not be.
  RC_ASSERT(read.get() == settings.get());
}

RC_GTEST_PROP(RoundTrip, OfAnyBestScores, ()) {
  MemoryStore store;
  app::BestScores scores(store);
  for (int n = *rc::gen::inRange(1, 20); n > 0; --n)
    scores.record("00000000000000a" + std::to_string(n % 10), *rc::gen::arbitrary<std::int64_t>());
  const app::BestScores read(store);
  RC_ASSERT(read.trouble() == app::BestScores::Trouble::none);
  for (int n = 0; n < 10; ++n) {
    const std::string level = "00000000000000a" + std::to_string(n);
    RC_ASSERT(read.of(level) == scores.of(level));
  }
}

/// The first moves of a random game, left anywhere: after a command, or in the middle of a shot.
template <class Game>
replay::Recorder<Game> any_game(Game game, games::Random& random) {
  replay::Recorder<Game> recorder(std::move(game));
  for (auto left = random.below(1500); left > 0; --left) {
    if (const auto command = soak::random_command(recorder.game(), random))
      static_cast<void>(recorder.apply(*command));
    if (left > 1) recorder.step();
  }
  return recorder;
}

void expect_kept_and_saved(const replay::Replay& game) {
  MemoryStore store;
  app::KeptGames games(store);
  app::KeptGames::Place place;
  RC_ASSERT(games.keep(place, game));
  const auto kept = app::KeptGames(store).latest();
  RC_ASSERT(kept.has_value());
  RC_ASSERT(kept->game == game);
  const auto name = app::SavedReplays(store).save(game);
  RC_ASSERT(name.ok());
  const auto saved = app::SavedReplays(store).load(name.value());
  RC_ASSERT(saved.ok());
  RC_ASSERT(saved.value() == game);
  const auto verified = replay::verify(saved.value());
  RC_ASSERT(verified.ok());
  RC_ASSERT(!verified.value().divergence());
}

RC_GTEST_PROP(RoundTrip, OfAnyTableLeftAnywhere, ()) {
  games::Random random(*rc::gen::arbitrary<std::uint64_t>());
  const games::billiards::Options options{.first_player = static_cast<int>(random.below(2)),
                                          .keep_turn = random.one_in(2)};
  expect_kept_and_saved(any_game(games::billiards::Game(options), random).replay());
}

RC_GTEST_PROP(RoundTrip, OfAnyLevelLeftAnywhere, ()) {
  games::Random random(*rc::gen::arbitrary<std::uint64_t>());
  auto game = games::angry_balls::Game::create(soak::random_level(random));
  while (!game) game = games::angry_balls::Game::create(soak::random_level(random));
  expect_kept_and_saved(any_game(std::move(game).value(), random).replay());
}

RC_GTEST_PROP(RoundTrip, OfAnyLevelOfThePlayers, ()) {
  games::Random random(*rc::gen::arbitrary<std::uint64_t>());
  carom::Scene scene = soak::random_level(random);
  while (!games::angry_balls::Game::create(scene)) scene = soak::random_level(random);
  MemoryStore store;
  RC_ASSERT(store.save(app::own_levels + "mine.json", carom::write_scene(scene)).ok());
  const auto levels = app::kept_levels(store);
  RC_ASSERT(levels.size() == 1U);
  RC_ASSERT(levels[0].scene.ok());
  RC_ASSERT(levels[0].scene.value() == scene);
}

// JSON of strangers, wherever the program reads it.

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

std::string many_keys(std::size_t count) {
  std::string json = R"({"angry-balls-settings": 1, "angry-balls-scores": 1)";
  for (std::size_t i = 0; i < count; ++i) json += ",\"k" + std::to_string(i) + "\":1";
  return json + "}";
}

TEST(JsonOfStrangers, IsRefusedEverywhereHoweverDeepOrLong) {
  const std::string deep = nested(80'000);
  const std::string deep_settings = R"({"angry-balls-settings": 1, "volume": )" + deep + "}";
  const std::string deep_scores =
      R"({"angry-balls-scores": 1, "best": {"0123456789abcdef": )" + deep + "}}";
  const std::string deep_replay = R"({"angry-balls-replay": 1, "level": )" + deep + "}";
  const std::string deep_level = R"({"carom": 1, "balls": )" + deep + "}";
  for (const std::string& json : {deep, deep_settings, deep_scores, deep_replay, deep_level,
                                  nested(30'000), many_keys(40'000), many_keys(4'000),
                                  std::string(2 << 20, '['), std::string(2 << 20, ' ')}) {
    SCOPED_TRACE(json.substr(0, 60) + "… " + std::to_string(json.size()));
    MemoryStore store;
    for (const char* name : {"settings.json", "scores.json", "continue-level-0001.json",
                             "replays/x.json", "levels/x.json"})
      ASSERT_TRUE(store.save(name, json));
    EXPECT_EQ(KeptSettings(store).trouble(), KeptSettings::Trouble::set_aside);
    EXPECT_EQ(app::BestScores(store).trouble(), app::BestScores::Trouble::set_aside);
    EXPECT_FALSE(app::KeptGames(store).latest());
    EXPECT_FALSE(app::SavedReplays(store).load("x"));
    EXPECT_FALSE(app::kept_levels(store)[0].scene);
    for (const char* name : {"settings.json.broken", "scores.json.broken"})
      EXPECT_EQ(store.load(name).value(), json);
  }
}

TEST(BestScores, AreNeverMoreThanAreReadBack) {
  std::string most = R"({"angry-balls-scores": 1, "best": {)";
  for (int n = 0; n < 30'000; ++n) {
    std::string digits = std::to_string(n);
    digits.insert(0, 16 - digits.size(), '0');
    most += (n > 0 ? ",\"" : "\"") + digits + "\":1";
  }
  most += "}}";
  MemoryStore store;
  ASSERT_TRUE(store.save("scores.json", most));
  app::BestScores scores(store);
  EXPECT_EQ(scores.trouble(), app::BestScores::Trouble::none);
  EXPECT_TRUE(scores.record("ffffffffffffffff", 1));
  EXPECT_EQ(scores.trouble(), app::BestScores::Trouble::not_kept);
  EXPECT_TRUE(scores.record("0000000000000000", 2)) << "still counts until the end";
  EXPECT_EQ(store.load("scores.json").value(), most) << "what could not be read is not written";
  EXPECT_EQ(app::BestScores(store).trouble(), app::BestScores::Trouble::none);
}

// Levels of the game have limits of their own: what is made of them can be kept.

carom::Scene level_of_balls(std::size_t count) {
  carom::Scene level;
  level.width = 100'000;
  level.height = 100'000;
  level.edges.left = level.edges.right = carom::Edge::open;
  level.balls = {{.role = carom::Role::projectile, .position = {50, 50}},
                 {.role = carom::Role::enemy, .position = {90, 50}}};
  for (std::size_t i = 2; i < count; ++i)
    level.balls.push_back({.position = {100.0 + 50 * static_cast<double>(i % 1000),
                                        100.0 + 50 * static_cast<double>(i / 1000)}});
  return level;
}

TEST(LevelsOfTheGame, HaveTwentyThousandBallsAtMost) {
  EXPECT_TRUE(app::read_level("a.json", carom::write_scene(level_of_balls(20'000))).scene);
  const app::Level more = app::read_level("a.json", carom::write_scene(level_of_balls(20'001)));
  ASSERT_FALSE(more.scene);
  EXPECT_EQ(more.problem, "a.json: /balls: has 20001 elements; expected at most 20000");
}

TEST(LevelsOfTheGame, AreSmallEnoughThatTheirReplaysCanBeKept) {
  carom::Scene level = level_of_balls(2);
  for (int i = 0; i < 60'000; ++i)
    level.holes.push_back({.position = {1000.1 + i * 0.7, 90'000.3}, .radius = 0.1});
  ASSERT_TRUE(games::angry_balls::Game::create(level)) << "sound for the engine";
  const app::Level large = app::read_level("a.json", carom::write_scene(level));
  ASSERT_FALSE(large.scene);
  EXPECT_EQ(large.problem, "a.json: is larger than 2621440 bytes");

  // The longest replay of the largest level.
  level.holes.resize(48'000);
  ASSERT_TRUE(app::read_level("a.json", carom::write_scene(level)).scene);
  ASSERT_GT(carom::write_scene(level).size(), 2'500'000U);
  replay::Replay replay;
  replay.level = level;
  replay.moves.assign(
      replay::max_moves,
      {games::angry_balls::Throw{{-1.2345678901234567e-300, -1.2345678901234567e-300}},
       replay::max_steps / replay::max_moves, ~std::uint64_t{0}});
  MemoryStore store;
  app::KeptGames games(store);
  app::KeptGames::Place place;
  EXPECT_TRUE(games.keep(place, replay));
  EXPECT_TRUE(app::KeptGames(store).latest());
}

TEST(SavedReplays, AreNotWrittenLargerThanTheyAreRead) {
  carom::Scene level = level_of_balls(2);
  for (int i = 0; i < 90'000; ++i)
    level.holes.push_back({.position = {1000.1 + i * 0.7, 90'000.3}, .radius = 0.1});
  replay::Replay replay;
  replay.level = level;
  MemoryStore store;
  const auto saved = app::SavedReplays(store).save(replay);
  ASSERT_FALSE(saved);
  EXPECT_EQ(carom::to_string(saved.errors()[0]), "is larger than 4194304 bytes");
  EXPECT_TRUE(app::SavedReplays(store).names().empty());
}

}  // namespace
