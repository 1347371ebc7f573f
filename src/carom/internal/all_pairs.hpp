#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "carom/balls.hpp"
#include "carom/internal/pair.hpp"
#include "carom/vec2.hpp"

namespace carom {

/// The reference broad phase: tests every pair. Another one must have these members and give the
/// same answers, which depend on nothing but the balls as they are at the time of the call:
///
/// - next_overlap: the first pair after `after`, in lexicographic order, of balls in play that
///   overlap now. Start from Pair{}; go on from the pair it gave last.
/// - touching_both: the lowest index in play, other than the pair's, that touches both of it. Asked
///   for the pair that next_overlap just gave.
/// - moved: told after each change of a ball's position.
/// - for_each_touching: calls visit(pair) for all pairs of balls in play that touch now. For each
///   ball the pairs that it is the upper one of come in lexicographic order; what order there is
///   between those of different balls is left open.
/// - for_each_in_box: calls visit(i) for at least all balls that, enlarged by box_factor, reach
/// into
///   the box, by ascending index; visit may move ball i.
class AllPairs {
 public:
  /// `gone[i]` not zero: ball i is out of play. Both must outlive this and keep their size.
  AllPairs(const Balls& balls, const std::vector<std::uint8_t>& gone)
      : balls_(balls), gone_(gone) {}

  std::optional<Pair> next_overlap(Pair after) const {
    return next(after, [](auto&... balls) { return overlap(balls...); });
  }

  std::optional<std::size_t> touching_both(Pair pair) const {
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      if (k == pair.first || k == pair.second || gone_[k]) continue;
      if (touch(balls_, k, pair.first) && touch(balls_, k, pair.second)) return k;
    }
    return std::nullopt;
  }

  void moved(std::size_t) {}

  template <class Visit>
  void for_each_touching(Visit visit) const {
    const auto test = [](auto&... balls) { return touch(balls...); };
    for (auto pair = next(Pair{}, test); pair; pair = next(*pair, test)) visit(*pair);
  }

  template <class Visit>
  void for_each_in_box(Vec2, Vec2, Visit visit) const {
    for (std::size_t i = 0; i < balls_.size(); ++i) visit(i);
  }

 private:
  // `test` is a lambda: not every level of optimisation inlines through a pointer to a function.
  template <class Test>
  std::optional<Pair> next(Pair after, Test test) const {
    std::size_t j = after.second + 1;
    for (std::size_t i = after.first; i < balls_.size(); ++i, j = i + 1) {
      if (gone_[i]) continue;
      for (; j < balls_.size(); ++j)
        if (!gone_[j] && test(balls_, i, j)) return Pair{i, j};
    }
    return std::nullopt;
  }

  const Balls& balls_;
  const std::vector<std::uint8_t>& gone_;
};

}  // namespace carom
