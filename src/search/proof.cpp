#include "search/proof.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "carom/arithmetic.hpp"
#include "games/launch.hpp"
#include "games/level_identity.hpp"
#include "replay/player.hpp"
#include "replay/replay_text.hpp"
#include "search/opponent.hpp"

namespace search {

namespace {

using LevelGame = games::angry_balls::Game;

/// The scores are of the games won, the lowest first.
Stars stars_of(const LevelGames& games, std::int64_t otherwise) {
  Stars stars{.par = static_cast<int>(games.won_in.size()), .gold = otherwise};
  std::uint64_t won = 0;
  for (std::size_t i = games.won_in.size(); i > 0; --i) {
    won = std::accumulate(games.won_in.begin(),
                          games.won_in.begin() + static_cast<std::ptrdiff_t>(i), std::uint64_t{0});
    if (2 * won < games.games) break;
    stars.par = static_cast<int>(i);
  }
  // Nearest rank.
  if (const std::size_t n = games.scores.size(); n > 0)
    stars.gold = games.scores[(9 * n + 9) / 10 - 1];
  return stars;
}

/// The typed throws of a replay; none if one is not typed.
std::optional<Throws> throws_of(const replay::Replay& replay) {
  Throws throws;
  for (const replay::Move& move : replay.moves) {
    const auto* thrown = std::get_if<games::angry_balls::Throw>(&move.command);
    if (thrown == nullptr) continue;
    const carom::Vec2 velocity = games::launch_velocity(thrown->drag);
    if (velocity == carom::Vec2{}) return std::nullopt;
    throws.push_back(nearest_aim(velocity));
    if (drag(throws.back()) != thrown->drag) return std::nullopt;
  }
  return throws;
}

carom::Error version_error(const std::string& what, int made, int own) {
  return {.pointer = "/" + what,
          .problem = "is " + std::to_string(made),
          .expected = std::to_string(own) + "; prove the level again"};
}

/// The throws that a proof's replay holds, played to see that they win.
carom::Result<Throws> winning_throws(const LevelGame& level, const std::string& text) {
  auto read = replay::read_text(text);
  if (!read) return carom::Error{.pointer = "/replay", .problem = read.errors().front().problem};
  const auto& scene = read.value().level;
  if (!scene || games::angry_balls::identity(*scene) != games::angry_balls::identity(level.level()))
    return carom::Error{.pointer = "/replay",
                        .problem = "is of another game",
                        .expected = "a replay of this level"};
  const auto throws = throws_of(read.value());
  auto player = replay::verify(std::move(read).value());
  if (!player) return player.errors();
  if (player.value().divergence())
    return carom::Error{
        .pointer = "/replay",
        .problem = replay::to_string(*player.value().divergence(), player.value().turns().size())};
  player.value().seek(player.value().turns().size());
  const auto& end = std::get<LevelGame>(player.value().game());
  if (end.phase() != games::angry_balls::Phase::won)
    return carom::Error{
        .pointer = "/replay", .problem = "does not win", .expected = "a game that is won"};
  if (!throws)
    return carom::Error{.pointer = "/replay",
                        .problem = "has a throw that cannot be typed",
                        .expected = "tenths of a degree and whole px/s"};
  return *throws;
}

std::vector<ProvenThrow> proven(const LevelGame& level, const Throws& throws,
                                carom::Rollouts& rollouts) {
  std::vector<ProvenThrow> proven;
  for (std::size_t i = 0; i < throws.size(); ++i)
    proven.push_back({.aim = throws[i], .margin = margin(level, throws, i, rollouts)});
  return proven;
}

carom::Error differs(std::string pointer) {
  return {.pointer = std::move(pointer),
          .problem = "is not what playing gives",
          .expected = "what carom prove writes"};
}

}  // namespace

Estimate Proof::difficulty() const {
  const LevelGames& played = hands[reference_hand];
  return estimate_rate(played.games, played.games - played.won());
}

Proof measured(const LevelGame& level, const Throws& throws, const ProofPlan& plan,
               carom::Rollouts& rollouts) {
  const replay::Replay won = replay_of(level, throws);
  Proof proof{.level = games::angry_balls::identity(level.level()),
              .physics = carom::physics_version,
              .rules = carom::rules_version,
              .search = version,
              .seed = plan.seed,
              .games = plan.games,
              .replay = replay::write_text(won),
              .throws = proven(level, throws, rollouts)};
  for (std::size_t i = 0; i < proof_hands.size(); ++i) {
    const LevelPlayer player{.hand = {proof_hands[i]}, .simulations = reference_player.simulations};
    proof.hands[i] = play_level(level, player, plan.games, plan.seed + i, rollouts);
    if (i == star_hand) proof.stars = stars_of(proof.hands[i], won.score[0]);
    proof.hands[i].scores.clear();
  }
  proof.random = play_level(level, {}, random_games * plan.games, plan.seed, rollouts);
  proof.random.scores.clear();
  return proof;
}

carom::Errors not_found(const Solved& solved) {
  return {{.problem = "no winning throws found in " + std::to_string(solved.simulations) +
                      " simulations"}};
}

carom::Result<Proof> prove(const LevelGame& level, const ProofPlan& plan,
                           carom::Rollouts& rollouts) {
  const Solved solved = solve(level, plan.simulations, plan.seed, rollouts);
  if (solved.found.empty()) return not_found(solved);
  return measured(level, most_robust(level, solved, plan.seed, rollouts), plan, rollouts);
}

carom::Status check_proof(const LevelGame& level, const Proof& proof, carom::Rollouts& rollouts) {
  if (proof.level != games::angry_balls::identity(level.level()))
    return carom::Error{.pointer = "/level",
                        .problem = "is " + proof.level,
                        .expected = games::angry_balls::identity(level.level()) +
                                    ", the level's identity; prove it again"};
  if (proof.physics != carom::physics_version)
    return version_error("physics", proof.physics, carom::physics_version);
  if (proof.rules != carom::rules_version)
    return version_error("rules", proof.rules, carom::rules_version);
  const auto throws = winning_throws(level, proof.replay);
  if (!throws) return throws.errors();
  if (proof.throws != proven(level, throws.value(), rollouts)) return differs("/throws");
  return carom::Done{};
}

carom::Status verify_proof(const LevelGame& level, const Proof& proof, carom::Rollouts& rollouts) {
  if (const carom::Status sound = check_proof(level, proof, rollouts); !sound) return sound;
  if (proof.search != version) return version_error("search", proof.search, version);
  Throws throws;
  for (const ProvenThrow& one : proof.throws) throws.push_back(one.aim);
  const Proof again = measured(level, throws, {.games = proof.games, .seed = proof.seed}, rollouts);
  for (std::size_t i = 0; i < proof_hands.size(); ++i)
    if (again.hands[i] != proof.hands[i]) return differs("/hands/" + std::to_string(i));
  if (again.random != proof.random) return differs("/random");
  if (again.stars != proof.stars) return differs("/stars");
  if (again != proof) return differs("/replay");
  return carom::Done{};
}

}  // namespace search
