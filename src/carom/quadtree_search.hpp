#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "carom/balls.hpp"
#include "carom/index_list.hpp"
#include "carom/quadtree.hpp"
#include "carom/vectors.hpp"

namespace carom {

/// The inner loops of a Quadtree, inlined into what is done with the discs they find. They compare
/// positions rounded to floats, four at a time, with radii enlarged by more than the rounding: they
/// find all that is to be found and now and then a disc more, which is for the caller to test.
class QuadtreeSearch {
 public:
  explicit QuadtreeSearch(const Quadtree& tree) : tree_(tree) {}

  /// A position and a radius as the tree keeps them.
  struct Rounded {
    float x, y, radius;
  };

  static Rounded rounded(double x, double y, double radius) {
    const double size = std::abs(x) + std::abs(y);
    // Beyond this, squares of floats would overflow: such a disc is near all it is compared with.
    constexpr double far = 1e15;
    if (!(size < far)) return {0, 0, 1e30F};
    // Rounding a coordinate costs at most 2⁻²⁴ of it; the rest of the room is for the sums and
    // products made of it.
    const double enlarged = radius * (1 + 0x1p-20) + size * 0x1p-20;
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(enlarged)};
  }

  /// Appends the discs whose distance from (x, y) is at most own + factor·radius; the same disc may
  /// come more than once.
  void near(double x, double y, double own, float factor, IndexList& found) const {
    const Rounded disc = rounded(x, y, own);
    const Float4 x4 = splat(disc.x);
    const Float4 y4 = splat(disc.y);
    const Float4 own4 = splat(disc.radius);
    const Float4 factor4 = splat(factor);
    // Whatever is hit, the same is done: what comes next is known to the processor.
    const auto scan_four = [&](std::uint32_t slot, std::uint32_t end) {
      const Float4 dx = load4(&tree_.slot_x_[slot]) - x4;
      const Float4 dy = load4(&tree_.slot_y_[slot]) - y4;
      const Float4 reach = load4(&tree_.slot_radius_[slot]) * factor4 + own4;
      const Int4 miss =
          (dx * dx + dy * dy > reach * reach) | (slots4(slot) >= static_cast<std::int32_t>(end));
      found.append4(&tree_.slot_disc_[slot], miss);
    };
    const auto scan = [&](std::uint32_t begin, std::uint32_t end) {
      found.make_room(end - begin + 4);
      for (std::uint32_t slot = begin; slot < end; slot += 4) scan_four(slot, end);
    };
    for (const Quadtree::Level& level : tree_.levels_) {
      const double reach = own + double{factor} * level.largest + level.slack;
      if (reach < 0.999 * level.side) {
        // The 3 × 3 squares around, each row nearly always in one go.
        const std::uint32_t middle = Quadtree::cell(level, Quadtree::coordinate(x, level.per_side),
                                                    Quadtree::coordinate(y, level.per_side));
        const std::uint32_t* starts = &tree_.starts_[level.first_cell];
        const std::uint32_t low = middle - level.stride;
        const std::uint32_t high = middle + level.stride;
        if (low - 1 < middle && high + 1 <= level.mask) {
          found.make_room(12);
          for (const std::uint32_t square : {low, middle, high}) {
            const std::uint32_t begin = starts[square - 1];
            const std::uint32_t end = starts[square + 2];
            scan_four(begin, end);
            if (end > begin + 4) scan(begin + 4, end);
          }
          continue;
        }
      }
      squares(level, x - reach, x + reach, y - reach, y + reach, scan);
    }
    for (const std::uint32_t i : tree_.strays_) found.append(i);
  }

