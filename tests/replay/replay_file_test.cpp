#include "replay/replay_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "replay/games.hpp"
#include "replay/random_replay.hpp"
#include "replay/replay_text.hpp"

namespace {

using namespace recorded;

std::string problem(std::string_view json) {
  const auto read = replay::read_replay(json);
  if (read) return "no problem";
  std::string lines;
  for (const carom::Error& error : read.errors()) lines += carom::to_string(error) + "\n";
  return lines;
}

const std::string hash = R"("hash": "0123456789abcdef")";
const std::string level = R"({"carom": 1, "width": 100, "height": 100, "balls": [
  {"x": 50, "y": 50, "role": "projectile"}, {"x": 90, "y": 90, "role": "enemy"}]})";

std::string billiards_with(const std::string& members) {
  return R"({"angry-balls-replay": 1, "physics": 1, "rules": 1, "game": "billiards", )" + members +
         R"(, "checksum": "0123456789abcdef"})";
}

std::string moves(const std::string& list) {
  return billiards_with(R"("score": [0, 0], "moves": [)" + list + "]");
}

TEST(ReplayFile, IsWrittenOneLinePerMove) {
  replay::Replay replay;
  replay.moves = {{billiards::Shoot{{331.5, -0.0}}, 412, 0x123456789abcdef},
                  {billiards::Place{{1e-7, 100}}, 0, ~std::uint64_t{0}}};
  replay.score = {300, 0};
  const std::string json = R"({
  "angry-balls-replay": 1,
  "physics": 1,
  "rules": 1,
  "game": "billiards",
  "score": [300, 0],
  "moves": [
    {"command": "shoot", "x": 331.5, "y": 0, "steps": 412, "hash": "0123456789abcdef"},
    {"command": "place", "x": 1e-07, "y": 100, "hash": "ffffffffffffffff"}
  ],
  "checksum": "56a6682f13f9cdb9"
}
)";
  EXPECT_EQ(replay::write_json(replay), json);
  const auto read = replay::read_json(json);
  ASSERT_TRUE(read) << problem(json);
  EXPECT_EQ(read.value(), replay);
}

TEST(ReplayFile, IsReadInAnyOrderAndLayout) {
  const auto read = replay::read_replay(
      "\n\t"
      R"({"checksum":"a19a64111a1d13ae","moves":[{)" +
      hash +
      R"(,"y":2E0,"steps":7,"x":-1.50,"command":"shoot"}],
      "score":[1,2],"game":"billiards","rules":1,"physics":1,"angry-balls-replay":1}  )");
  ASSERT_TRUE(read);
  replay::Replay replay;
  replay.moves = {{billiards::Shoot{{-1.5, 2}}, 7, 0x123456789abcdef}};
  replay.score = {1, 2};
  EXPECT_EQ(read.value(), replay);
}

TEST(ReplayFile, HoldsTheLevel) {
  const replay::Replay replay = short_level().replay();
  const std::string json = replay::write_json(replay);
  EXPECT_NE(json.find("  \"level\": {\n    \"carom\": 1,\n    \"name\": \"First steps\",\n"),
            std::string::npos);
  EXPECT_NE(json.find("\n  },\n  \"moves\": ["), std::string::npos);
  const auto read = replay::read_json(json);
  ASSERT_TRUE(read) << problem(json);
  EXPECT_EQ(read.value(), replay);
}

// A level's name and a wait at rest change no state.
TEST(ReplayFile, RefusesChangesThatNoHashWouldShow) {
  const std::string json = replay::write_json(short_level().replay());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = json;
    return other.replace(other.find(from), from.size(), to);
  };
  for (const std::string& other : {changed("First", "Worst"), changed("\"y\": 31", "\"y\": 31.1"),
                                   changed("\"score\": [0]", "\"score\": [1]")})
    EXPECT_NE(problem(other).find("/checksum: is not the replay's; expected the replay as it was"),
              std::string::npos);
  EXPECT_EQ(problem(changed("\"y\": 31", "\"y\":310e-1")), "no problem") << "the same number";
}

