#include "search/proof.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/scene_file.hpp"
#include "games/level_identity.hpp"
#include "project_file.hpp"
#include "search/opponent.hpp"
#include "search/proof_file.hpp"

namespace {

using games::angry_balls::Game;
using Json = nlohmann::ordered_json;
using search::LevelGames;
using search::Proof;

Game level(const std::string& name) {
  return Game::create(carom::read_scene(project_file("levels/" + name + ".json")).value()).value();
}

const Proof& proof_of_two_towers() {
  static const Proof proof = [] {
    carom::Rollouts rollouts;
    return search::prove(level("02-two-towers"), {.games = 4, .seed = 3}, rollouts).value();
  }();
  return proof;
}

TEST(LevelGames, OfAnExactHand_AreWonWithinTheThrowsOfTheLevel) {
  carom::Rollouts rollouts;
  const LevelGames games =
      search::play_level(level("02-two-towers"), search::LevelPlayer{}, 10, 1, rollouts);
  EXPECT_EQ(games.games, 10U);
  EXPECT_EQ(games.won_in.size(), 3U);
  EXPECT_EQ(games.won(), 10U);
  ASSERT_EQ(games.scores.size(), 10U);
  EXPECT_TRUE(std::ranges::is_sorted(games.scores));
  EXPECT_GE(games.scores.front(), 300);  // three enemies, one a throw
}

TEST(LevelGames, OfASteadierHand_AreWonMoreOften) {
  carom::Rollouts rollouts;
  const Game game = level("05-over-the-wall");
  const auto won = [&](const std::optional<search::LevelPlayer>& player) {
    return search::play_level(game, player, 40, 1, rollouts).won();
  };
  const auto exact = won(search::LevelPlayer{.hand = {0}});
  const auto steady = won(search::reference_player);
  const auto random = won(std::nullopt);
  EXPECT_GT(exact, steady);
  EXPECT_GT(steady, random + 5);
}

TEST(LevelGames, SameSeed_SameForEveryNumberOfThreads) {
  carom::Rollouts one(1);
  carom::Rollouts three(3);
  const Game game = level("10-the-fortress");
  const LevelGames games = search::play_level(game, search::reference_player, 6, 5, one);
  EXPECT_EQ(games, search::play_level(game, search::reference_player, 6, 5, three));
  EXPECT_NE(games, search::play_level(game, search::reference_player, 6, 6, one));
}

TEST(Proofs, OfALevel_SayWhatItIsAndHold) {
  const Proof& proof = proof_of_two_towers();
  const Game game = level("02-two-towers");
  carom::Rollouts rollouts;
  EXPECT_EQ(proof.level, games::angry_balls::identity(game.level()));
  EXPECT_EQ(proof.physics, carom::physics_version);
  EXPECT_EQ(proof.rules, carom::rules_version);
  EXPECT_EQ(proof.search, search::version);
  EXPECT_TRUE(search::check_proof(game, proof, rollouts));
  EXPECT_TRUE(search::verify_proof(game, proof, rollouts));
  EXPECT_EQ(proof.difficulty().mean,
            1 - static_cast<double>(proof.hands[search::reference_hand].won()) / 4);
}

TEST(Proofs, Stars_AreParAndTheScoreOfATenthOfTheHandOfTwoPixels) {
  const Game game = level("04-off-the-back-wall");
  carom::Rollouts rollouts;
  const search::Throws way = search::solve(game, 20'000, 1, rollouts).found.front();
  const Proof proof = search::measured(game, way, {.games = 20, .seed = 1}, rollouts);
  const LevelGames games = search::play_level(game, search::LevelPlayer{.hand = {2}}, 20,
                                              1 + search::star_hand, rollouts);
  ASSERT_GT(games.won(), 10U);
  std::uint64_t won = 0;
  for (int i = 0; i < proof.stars.par; ++i) won += games.won_in[static_cast<std::size_t>(i)];
  EXPECT_GE(2 * won, 20U);
  EXPECT_LT(2 * (won - games.won_in[static_cast<std::size_t>(proof.stars.par - 1)]), 20U);
  const auto reach = std::ranges::count_if(
      games.scores, [&](std::int64_t score) { return score >= proof.stars.gold; });
  EXPECT_GE(10 * static_cast<std::uint64_t>(reach), games.won());
  const auto beyond = std::ranges::count_if(
      games.scores, [&](std::int64_t score) { return score > proof.stars.gold; });
  EXPECT_LE(10 * static_cast<std::uint64_t>(beyond), games.won());
}

TEST(Proofs, OfALevelThatNothingWins_AreRefusedWithTheNumberOfSimulations) {
  carom::Scene scene = level("02-two-towers").level();
  for (carom::Ball& ball : scene.balls)
    if (ball.role == carom::Role::enemy) ball.solidity = carom::infinite_solidity;
  scene.edges = {};
  carom::Rollouts rollouts;
  const auto proof =
      search::prove(Game::create(scene).value(), {.simulations = 1000, .games = 1}, rollouts);
  ASSERT_FALSE(proof);
  EXPECT_EQ(carom::to_string(proof.errors()[0].problem),
            "no winning throws found in 1000 simulations");
}

TEST(Proofs, OfAnotherLevel_AreRefused) {
  carom::Rollouts rollouts;
  const auto status = search::check_proof(level("01-first-steps"), proof_of_two_towers(), rollouts);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.errors()[0].pointer, "/level");
}

TEST(Proofs, WithTheReplayOfAnotherLevel_AreRefused) {
  Proof proof = proof_of_two_towers();
  carom::Rollouts rollouts;
  const Game other = level("01-first-steps");
  proof.level = games::angry_balls::identity(other.level());
  const auto status = search::check_proof(other, proof, rollouts);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.errors()[0].pointer, "/replay");
}