  /// Appends the discs that, `factor` times as large, reach into the box, and some more; the same
  /// disc may come more than once.
  void box(Vec2 low, Vec2 high, double factor, IndexList& found) const {
    const auto scan = [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t slot = begin; slot < end; ++slot) {
        const double x = double{tree_.slot_x_[slot]};
        const double y = double{tree_.slot_y_[slot]};
        const double r = factor * double{tree_.slot_radius_[slot]};
        if (x + r >= low.x && x - r <= high.x && y + r >= low.y && y - r <= high.y)
          found.append(tree_.slot_disc_[slot]);
      }
    };
    for (const Quadtree::Level& level : tree_.levels_) {
      const double reach = factor * level.largest + level.slack;
      squares(level, low.x - reach, high.x + reach, low.y - reach, high.y + reach, scan);
    }
    for (const std::uint32_t i : tree_.strays_) found.append(i);
  }

  /// Calls hit(i, j) at least once, in one order or the other, for each pair of discs that overlap,
  /// and perhaps for some that don't. Only after a build, before anything moved.
  template <class Hit>
  void pairs(Hit hit) const {
    for (std::size_t l = 0; l < tree_.levels_.size(); ++l) {
      const Quadtree::Level& level = tree_.levels_[l];
      const bool narrow = 2.01 * level.largest <= level.side;
      if (narrow)
        pairs_within(level, hit);
      else
        pairs_anyhow(level, level, hit);
      for (std::size_t coarser = 0; coarser < l; ++coarser)
        pairs_anyhow(level, tree_.levels_[coarser], hit);
    }
  }

 private:
  /// Calls scan(begin, end) with the slots of the squares that a box, a hair larger, covers.
  template <class Scan>
  void squares(const Quadtree::Level& level, double x0, double x1, double y0, double y1,
               Scan scan) const {
    constexpr double hair = 1e-6;  // of a square: more than rounding costs in coordinate()
    const double more = hair * level.side;
    const std::int64_t left = Quadtree::coordinate(x0 - more, level.per_side);
    const std::int64_t right = Quadtree::coordinate(x1 + more, level.per_side);
    const std::int64_t bottom = Quadtree::coordinate(y0 - more, level.per_side);
    const std::int64_t top = Quadtree::coordinate(y1 + more, level.per_side);
    const std::int64_t cells = std::int64_t{level.mask} + 1;
    if (right - left >= cells || top - bottom >= cells ||
        (right - left + 1) * (top - bottom + 1) >= cells) {
      scan(level.begin, level.end);
      return;
    }
    const std::uint32_t* starts = &tree_.starts_[level.first_cell];
    for (std::int64_t row = bottom; row <= top; ++row) {
      const std::uint32_t first = Quadtree::cell(level, left, row);
      const std::uint32_t last = Quadtree::cell(level, right, row);
      if (first <= last) {
        scan(starts[first], starts[last + 1]);
      } else {  // the run goes over the table's end
        scan(starts[first], level.end);
        scan(level.begin, starts[last + 1]);
      }
    }
  }

  /// The disc in slot p against those in slots [begin, end).
  template <class Hit>
  void overlaps(std::uint32_t p, std::uint32_t begin, std::uint32_t end, Hit& hit) const {
    const Float4 x4 = splat(tree_.slot_x_[p]);
    const Float4 y4 = splat(tree_.slot_y_[p]);
    const Float4 r4 = splat(tree_.slot_radius_[p]);
    for (std::uint32_t slot = begin; slot < end; slot += 4) {
      const Int4 miss = misses(slot, x4, y4, r4);
      if (!all(miss)) report(p, slot, end, miss, hit);
    }
  }

  Int4 misses(std::uint32_t slot, Float4 x4, Float4 y4, Float4 r4) const {
    const Float4 dx = load4(&tree_.slot_x_[slot]) - x4;
    const Float4 dy = load4(&tree_.slot_y_[slot]) - y4;
    const Float4 reach = load4(&tree_.slot_radius_[slot]) + r4;
    return dx * dx + dy * dy > reach * reach;
  }

  template <class Hit>
  void report(std::uint32_t p, std::uint32_t slot, std::uint32_t end, Int4 miss, Hit& hit) const {
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      const std::uint32_t q = slot + lane;
      if (!miss[lane] && q < end && q != p) hit(tree_.slot_disc_[p], tree_.slot_disc_[q]);
    }
  }

  // Half of the 3 × 3 squares around each: what is to the right in the disc's own square and in the
  // next, and the three above. The other half is seen from there.
  template <class Hit>
  void pairs_within(const Quadtree::Level& level, Hit& hit) const {
    const std::uint32_t* starts = &tree_.starts_[level.first_cell];
    for (std::uint32_t p = level.begin; p < level.end; ++p) {
      const std::uint32_t cell = tree_.slot_cell_[p];
      const std::uint32_t above = cell + level.stride;
      if (above + 1 > level.mask) {  // the runs go over the table's end
        pairs_at_the_end(level, p, hit);
        continue;
      }
      const std::uint32_t end = starts[cell + 2];
      const std::uint32_t begin_above = starts[above - 1];
      const std::uint32_t end_above = starts[above + 2];
      const Float4 x4 = splat(tree_.slot_x_[p]);
      const Float4 y4 = splat(tree_.slot_y_[p]);
      const Float4 r4 = splat(tree_.slot_radius_[p]);
      // Nearly always four lanes are enough for each run, and nearly always nothing is hit: one
      // branch for both.
      const Int4 beside = misses(p + 1, x4, y4, r4);
      const Int4 over = misses(begin_above, x4, y4, r4);
      if (!all(beside & over)) {
        report(p, p + 1, end, beside, hit);
        report(p, begin_above, end_above, over, hit);
      }
      if (end > p + 5) overlaps(p, p + 5, end, hit);
      if (end_above > begin_above + 4) overlaps(p, begin_above + 4, end_above, hit);
    }
  }

  template <class Hit>
  void pairs_at_the_end(const Quadtree::Level& level, std::uint32_t p, Hit& hit) const {
    const std::uint32_t* starts = &tree_.starts_[level.first_cell];
    const std::uint32_t cell = tree_.slot_cell_[p];
    overlaps(p, p + 1, starts[cell + 1], hit);
    for (const std::uint32_t other :
         {cell + 1, cell + level.stride - 1, cell + level.stride, cell + level.stride + 1})
      overlaps(p, starts[other & level.mask], starts[(other & level.mask) + 1], hit);
  }

  // Every disc of a level against those of another, or the same, that are near.
  template <class Hit>
  void pairs_anyhow(const Quadtree::Level& level, const Quadtree::Level& others, Hit& hit) const {
    for (std::uint32_t p = level.begin; p < level.end; ++p) {
      const std::uint32_t i = tree_.slot_disc_[p];
      const double x = tree_.x_[i];
      const double y = tree_.y_[i];
      const double reach = tree_.radius_[i] + others.largest;
      squares(others, x - reach, x + reach, y - reach, y + reach,
              [&](std::uint32_t begin, std::uint32_t end) { overlaps(p, begin, end, hit); });
    }
  }

  const Quadtree& tree_;
};