TEST(ReplayFile, NamesOptionsOnlyWhereTheyAreNotTheDefault) {
  replay::Replay replay;
  const std::string plain = replay::write_json(replay);
  EXPECT_EQ(plain.find("first-player"), std::string::npos);
  EXPECT_EQ(plain.find("keep-turn"), std::string::npos);
  // The default may be given all the same.
  std::string explicitly = plain;
  explicitly.insert(explicitly.find("\"score\""), "\"first-player\": 1, \"keep-turn\": false, ");
  EXPECT_EQ(replay::read_json(explicitly).value(), replay);
  replay.options = {.first_player = 1, .keep_turn = true};
  const std::string written = replay::write_json(replay);
  EXPECT_NE(written.find("\"first-player\": 2,\n  \"keep-turn\": true,\n"), std::string::npos);
  EXPECT_EQ(replay::read_json(written).value(), replay);
  replay.options.first_player = 2;
  EXPECT_EQ(carom::to_string(check(replay).front()), "/first-player: is 3; expected 1 or 2");
}

TEST(ReplayFile, WhatVersionOneCannotSayIsVersionTwo) {
  replay::Replay replay;
  replay.options = {.touch_red = true, .rack = billiards::Rack::quick};
  replay.occasion = {.computer = {0, 7}, .seed = 300, .best_of = 3, .won = {1, 0}, .duel = 5};
  const std::string written = replay::write_json(replay);
  EXPECT_NE(written.find(R"({
  "angry-balls-replay": 2,
  "physics": 1,
  "rules": 1,
  "game": "billiards",
  "reds": 15,
  "touch-red": true,
  "computer-2": 7,
  "seed": 300,
  "best-of": 3,
  "won-1": 1,
  "duel": 5,
  "score": [0, 0],
)"),
            std::string::npos)
      << written;
  EXPECT_EQ(replay::read_json(written).value(), replay);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = written;
    return problem(other.replace(other.find(from), from.size(), to));
  };
  EXPECT_NE(changed("replay\": 2", "replay\": 1").find("/angry-balls-replay: is 1"),
            std::string::npos);
  EXPECT_NE(changed("replay\": 2", "replay\": 3").find("/angry-balls-replay: "), std::string::npos);
  EXPECT_NE(changed("15", "14").find("/reds: is 14; expected 36 or 15"), std::string::npos);
  EXPECT_NE(changed("true", "1").find("/touch-red: is 1; expected true or false"),
            std::string::npos);
  EXPECT_NE(changed("300", "true").find("/seed: is true; expected a whole number"),
            std::string::npos);
  EXPECT_NE(changed("of\": 3", "of\": 2").find("/best-of: is 2; expected 1, 3 or 5"),
            std::string::npos);
  EXPECT_NE(changed("won-1\": 1", "won-1\": 2").find("/won-1: is 2; expected fewer games"),
            std::string::npos);
  EXPECT_NE(changed("billiards", "angry-balls").find("in \"angry-balls\""), std::string::npos);
}

TEST(ReplayFile, AShortGameTakesAFewHundredBytes) {
  replay::Replay replay = short_billiards().replay();
  EXPECT_LT(replay::write_json(replay).size(), 600U);
}

struct Wrong {
  std::string json;
  std::string problem;
};

class Refused : public testing::TestWithParam<Wrong> {};

TEST_P(Refused, WithPlaceAndReason) { EXPECT_EQ(problem(GetParam().json), GetParam().problem); }

const std::string keys =
    "angry-balls-replay, physics, rules, game, first-player, keep-turn, reds, touch-red, alone, "
    "computer-1, computer-2, seed, best-of, won-1, won-2, duel, score, level, moves, "
    "checksum";
const std::string shot = R"({"command": "shoot", "x": 1, "y": 2, "steps": 3, )" + hash + "}";