TEST(Proofs, WithThrowsThatDoNotWin_AreRefused) {
  const Game game = level("02-two-towers");
  carom::Rollouts rollouts;
  const Proof proof =
      search::measured(game, {{.tenths = 1800, .speed = 100}}, {.games = 1}, rollouts);
  const auto status = search::check_proof(game, proof, rollouts);
  ASSERT_FALSE(status);
  EXPECT_EQ(carom::to_string(status.errors()[0].problem), "does not win");
}

TEST(ProofFiles, Written_ReadBackAsTheyWere) {
  const std::string text = search::write_proof(proof_of_two_towers());
  const auto read = search::read_proof(text);
  ASSERT_TRUE(read) << carom::to_string(read.errors()[0]);
  EXPECT_EQ(read.value(), proof_of_two_towers());
  EXPECT_EQ(search::write_proof(read.value()), text);
}

TEST(ProofFiles, AnyValueChanged_AreRefused) {
  const Game game = level("02-two-towers");
  carom::Rollouts rollouts;
  const Json whole = Json::parse(search::write_proof(proof_of_two_towers()));
  const Json flat = whole.flatten();
  int changed = 0;
  for (const auto& [pointer, value] : flat.items()) {
    Json wrong = whole;
    Json& place = wrong[Json::json_pointer(pointer)];
    if (value.is_string())
      place = value.get<std::string>().substr(1);
    else if (value.is_number_float())
      place = value.get<double>() + 0.1;
    else
      place = value.get<std::int64_t>() + 1;
    const auto read = search::read_proof(wrong.dump());
    const bool refused = !read || !search::verify_proof(game, read.value(), rollouts);
    EXPECT_TRUE(refused) << pointer;
    ++changed;
  }
  EXPECT_GT(changed, 40);
}

TEST(ProofFiles, WrongTexts_AreRefusedWithAPointer) {
  const Json whole = Json::parse(search::write_proof(proof_of_two_towers()));
  const auto pointer_of = [](const Json& json) {
    const auto read = search::read_proof(json.dump());
    return read ? std::string("none") : read.errors()[0].pointer;
  };
  EXPECT_EQ(pointer_of(whole), "none");
  Json more = whole;
  more["more"] = 1;
  EXPECT_EQ(pointer_of(more), "/more");
  Json without = whole;
  without.erase("stars");
  EXPECT_EQ(pointer_of(without), "/stars");
  Json typed = whole;
  typed["throws"] = "one";
  EXPECT_EQ(pointer_of(typed), "/throws");
  Json many = whole;
  many["hands"][0]["games"] = search::most_proof_games + 1;
  EXPECT_EQ(pointer_of(many), "/hands/0/games");
  EXPECT_FALSE(search::read_proof("{"));
  EXPECT_FALSE(search::read_proof("[1]"));
  EXPECT_FALSE(search::read_proof("{}"));
}

TEST(ProofFiles, Names_LieBesideTheLevels) {
  EXPECT_EQ(search::proof_name("a.b/level.json"), "a.b/level.proof.json");
  EXPECT_EQ(search::proof_name("a.b/level"), "a.b/level.proof.json");
  EXPECT_EQ(search::proof_name("mine.angry-level"), "mine.proof.json");
  EXPECT_EQ(search::level_name("a/b.proof.json"), "a/b.json");
  EXPECT_EQ(search::level_name("a/b.json"), "a/b.json");
  EXPECT_TRUE(search::lies_beside_levels("levels/a.proof.json"));
  EXPECT_TRUE(search::lies_beside_levels("pack.json"));
  EXPECT_TRUE(search::lies_beside_levels("levels/pack.json"));
  EXPECT_FALSE(search::lies_beside_levels("levels/backpack.json"));
  EXPECT_FALSE(search::lies_beside_levels("levels/proof.json"));
}

}  // namespace