// The column, or row, of squares that a position is in. A number of this size has no room for
// fractions: the sum is rounded to the nearest whole number, half a square down, and stands in its
// lowest bits. A position at a boundary, to within rounding, may come to either side of it, and far
// away all squares are one; but a higher position never comes to a lower square, so a range of
// positions is in the range of their squares.
inline std::int64_t Quadtree::coordinate(double position, double per_side) {
  constexpr double whole = 0x1.8p52;
  constexpr double most = 0x1p50;
  const double scaled = std::min(std::max(-most, position * per_side), most);
  return std::bit_cast<std::int64_t>((scaled - 0.5) + whole) - std::bit_cast<std::int64_t>(whole);
}

inline std::uint32_t Quadtree::cell(const Level& level, std::int64_t column, std::int64_t row) {
  return (static_cast<std::uint32_t>(row) * level.stride + static_cast<std::uint32_t>(column)) &
         level.mask;
}

/// The quadtree as an index for RowPairs.
class QuadtreeIndex {
 public:
  void build(const Balls& balls) { tree_.build(balls.x, balls.y, balls.radius); }
  void moved(std::size_t i) { tree_.moved(i); }
  template <class Hit>
  void pairs(Hit hit) const {
    QuadtreeSearch(tree_).pairs(hit);
  }
  void near(double x, double y, double own, float factor, IndexList& found) const {
    QuadtreeSearch(tree_).near(x, y, own, factor, found);
  }
  void box(Vec2 low, Vec2 high, double factor, IndexList& found) const {
    QuadtreeSearch(tree_).box(low, high, factor, found);
  }

 private:
  Quadtree tree_;
};

}  // namespace carom