INSTANTIATE_TEST_SUITE_P(
    All, Refused,
    testing::Values(
        Wrong{"", "1:1: is empty; expected a replay: {\"angry-balls-replay\": 1, …}\n"},
        Wrong{"{", "1:2: is not valid JSON; expected a replay: {\"angry-balls-replay\": 1, …}\n"},
        Wrong{"{}", "1:1: /angry-balls-replay: is missing; expected a version, a whole number\n"},
        Wrong{"{} {}",
              "1:4: is not valid JSON; expected a replay: {\"angry-balls-replay\": 1, …}\n"},
        Wrong{std::string("{}\0", 3), "1:3: is not valid JSON: found the byte 0x00\n"},
        Wrong{R"({"angry-balls-replay": 3, "news": [)",
              "1:24: /angry-balls-replay: made by version 3, this is version 2\n"},
        Wrong{R"({"physics": 2})", "1:13: /physics: made by physics 2, this is physics 1\n"},
        Wrong{R"({"rules": 0})", "1:11: /rules: made by rules 0, this is rules 1\n"},
        Wrong{R"({"physics": 1.5})",
              "1:13: /physics: is 1.5; expected a version, a whole number\n"},
        Wrong{R"({"physics": -1})", "1:13: /physics: is -1; expected a version, a whole number\n"},
        Wrong{R"({"game": "chess"})",
              "1:10: /game: is \"chess\"; expected \"billiards\" or \"angry-balls\"\n"},
        Wrong{R"({"game": null})",
              "1:10: /game: is null; expected \"billiards\" or "
              "\"angry-balls\"\n"},
        Wrong{R"({"game": true})",
              "1:10: /game: is true; expected \"billiards\" or \"angry-balls\"\n"},
        Wrong{R"({"first-player": 0})", "1:18: /first-player: is 0; expected 1 or 2\n"},
        Wrong{R"({"first-player": 3})", "1:18: /first-player: is 3; expected 1 or 2\n"},
        Wrong{R"({"first-player": 1.5})", "1:18: /first-player: is 1.5; expected 1 or 2\n"},
        Wrong{R"({"keep-turn": 1})", "1:15: /keep-turn: is 1; expected true or false\n"},
        Wrong{R"({"keep-turn": "true"})",
              "1:15: /keep-turn: is \"true\"; expected true or false\n"},
        Wrong{R"({"game": "angry-balls", "keep-turn": false, "angry-balls-replay": 1,
  "physics": 1, "rules": 1})",
              "1:38: /keep-turn: is given; expected no keep-turn in \"angry-balls\"\n"},
        Wrong{R"({"news": 1})", "1:10: /news: is an unknown key; expected one of " + keys + "\n"},
        Wrong{R"({"rules": 1, "rules": 1})",
              "1:23: /rules: is given twice; expected every key at most once\n"},
        Wrong{R"({"level": 7})", "1:11: /level: is 7; expected a level, an object\n"},
        Wrong{R"({"level": [])", "1:11: /level: is an array; expected a level, an object\n"},
        Wrong{R"({"score": {}})",
              "1:11: /score: is an object; expected an array of the points made, in billiards by "
              "each player\n"},
        Wrong{R"({"score": [-1]})",
              "1:12: /score/0: is -1; expected the points made, a whole number from 0 to "
              "9007199254740991\n"},
        Wrong{R"({"score": [0, 9007199254740992]})",
              "1:15: /score/1: is 9007199254740992; expected the points made, a whole number from "
              "0 to "
              "9007199254740991\n"},
        Wrong{R"({"score": [1, 2, 3]})",
              "1:18: /score/2: is a third score; expected one score, in billiards two\n"},
        Wrong{billiards_with(R"("score": [1], "moves": [])"),
              "1:83: /score: has 1 elements; expected the points of both players\n"},
        Wrong{billiards_with(R"("score": [1, 2])"),
              "1:1: /moves: is missing; expected an array of what the players did\n"},
        Wrong{billiards_with("\n\"level\": " + level + R"(, "score": [1, 2], "moves": [])"),
              "2:10: /level: is given; expected no level in \"billiards\"\n"},
        Wrong{"{\n  \"level\": {\"carom\": 1, \"width\": 0, \n    \"height\": 100}}",
              "2:12: /level/balls: is missing; expected an array of balls\n"
              "2:34: /level/width: is 0; expected a number from 0.001 to 1000000000 (px)\n"},
        Wrong{R"({"level": {"carom": 1, "width": 9, "height": 9, "balls": []}})",
              "1:58: /level/balls: have no projectile; expected the first ball to have the role "
              "\"projectile\"\n"
              "1:58: /level/balls: have no enemy; expected at least one ball with the role "
              "\"enemy\"\n"},
        Wrong{R"({"level": {"width": 1e999}})", "1:11: /level: is too large; expected a number\n"},
        Wrong{moves("7"),
              "1:101: /moves/0: is 7; expected an object such as {\"command\": \"next\", \"hash\": "
              "\"…\"}\n"},
        Wrong{moves(R"({"x": 1e400})"), "1:107: /moves/0/x: is too large; expected a number\n"},
        Wrong{moves(R"({"x": NaN})"),
              "1:107: is not valid JSON; expected a replay: {\"angry-balls-replay\": 1, …}\n"},
        Wrong{moves(R"({"x": "1"})"), "1:107: /moves/0/x: is \"1\"; expected a number (px)\n"},
        Wrong{moves(R"({"z": 1})"),
              "1:107: /moves/0/z: is an unknown key; expected one of command, x, y, steps, hash\n"},
        Wrong{moves(R"({"x": 1, "x": 1})"),
              "1:115: /moves/0/x: is given twice; expected every key at most once\n"},
        Wrong{moves(R"({"steps": 360001})"),
              "1:111: /moves/0/steps: is 360001; expected a whole number from 0 to 360000\n"},
        Wrong{moves(R"({"hash": "0123456789ABCDEF"})"),
              "1:110: /moves/0/hash: is \"0123456789ABCDEF\"; expected 16 hexadecimal digits, "
              "lower case, in double quotes\n"},
        Wrong{moves(shot + ", {" + hash + "}"),
              "1:179: /moves/1/command: is missing; expected \"shoot\", \"place\", \"throw\" or "
              "\"next\"\n"},
        Wrong{moves(R"({"command": "shoot", "x": 1, "y": 2, )" + hash + "}"),
              "1:101: /moves/0/steps: is missing; expected a whole number from 0 to 360000\n"},
        Wrong{moves(R"({"command": "place", "x": 1, "y": 2, "steps": 0, )" + hash + "}"),
              "1:147: /moves/0/steps: is given; expected no steps with \"place\"\n"},
        Wrong{moves(R"({"command": "throw", "x": 1, "y": 2, "steps": 0, )" + hash + "}"),
              "1:113: /moves/0/command: is \"throw\"; expected \"shoot\" or \"place\" in "
              "billiards\n"},
        Wrong{moves(R"({"command": "next", "y": 2, )" + hash + "}"),
              "1:126: /moves/0/y: is given; expected no y with \"next\"\n"}));

