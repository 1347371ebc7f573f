#include "app/storage/best_scores.hpp"

#include <gtest/gtest.h>

namespace {

using app::BestScores;
using app::MemoryStore;

const std::string file = "scores.json";
const std::string level = "0123456789abcdef";
const std::string other = "fedcba9876543210";

std::optional<std::string> stored(app::Store& store, const std::string& name = file) {
  return store.load(name).value();
}

TEST(BestScores, NoneAtFirst) {
  MemoryStore store;
  const BestScores scores(store);
  EXPECT_FALSE(scores.of(level));
  EXPECT_EQ(scores.trouble(), BestScores::Trouble::none);
  EXPECT_FALSE(stored(store)) << "nothing is saved before there is something";
}

TEST(BestScores, AreSavedAndOnlyImproved) {
  MemoryStore store;
  BestScores scores(store);
  EXPECT_TRUE(scores.record(level, 300));
  EXPECT_FALSE(scores.record(level, 300));
  EXPECT_FALSE(scores.record(level, 100));
  EXPECT_TRUE(scores.record(level, 1200));
  EXPECT_EQ(scores.of(level), 1200);
  EXPECT_EQ(BestScores(store).of(level), 1200);
  EXPECT_EQ(*stored(store),
            "{\n  \"angry-balls-scores\": 1,\n  \"best\": {\n"
            "    \"0123456789abcdef\": 1200\n  }\n}\n");
}

TEST(BestScores, OfAnotherWindowAreNotLost) {
  MemoryStore store;
  BestScores mine(store);
  BestScores theirs(store);
  theirs.record(other, 500);
  theirs.record(level, 900);
  EXPECT_TRUE(mine.record(level, 300));
  EXPECT_EQ(BestScores(store).of(other), 500);
  EXPECT_EQ(BestScores(store).of(level), 900);
}

class Foreign : public testing::TestWithParam<const char*> {};

TEST_P(Foreign, IsSetAsideAndNeverOverwritten) {
  MemoryStore store;
  ASSERT_TRUE(store.save(file, GetParam()));
  BestScores scores(store);
  EXPECT_EQ(scores.trouble(), BestScores::Trouble::set_aside);
  EXPECT_FALSE(scores.of(level));
  EXPECT_FALSE(stored(store));
  EXPECT_TRUE(scores.record(level, 300));
  EXPECT_EQ(stored(store, file + ".broken"), GetParam());
  EXPECT_EQ(BestScores(store).of(level), 300);
}

INSTANTIATE_TEST_SUITE_P(
    All, Foreign,
    testing::Values("", "{", "[]", "7", "{}", "\xff\xfe", R"({"angry-balls-scores": 1})",
                    R"({"angry-balls-scores": 2, "best": {}})",
                    R"({"angry-balls-scores": 1.0, "best": {}})",
                    R"({"angry-balls-scores": "1", "best": {}})",
                    R"({"angry-balls-scores": 1, "best": []})",
                    R"({"angry-balls-scores": 1, "best": {}, "more": 1})",
                    R"({"angry-balls-scores": 1, "best": {"0123456789abcdef": -1}})",
                    R"({"angry-balls-scores": 1, "best": {"0123456789abcdef": 9007199254740992}})",
                    R"({"angry-balls-scores": 1, "best": {"0123456789abcdef": 1e3}})",
                    R"({"angry-balls-scores": 1, "best": {"0123456789abcdef": null}})",
                    R"({"angry-balls-scores": 1, "best": {"0123456789ABCDEF": 1}})",
                    R"({"angry-balls-scores": 1, "best": {"level 1": 100}})"));

TEST(BestScores, AWrongEntryCostsNoOther) {
  MemoryStore store;
  const std::string text = R"({"angry-balls-scores": 1, "best": {"0123456789abcdef": -2146800000,
      "level 1": 7, "fedcba9876543210": 2150000000}})";
  ASSERT_TRUE(store.save(file, text));
  const BestScores scores(store);
  EXPECT_EQ(scores.trouble(), BestScores::Trouble::set_aside);
  EXPECT_FALSE(scores.of(level));
  EXPECT_EQ(scores.of(other), 2'150'000'000);
  EXPECT_EQ(stored(store, file + ".broken"), text);
  const BestScores next(store);
  EXPECT_EQ(next.trouble(), BestScores::Trouble::none);
  EXPECT_EQ(next.of(other), 2'150'000'000);
}

TEST(BestScores, RecordedScoresAreReadBack) {
  MemoryStore store;
  BestScores scores(store);
  std::uint64_t random = 1;
  for (int i = 0; i < 200; ++i) {
    random = random * 6364136223846793005U + 1442695040888963407U;
    // Over all magnitudes, the extremes of either sign too.
    const auto score = static_cast<std::int64_t>(random) >> (i % 64);
    std::string identity = std::to_string(i);
    identity.insert(0, 16 - identity.size(), 'a');
    scores.record(identity, score);
    const BestScores read(store);
    ASSERT_EQ(read.trouble(), BestScores::Trouble::none) << score;
    ASSERT_EQ(read.of(identity), scores.of(identity)) << score;
  }
}

/// A disk that refuses some things.
struct BadStore : app::Store {
  bool loads = true, saves = true, moves = true;
  int saved = 0;

  carom::Result<std::optional<std::string>> load(const std::string&) override {
    if (!loads) return carom::Error{.problem = "cannot be read"};
    return std::optional<std::string>(moves ? "" : "foreign");
  }
  carom::Status save(const std::string&, const std::string&) override {
    ++saved;
    if (!saves) return carom::Error{.problem = "cannot be written"};
    return carom::Done{};
  }
  carom::Result<bool> save_new(const std::string&, const std::string&) override { return false; }
  carom::Status remove(const std::string&) override { return carom::Done{}; }
  std::vector<std::string> list(const std::string&) override { return {}; }
  carom::Status set_aside(const std::string&) override {
    if (!moves) return carom::Error{.problem = "cannot be moved"};
    return carom::Done{};
  }
};

TEST(BestScores, LastUntilTheEndOnADiskThatCannotBeWritten) {
  BadStore store;
  store.saves = false;
  BestScores scores(store);
  EXPECT_TRUE(scores.record(level, 300));
  EXPECT_EQ(scores.of(level), 300);
  EXPECT_EQ(scores.trouble(), BestScores::Trouble::not_kept);
}

TEST(BestScores, AFileThatCannotBeReadOrMovedIsNotOverwritten) {
  BadStore unreadable;
  unreadable.loads = false;
  BadStore fixed;
  fixed.moves = false;
  for (BadStore* store : {&unreadable, &fixed}) {
    BestScores scores(*store);
    EXPECT_TRUE(scores.record(level, 300));
    EXPECT_EQ(scores.of(level), 300);
    EXPECT_EQ(scores.trouble(), BestScores::Trouble::not_kept);
    EXPECT_EQ(store->saved, 0);
  }
}

}  // namespace
