#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "carom/result.hpp"
#include "carom/rollouts.hpp"
#include "games/angry_balls.hpp"
#include "replay/replay.hpp"
#include "search/level_games.hpp"
#include "search/seed.hpp"
#include "search/solver.hpp"

/// Proofs that a level can be won, with how hard that is (docs/search.md).
namespace search {

/// How much is played to measure a level.
struct ProofPlan {
  std::uint64_t simulations = 100'000;  ///< at most, to find winning throws
  std::uint64_t games = 200;            ///< of the player with each hand
  Seed seed = 1;
};

inline constexpr std::array<double, 5> proof_hands{0, 1, 2, 4, 8};  ///< px
inline constexpr std::size_t star_hand = 2;                         ///< in proof_hands, 2 px
inline constexpr std::size_t reference_hand = 3;                    ///< reference_player's
inline constexpr std::uint64_t random_games = 5;                    ///< for each game with a hand

/// Goals for players beyond winning, from the games of the hand of 2 px.
struct Stars {
  int par = 1;            ///< the fewest throws in which it wins half its games; else all there are
  std::int64_t gold = 0;  ///< the score that a tenth of its won games reach; else the proof's
  friend bool operator==(const Stars&, const Stars&) = default;
};

struct ProvenThrow {
  Aim aim{};
  Margin margin = 0;
  friend bool operator==(const ProvenThrow&, const ProvenThrow&) = default;
};

struct Proof {
  std::string level{};  ///< its identity
  int physics = 0;      ///< versions
  int rules = 0;
  int search = 0;
  Seed seed = 1;
  std::uint64_t games = 0;
  std::string replay{};  ///< a game that is won, as text
  std::vector<ProvenThrow> throws{};
  std::array<LevelGames, proof_hands.size()> hands{};  ///< without scores
  LevelGames random{};                                 ///< the random player's; without scores
  Stars stars{};

  /// 1 − the reference player's pass rate.
  Estimate difficulty() const;
  friend bool operator==(const Proof&, const Proof&) = default;
};

/// A proof of `level`, a game at its start. Refuses, with the number of simulations, a level that
/// it finds no way to win.
carom::Result<Proof> prove(const games::angry_balls::Game& level, const ProofPlan& plan,
                           carom::Rollouts& rollouts);

/// Says that a search found no way to win, which does not say that there is none.
carom::Errors not_found(const Solved& solved);

/// What a proof of this `level` must say of these throws and for this plan.
Proof measured(const games::angry_balls::Game& level, const Throws& throws, const ProofPlan& plan,
               carom::Rollouts& rollouts);

/// Refuses a proof of another level, physics or rules, one whose replay is not a game of that level
/// that is won by typed throws, and margins that are not those of its throws.
carom::Status check_proof(const games::angry_balls::Game& level, const Proof& proof,
                          carom::Rollouts& rollouts);

/// Plays all that a proof states and refuses what is not so, and one of another search.
carom::Status verify_proof(const games::angry_balls::Game& level, const Proof& proof,
                           carom::Rollouts& rollouts);

}  // namespace search