TEST(ReplayFile, TheSchemaKnowsTheSameKeys) {
  using Json = nlohmann::ordered_json;
  const Json schema = Json::parse(content(SOURCE_DIR "/schemas/replay.schema.json"));
  const auto expect_keys = [](const Json& object, const std::string& json) {
    std::string names;
    for (const auto& [key, rest] : object.at("properties").items())
      names += (names.empty() ? "" : ", ") + key;
    EXPECT_NE(problem(json).find("is an unknown key; expected one of " + names + "\n"),
              std::string::npos)
        << problem(json) << names;
  };
  expect_keys(schema, R"({"?": 0})");
  expect_keys(schema.at("properties").at("moves").at("items"), R"({"moves": [{"?": 0}]})");
}

TEST(ReplayFile, TheDocumentedOneIsReal) {
  const std::string documented =
      content(SOURCE_DIR "/tests/replays/billiards-left-in-the-middle.json");
  EXPECT_NE(content(SOURCE_DIR "/docs/formats.md").find("```json\n" + documented + "```\n"),
            std::string::npos);
}

TEST(ReplayFile, RefusesFilesTooDeepTooLongOrTooLarge) {
  EXPECT_NE(problem(R"({"level": {"x": )" + std::string(100'000, '[')).find("is nested too deeply"),
            std::string::npos);
  EXPECT_NE(problem(R"({"level": )" + std::string(100'000, '{')).find("is not valid JSON"),
            std::string::npos);
  EXPECT_EQ(problem("{" + std::string(replay::max_bytes, ' ')),
            "is larger than 4194304 bytes; expected a replay\n");
  std::string many = shot;
  for (std::size_t n = 0; n < replay::max_moves; ++n) many += "," + shot;
  EXPECT_NE(problem(moves(many)).find("/moves: has more than 10000 elements"), std::string::npos);
}

TEST(ReplayFile, AnySoundReplayIsReadBack) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const replay::Replay replay = random_replay(seed);
    ASSERT_TRUE(check(replay).empty());
    const std::string json = replay::write_json(replay);
    const auto read = replay::read_replay(json);
    ASSERT_TRUE(read) << seed << ' ' << problem(json);
    ASSERT_EQ(read.value(), replay) << seed;
    ASSERT_EQ(replay::write_json(read.value()), json) << seed;
  }
}

}  // namespace
