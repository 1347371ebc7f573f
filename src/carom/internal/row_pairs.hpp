#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "carom/balls.hpp"
#include "carom/internal/pair.hpp"
#include "carom/vec2.hpp"

namespace carom {

/// Buffers that RowPairs keeps from step to step to save allocations.
struct RowPairsBuffers {
  std::vector<std::uint64_t> rows;  ///< a bit each
  std::vector<std::uint32_t> partners;
  std::vector<std::uint32_t> near;
  std::vector<std::uint32_t> found;
};

/// The broad phase by an index that knows what is near a place: the answers of AllPairs, found
/// without testing every pair exactly. An Index has these members; each may give more than it is
/// asked for, and a thing twice.
///
/// - build(balls): takes the balls as they are; their arrays must stay where they are.
/// - moved(i): ball i's position has changed.
/// - pairs(hit): calls hit(i, j) for the pairs that overlap, in one order or the other. Only after
///   build, before anything moved.
/// - near(x, y, own, factor, hit): calls hit(i) for the balls within own + factor·(their radius).
/// - any_near(x, y, own, a, b): whether near with factor 1 would find other balls than a and b.
/// - any_near_both(i, j, factor): whether a third may come within factor·(sum of radii) of i and j.
/// - box(low, high, factor, hit): for those that, factor times as large, reach into the box.
///
/// Row i is the pairs (i, j) with j > i. The index first marks the rows that may have a pair. They
/// are visited in ascending order, and within row i the partners j too, among the balls near i, all
/// tested exactly and as they are then: so what is found comes in lexicographic order.
///
/// Most rows have one pair, which the index has told, and no other ball is near: so first it is
/// asked whether there is any, which it knows quicker than which.
///
/// Nothing is missed when a collision moves balls: whether a pair overlaps can change only when one
/// of it moves, and each moved ball is looked up again before the next pair is chosen. Its pairs of
/// a later row have that row marked; its pairs of row i are among the balls near i, because what
/// moves in row i touches i (it is i, j or the third); earlier rows are over. A mark too many costs
/// time only.
///
/// In a heap, where balls overlap several others, a moved ball is looked up again and again only to
/// find rows that are marked already. There every row is marked at once, and none is looked up when
/// it moves.
template <class Index>
class RowPairs {
 public:
  /// To be made after the balls have moved.
  RowPairs(const Balls& balls, const std::vector<std::uint8_t>& gone, Index& index,
           RowPairsBuffers& buffers)
      : balls_(balls), gone_(gone), index_(index), b_(buffers) {
    index_.build(balls);
    b_.near.clear();
  }

  std::optional<Pair> next_overlap(Pair after) {
    if (row_ == none)
      mark_rows();
    else
      look_after_moved();
    if (looked_around_)
      if (const std::size_t partner = next_partner(after.second); partner != none)
        return Pair{row_, partner};
    while (next_marked_row()) {
      looked_around_ = false;
      std::size_t partner = b_.partners[row_];
      if (partner == several) {
        look_around_row();
        partner = next_partner(row_);
      } else if (gone_[row_] || gone_[partner] || !overlap(balls_, row_, partner)) {
        continue;
      }
      if (partner != none) return Pair{row_, partner};
    }
    pairs_over_ = true;
    return std::nullopt;
  }

  std::optional<std::size_t> touching_both(Pair pair) {
    if (!looked_around_) {
      if (!index_.any_near_both(static_cast<std::uint32_t>(pair.first),
                                static_cast<std::uint32_t>(pair.second), factor))
        return std::nullopt;
      look_around_row();
    }
    const std::size_t lowest = lowest_near([&](std::size_t k) {
      return (k != pair.second) && touch(balls_, k, pair.first) && touch(balls_, k, pair.second);
    });
    return lowest == none ? std::nullopt : std::optional(lowest);
  }

  void moved(std::size_t i) {
    if (pairs_over_) {
      index_.moved(i);
      return;
    }
    // Those of a collision, at most three.
    const auto m = static_cast<std::uint32_t>(i);
    for (std::size_t n = 0; n < moved_count_; ++n)
      if (moved_[n] == m) return;
    moved_[moved_count_++] = m;
  }

  // Support changes the upper ball only and reads nothing that another pair changes: so it is
  // enough that each ball as the upper one meets those below it by ascending index.
  template <class Visit>
  void for_each_touching(Visit visit) {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (gone_[i]) continue;
      b_.found.clear();
      index_.near(balls_.x[i], balls_.y[i], touching_factor * balls_.radius[i], factor,
                  [&](std::uint32_t k) { b_.found.push_back(k); });
      sort_unique(b_.found);
      for (const std::uint32_t k : b_.found) {
        const bool below = balls_.y[k] < balls_.y[i] || (balls_.y[k] == balls_.y[i] && k < i);
        if (below && !gone_[k] && touch(balls_, i, k)) visit(k < i ? Pair{k, i} : Pair{i, k});
      }
    }
  }

