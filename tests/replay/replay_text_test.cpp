#include "replay/replay_text.hpp"

#include <gtest/gtest.h>
#include <string>
#include <string_view>

#include "replay/player.hpp"
#include "replay/random_replay.hpp"
#include "replay/replay_file.hpp"
#include "replay/text_of.hpp"

namespace {

using namespace recorded;

std::string problem(std::string_view text) {
  const auto read = replay::read_text(text);
  return read ? "no problem" : carom::to_string(read.errors().front());
}

// Physics, rules, billiards, both scores, the number of moves.
const std::string empty_game("\x01\x01\x00\x00\x00\x00", 6);

TEST(ReplayText, FollowsTheDocumentedFormat) {
  EXPECT_EQ(replay::write_text({}), text_of(empty_game));
  replay::Replay replay;
  replay.moves = {{billiards::Shoot{{1, -0.015625}}, 300, 0x1234567890abcdef},
                  {billiards::Place{{0.1, 2}}, 0, 0x1122334455667788}};
  replay.score = {300, 1};
  const std::string payload =
      empty_game.substr(0, 3) + "\xac\x02\x01\x02" + std::string("\0\3", 2) +
      std::string("\x80\x01\0\x2c", 4).substr(0, 2) + std::string("\0", 1).substr(1);
  // Numbers 128 (x 1), 1 (y -1/64), 256 (y 2) and 300 (steps), by their lowest bytes, the next…
  const std::string numbers("\x80\x01\x00\x2c\x00\x00\x01\x01\x00\x00\x00\x00", 12);
  const std::string other("\x9a\x99\x99\x99\x99\x99\xb9\x3f", 8);  // 0.1
  const std::string hashes("\xef\x88\x77\x66\x55\x44\x33\x22\x11", 9);
  const std::string whole = empty_game.substr(0, 3) + "\xac\x02\x01\x02" + std::string("\0\3", 2) +
                            numbers + other + hashes;
  EXPECT_EQ(replay::write_text(replay), text_of(whole));
  EXPECT_EQ(replay::read_text(text_of(whole)).value(), with_short_hashes(replay));
}

TEST(ReplayText, OptionsOfBilliardsAreAnotherGame) {
  replay::Replay replay;
  const auto with = [](char options) {
    return text_of(std::string("\x01\x01\x02", 3) + options + std::string("\0\0\0", 3));
  };
  replay.options.first_player = 1;
  EXPECT_EQ(replay::write_text(replay), with(1));
  replay.options.keep_turn = true;
  EXPECT_EQ(replay::write_text(replay), with(3));
  EXPECT_EQ(replay::read_text(with(3)).value(), with_short_hashes(replay));
  EXPECT_NE(problem(with(0)), "no problem") << "a second form of the usual game";
  EXPECT_NE(problem(with(4)), "no problem");
}

TEST(ReplayText, WhatVersionOneCannotSayIsVersionTwo) {
  replay::Replay replay;
  replay.options = {.keep_turn = true, .touch_red = true, .rack = billiards::Rack::quick};
  replay.occasion = {.computer = {0, 7}, .seed = 300, .best_of = 3, .won = {1, 0}, .duel = 5};
  // Physics, rules, billiards, options; reds, touch-red, alone, computers, seed, match, duel;
  // scores, the number of moves.
  const std::string payload("\x01\x01\x00\x02\x0f\x01\x00\x00\x07\xac\x02\x03\x01\x00\x05\0\0\0",
                            18);
  EXPECT_EQ(replay::write_text(replay), text_of(payload, 2));
  EXPECT_EQ(replay::read_text(text_of(payload, 2)).value(), with_short_hashes(replay));
  EXPECT_NE(problem(text_of(payload, 1)), "no problem");
  EXPECT_NE(problem(text_of(payload, 3)), "no problem");
  // A usual game has one form only.
  const std::string usual("\x01\x01\x00\x00\x24\x00\x00\x00\x00\x00\x01\x00\x00\x00\0\0\0", 17);
  EXPECT_NE(problem(text_of(usual, 2)), "no problem");
  for (const auto& [at, wrong] : {std::pair<std::size_t, char>{2, 2},
                                  {3, 4},
                                  {4, 14},
                                  {5, 2},
                                  {8, 11},
                                  {11, 2},
                                  {11, 7},
                                  {12, 2}}) {
    std::string other = payload;
    other[at] = wrong;
    EXPECT_NE(problem(text_of(other, 2)), "no problem") << at;
  }
}

TEST(ReplayText, AnySoundReplayIsReadBack) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const replay::Replay replay = random_replay(seed);
    const std::string text = replay::write_text(replay);
    const auto read = replay::read_replay(" " + text + "\r\n");
    ASSERT_TRUE(read) << seed << ' ' << problem(text);
    ASSERT_EQ(read.value(), with_short_hashes(replay)) << seed;
    ASSERT_EQ(replay::write_text(read.value()), text) << seed;
  }
}

