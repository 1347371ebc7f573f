#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "carom/pair.hpp"

namespace carom {

/// The reference broad phase: tests every pair. Another one must have these members and give the
/// same answers, which depend on nothing but the balls as they are at the time of the call:
///
/// - next_overlap, next_touching: the first pair after `after`, in lexicographic order, of balls in
///   play that overlap or touch now. Start from Pair{}.
/// - touching_both: the lowest index in play, other than the pair's, that touches both of it.
/// - moved: told after each change of a ball's position in the pair stage.
class AllPairs {
 public:
  /// `gone[i]` not zero: ball i is out of play. Both must outlive this and keep their size.
  AllPairs(std::span<const Ball> balls, std::span<const std::uint8_t> gone)
      : balls_(balls), gone_(gone) {}

  std::optional<Pair> next_overlap(Pair after) const { return next(after, overlap); }
  std::optional<Pair> next_touching(Pair after) const { return next(after, touch); }

  std::optional<std::size_t> touching_both(Pair pair) const {
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      if (k == pair.first || k == pair.second || gone_[k]) continue;
      if (touch(balls_[k], balls_[pair.first]) && touch(balls_[k], balls_[pair.second])) return k;
    }
    return std::nullopt;
  }

  void moved(std::size_t) {}

 private:
  template <class Test>
  std::optional<Pair> next(Pair after, Test test) const {
    std::size_t j = after.second + 1;
    for (std::size_t i = after.first; i < balls_.size(); ++i, j = i + 1) {
      if (gone_[i]) continue;
      for (; j < balls_.size(); ++j)
        if (!gone_[j] && test(balls_[i], balls_[j])) return Pair{i, j};
    }
    return std::nullopt;
  }

  std::span<const Ball> balls_;
  std::span<const std::uint8_t> gone_;
};

}  // namespace carom
