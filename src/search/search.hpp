#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "carom/result.hpp"
#include "carom/rollouts.hpp"
#include "search/candidates.hpp"
#include "search/hand.hpp"
#include "search/seed.hpp"
#include "search/simulation.hpp"

/// Searches for a good shot by playing many (docs/search.md). The same question has the same answer
/// on every machine, for every number of threads and however the work is cut into slices.
namespace search {

/// The amount simulated: never a time, which would make answers depend on the machine.
struct Budget {
  std::uint64_t simulations = 1000;  ///< to find the shots; at least 1
  /// To tell what each shot found is worth, from seeds that chose nothing: what a search saw of the
  /// shot that it chose is too good, since luck helped to choose it. 0: no estimates.
  std::uint64_t fresh = 0;
  std::size_t shown = 1;  ///< shots in the answer, at most; at least 1
};

struct Question {
  Hand hand{};
  Budget budget{};
  Seed seed = 1;
};

struct Ranked {
  Shot shot{};
  /// Of Budget::fresh simulations, or of 1 if the hand is exact. Until they are played, of none.
  Record fresh{};
};

struct Answer {
  std::vector<Ranked> ranked{};   ///< the best first, no two alike
  std::uint64_t simulations = 0;  ///< played so far
};

/// A search under way. Billiards: it looks for the turn with the greatest expected points, the
/// place of a cue ball in hand included. Levels: for the throw with the most expected enemies out,
/// which count double if none is left. Among equals one that meets a ball is better: it never
/// passes.
class Search {
 public:
  /// Refuses a game whose player is not to shoot, throw or place, a budget without simulations, a
  /// hand that is no number in [0, 1000], and a table without a free place for the cue ball in
  /// hand.
  static carom::Result<Search> create(Game game, const Question& question);

  /// Plays at most so many simulations. To end a search early, call it no more.
  void advance(std::uint64_t simulations, carom::Rollouts& rollouts);
  bool done() const { return stage_ == Stage::done; }
  /// At any time; before anything is played it holds no shots.
  Answer answer() const;
  std::uint64_t simulated() const { return simulated_; }
  const Game& game() const { return *game_; }

 private:
  struct Candidate {
    Shot shot{};
    carom::Vec2 drag{};  ///< px
    Record record{};
  };
  enum class Stage : std::uint8_t { searching, fresh, done };

  Search(std::unique_ptr<const Game> game, const Question& question);
  void begin();
  void begin_round();
  void end_round();
  void choose();
  void add(const Shot& shot);
  void play(std::span<Trial> trials, carom::Rollouts& rollouts);
  double worth(const Record& record) const;
  bool better(std::size_t a, std::size_t b) const;

  std::unique_ptr<const Game> game_;  ///< its address is known to source_
  Question question_;
  Candidates source_;
  std::int64_t enemies_ = 0;  ///< in a level
  Stage stage_ = Stage::searching;
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> order_;  ///< of the candidates, the best first as far as they are played
  std::size_t round_ = 0;
  std::size_t rounds_ = 1;
  std::vector<std::size_t> members_;  ///< of this round: each is played `each_` times
  std::uint64_t each_ = 1;
  std::uint64_t sample_ = 0;    ///< the number of the first of them, for random_of()
  std::uint64_t next_job_ = 0;  ///< of members_.size() · each_, a member's one after the other
  std::uint64_t simulated_ = 0;
  std::vector<Ranked> ranked_;  ///< once chosen
  std::vector<Trial> trials_;
};

}  // namespace search
