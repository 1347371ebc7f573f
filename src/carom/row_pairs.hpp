#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "carom/balls.hpp"
#include "carom/index_list.hpp"
#include "carom/pair.hpp"
#include "carom/vec2.hpp"

namespace carom {

/// What RowPairs keeps from step to step to save allocations.
struct RowPairsBuffers {
  std::vector<std::uint8_t> rows;
  IndexList near;
  IndexList found;
  std::vector<std::uint32_t> moved;
};

/// The broad phase by an index that knows what is near a place: the answers of AllPairs, found
/// without testing every pair exactly. An Index has these members; each may give more than it is
/// asked for, and a thing twice.
///
/// - build(balls): takes the balls as they are; their arrays must stay where they are.
/// - moved(i): ball i's position has changed.
/// - pairs(hit): calls hit(i, j) for the pairs that overlap, in one order or the other. Only after
///   build, before anything moved.
/// - near(x, y, own, factor, found): appends the balls within own + factor·(their radius).
/// - box(low, high, factor, found): appends those that, factor times as large, reach into the box.
///
/// Row i is the pairs (i, j) with j > i. The index first marks the rows that may have a pair. They
/// are visited in ascending order, and within row i the partners j too, among the balls near i, all
/// tested exactly and as they are then: so what is found comes in lexicographic order.
///
/// Nothing is missed when a collision moves balls: whether a pair overlaps can change only when one
/// of it moves, and each moved ball is looked up again before the next pair is chosen. Its pairs of
/// a later row have that row marked; its pairs of row i are among the balls near i, because what
/// moves in row i touches i (it is i, j or the third); earlier rows are over. A mark too many costs
/// time only.
template <class Index>
class RowPairs {
 public:
  /// To be made after the balls have moved.
  RowPairs(const Balls& balls, const std::vector<std::uint8_t>& gone, Index& index,
           RowPairsBuffers& buffers)
      : balls_(balls), gone_(gone), index_(index), b_(buffers) {
    index_.build(balls);
    b_.moved.clear();
    b_.near.clear();
  }

  std::optional<Pair> next_overlap(Pair after) {
    if (row_ == none)
      mark_rows();
    else
      look_after_moved();
    std::size_t j = after.second;
    for (;;) {
      if (row_ != none && !gone_[row_])
        for (const std::uint32_t k : b_.near)
          if (k > j && !gone_[k] && overlap(balls_, row_, k)) return Pair{row_, k};
      if (!next_marked_row()) return std::nullopt;
      look_around_row();
      j = row_;
    }
  }

  std::optional<std::size_t> touching_both(Pair pair) const {
    for (const std::uint32_t k : b_.near) {
      if (k == pair.first || k == pair.second || gone_[k]) continue;
      if (touch(balls_, k, pair.first) && touch(balls_, k, pair.second)) return k;
    }
    return std::nullopt;
  }

  void moved(std::size_t i) {
    index_.moved(i);
    const auto m = static_cast<std::uint32_t>(i);
    if (std::find(b_.moved.begin(), b_.moved.end(), m) == b_.moved.end()) b_.moved.push_back(m);
  }

  // Support changes the upper ball only and reads nothing that another pair changes: so it is
  // enough that each ball as the upper one meets those below it by ascending index.
  template <class Visit>
  void for_each_touching(Visit visit) {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (gone_[i]) continue;
      b_.found.clear();
      index_.near(balls_.x[i], balls_.y[i], touching_factor * balls_.radius[i], factor, b_.found);
      b_.found.sort();
      for (const std::uint32_t k : b_.found) {
        const bool below = balls_.y[k] < balls_.y[i] || (balls_.y[k] == balls_.y[i] && k < i);
        if (below && !gone_[k] && touch(balls_, i, k)) visit(k < i ? Pair{k, i} : Pair{i, k});
      }
    }
  }

  template <class Visit>
  void for_each_in_box(Vec2 low, Vec2 high, Visit visit) {
    b_.found.clear();
    index_.box(low, high, box_factor, b_.found);
    b_.found.sort();
    for (const std::uint32_t i : b_.found) visit(i);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  // A hair more than the touching factor, since it is a float.
  static constexpr float factor = 1.0201F;

  void mark_rows() {
    b_.rows.assign(balls_.size() + 8, 0);
    b_.rows[balls_.size()] = 1;  // where the search for the next marked row ends
    index_.pairs([&](std::uint32_t i, std::uint32_t j) {
      if (overlap(balls_, i, j)) b_.rows[std::min(i, j)] = 1;
    });
  }

  bool next_marked_row() {
    for (++row_; b_.rows[row_] == 0; ++row_) {
      // Eight unmarked rows in one go.
      std::uint64_t eight = 0;
      for (std::memcpy(&eight, &b_.rows[row_], 8); eight == 0;
           std::memcpy(&eight, &b_.rows[row_], 8))
        row_ += 8;
      if (b_.rows[row_] != 0) break;
    }
    return row_ < balls_.size();
  }

  // The balls that may touch the row's, now and as long as it has not moved further than `margin`.
  void look_around_row() {
    seen_from_ = balls_.position(row_);
    margin_ = balls_.radius[row_] / 4;
    b_.near.clear();
    index_.near(seen_from_.x, seen_from_.y, touching_factor * balls_.radius[row_] + margin_, factor,
                b_.near);
    b_.near.sort();
  }

  void look_after_moved() {
    if (b_.moved.empty()) return;
    for (const std::uint32_t m : b_.moved) {
      if (m == row_) continue;
      b_.found.clear();
      index_.near(balls_.x[m], balls_.y[m], balls_.radius[m], 1, b_.found);
      for (const std::uint32_t k : b_.found) {
        const std::uint32_t row = std::min(k, m);
        if (row > row_ && k != m) b_.rows[row] = 1;
      }
    }
    b_.moved.clear();
    if (length_squared(balls_.position(row_) - seen_from_) > margin_ * margin_ * 0.999)
      look_around_row();
  }

  const Balls& balls_;
  const std::vector<std::uint8_t>& gone_;
  Index& index_;
  RowPairsBuffers& b_;
  std::size_t row_ = none;
  Vec2 seen_from_{};
  double margin_ = 0;
};

}  // namespace carom