TEST(ReplayText, IsTakenAsItWasPasted) {
  const std::string text = text_of(empty_game);
  const std::string fold = text.substr(0, 7) + "\r\n" + text.substr(7);
  for (const std::string& pasted :
       {text, fold, "\xEF\xBB\xBF" + text + "\n", " \t" + text + " \r\n",
        "https://example.org/play/?a=b#replay=" + fold,
        "<https://example.org/#replay=" + text + ">",
        "> " + text.substr(0, 5) + "\n> " + text.substr(5) + "\n",
        text.substr(0, 9) + "=\r\n" + text.substr(9), '"' + text + '"', "\u201c" + text + "\u201d",
        "(https://example.org/#replay=" + text + ").", text + ",\n", "`" + text + "`",
        text.substr(0, 9) + "\u00a0" + text.substr(9, 3) + "\u200b" + text.substr(12),
        text.substr(0, 9) + "\u00ad\r\n" + text.substr(9), "\ufeff\u2060" + text + "\u2028"}) {
    EXPECT_EQ(problem(pasted), "no problem") << pasted;
    EXPECT_TRUE(replay::read_replay(pasted)) << pasted;
  }
  for (const char* within : {".", "\"", "<", "\u201c", "é", "\u200d", "\xff"})
    EXPECT_NE(problem(text.substr(0, 7) + within + text.substr(7)), "no problem") << within;
}

TEST(ReplayText, MinusZeroIsZero) {
  replay::Replay replay;
  replay.moves = {{billiards::Shoot{{-0.0, 1}}, 3, 4}};
  replay::Replay zero = replay;
  zero.moves[0].command = billiards::Shoot{{0, 1}};
  EXPECT_EQ(replay::write_text(replay), replay::write_text(zero));
}

TEST(ReplayText, AWholeGameOfBilliardsTakesLessThanTwoKilobytes) {
  // A hundred turns of a player without a plan; two who aim need far fewer.
  const auto read = replay::read_json(content(SOURCE_DIR "/tests/replays/billiards-whole.json"));
  ASSERT_TRUE(read);
  EXPECT_GE(read.value().moves.size(), 100U);
  EXPECT_LT(replay::write_text(read.value()).size(), 2000U);
}

TEST(ReplayText, RefusesOtherPhysicsAndRules) {
  EXPECT_EQ(problem(text_of("\x02")), "made by physics 2, this is physics 1");
  EXPECT_EQ(problem(text_of("\x01\x07")), "made by rules 7, this is rules 1");
  EXPECT_EQ(problem(text_of(empty_game, 3)),
            "is version 3 of the text of a replay; expected version 1");
}

TEST(ReplayText, RefusesPartsOfAText) {
  const std::string text = replay::write_text(short_level().replay());
  for (std::size_t size = 0; size < text.size(); ++size) {
    ASSERT_NE(problem(text.substr(0, size)), "no problem") << size;
    ASSERT_NE(problem(text.substr(size + 1)), "no problem") << size;
  }
  EXPECT_NE(problem(text + "A"), "no problem");
  EXPECT_EQ(problem("AQ=="),
            "is no text of a replay: its character 3 does not belong there; expected letters, "
            "digits, - and _ only");
  EXPECT_EQ(problem(std::string(8 << 20, 'A')),
            "is longer than 5592408 characters; expected the text of a replay");
}

TEST(ReplayText, RefusesEveryOtherCharacterAtEveryPlace) {
  const std::string text = replay::write_text(short_billiards().replay());
  ASSERT_EQ(problem(text), "no problem");
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (const char c : std::string_view("ABQ09-_")) {
      if (c == text[at]) continue;
      std::string changed = text;
      changed[at] = c;
      ASSERT_NE(problem(changed), "no problem") << at << ' ' << c;
    }
  }
}

TEST(ReplayText, RefusesImpossibleContents) {
  const auto with = [](std::size_t at, char byte) {
    std::string payload = empty_game;
    payload[at] = byte;
    return text_of(payload);
  };
  EXPECT_EQ(problem(text_of(empty_game)), "no problem");
  EXPECT_NE(problem(with(2, 2)).find("is damaged"), std::string::npos) << "no third game";
  EXPECT_NE(problem(with(5, 1)).find("is damaged"), std::string::npos) << "a move is missing";
  EXPECT_NE(problem(text_of(empty_game + "x")).find("is damaged"), std::string::npos);
  EXPECT_NE(problem(text_of(std::string("\x81\x00", 2) + empty_game.substr(1)))
                .find("is not written as it should be"),
            std::string::npos)
      << "a number that is longer than need be";
  EXPECT_NE(problem(text_of(empty_game.substr(0, 5) + std::string("\x91\x4e", 2))).find("10001"),
            std::string::npos);
  EXPECT_NE(problem(text_of(empty_game.substr(0, 3) + std::string(11, '\xff'))).find("is damaged"),
            std::string::npos);
}

// 20 MB of spaces, packed into 20 kB: unpacking stops at the limit.
TEST(ReplayText, RefusesABomb) {
  const std::string text = text_of(std::string(20 << 20, ' '));
  EXPECT_LT(text.size(), 40'000U);
  EXPECT_EQ(problem(text),
            "is damaged: it cannot be unpacked, or not into 4194304 bytes; expected the text of a "
            "replay, whole and unchanged");
}

}  // namespace