  template <class Visit>
  void for_each_in_box(Vec2 low, Vec2 high, Visit visit) {
    b_.found.clear();
    index_.box(low, high, box_factor, [&](std::uint32_t i) { b_.found.push_back(i); });
    sort_unique(b_.found);
    for (const std::uint32_t i : b_.found) visit(i);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  /// As the partner of a marked row: there may be more than one, or it may have changed.
  static constexpr std::uint32_t several = static_cast<std::uint32_t>(-1);
  // A hair more than the touching factor, since it is a float.
  static constexpr float factor = 1.0201F;

  static void sort_unique(std::vector<std::uint32_t>& indices) {
    if (indices.size() < 2) return;
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }

  static std::uint64_t bit(std::size_t row) { return std::uint64_t{1} << (row % 64); }

  void mark_rows() {
    b_.rows.assign(balls_.size() / 64 + 1, 0);
    b_.rows[balls_.size() / 64] = bit(balls_.size());  // where the search for the next one ends
    if (b_.partners.size() < balls_.size()) b_.partners.resize(balls_.size());
    std::size_t overlaps = 0;
    index_.pairs([&](std::uint32_t i, std::uint32_t j) {
      if (!overlap(balls_, i, j)) return;
      ++overlaps;
      const std::uint32_t row = std::min(i, j);
      const std::uint32_t partner = std::max(i, j);
      const bool another = (b_.rows[row / 64] & bit(row)) != 0 && b_.partners[row] != partner;
      b_.partners[row] = another ? several : partner;
      b_.rows[row / 64] |= bit(row);
    });
    // Half a pair a ball is what a dense gas has, where to look up what moves is quicker.
    heap_ = overlaps > balls_.size() - balls_.size() / 4;
    if (heap_) {
      std::fill(b_.rows.begin(), b_.rows.end(), ~std::uint64_t{0});
      std::fill_n(b_.partners.begin(), balls_.size(), several);
    }
  }

  bool next_marked_row() {
    const std::size_t from = row_ + 1;
    std::size_t word = from / 64;
    std::uint64_t rows = b_.rows[word] & (~std::uint64_t{0} << (from % 64));
    while (rows == 0) rows = b_.rows[++word];
    row_ = word * 64 + static_cast<std::size_t>(std::countr_zero(rows));
    return row_ < balls_.size();
  }

  std::size_t next_partner(std::size_t j) const {
    if (gone_[row_]) return none;
    return lowest_near([&](std::size_t k) { return k > j && overlap(balls_, row_, k); });
  }

  // The lowest ball in play of those near the row's that a test is true for.
  template <class Test>
  std::size_t lowest_near(Test test) const {
    std::size_t lowest = none;
    for (const std::size_t k : b_.near)
      if (k < lowest && gone_[k] == 0 && test(k)) lowest = k;
    return lowest;
  }

  // The balls that may touch the row's, now and as long as it has not moved further than `margin`.
  void look_around_row() {
    looked_around_ = true;
    seen_from_ = balls_.position(row_);
    margin_ = balls_.radius[row_] / (heap_ ? 2 : 4);  // in a heap it moves further
    b_.near.clear();
    index_.near(seen_from_.x, seen_from_.y, touching_factor * balls_.radius[row_] + margin_, factor,
                [&](std::uint32_t k) {
                  if (k != row_) b_.near.push_back(k);
                });
  }

  // Most collisions leave nothing overlapping behind: that is found out first, and before the index
  // is told of the new places, since what has just been written can not be read four at a time
  // without waiting for it.
  void look_after_moved() {
    const std::size_t count = std::exchange(moved_count_, 0);
    if (count == 0) return;
    std::array<bool, 3> crowded{!heap_, !heap_, !heap_};
    if (count == 2 && !heap_)
      for (std::size_t n = 0; n < 2; ++n) {
        const std::uint32_t m = moved_[n];
        crowded[n] =
            (m != row_ || !looked_around_) &&
            index_.any_near(balls_.x[m], balls_.y[m], balls_.radius[m], moved_[0], moved_[1]);
      }
    for (std::size_t n = 0; n < count; ++n) index_.moved(moved_[n]);
    for (std::size_t n = 0; n < count; ++n) {
      const std::uint32_t m = moved_[n];
      if (m == row_) {
        const bool far = looked_around_ ? length_squared(balls_.position(row_) - seen_from_) >
                                              margin_ * margin_ * 0.999
                                        : crowded[n];
        if (far) look_around_row();
      } else if (crowded[n]) {
        index_.near(balls_.x[m], balls_.y[m], balls_.radius[m], 1, [&](std::uint32_t k) {
          const std::uint32_t row = std::min(k, m);
          if (row <= row_ || k == m || !overlap(balls_, k, m)) return;
          b_.partners[row] = several;
          b_.rows[row / 64] |= bit(row);
        });
      }
    }
  }

  const Balls& balls_;
  const std::vector<std::uint8_t>& gone_;
  Index& index_;
  RowPairsBuffers& b_;
  std::size_t row_ = none;
  std::array<std::uint32_t, 3> moved_{};
  std::size_t moved_count_ = 0;
  bool pairs_over_ = false;
  bool heap_ = false;           ///< every row is marked
  bool looked_around_ = false;  ///< b_.near is what is near the row's ball
  Vec2 seen_from_{};
  double margin_ = 0;
};

}  // namespace carom
