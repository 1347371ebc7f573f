#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "carom/balls.hpp"
#include "carom/internal/thread_pool.hpp"
#include "carom/internal/vectors.hpp"
#include "carom/quadtree.hpp"

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

  [[gnu::always_inline]] static Rounded rounded(double x, double y, double radius) {
    const double size = std::abs(x) + std::abs(y);
    // Beyond this, squares of floats would overflow: such a disc is near all it is compared with.
    constexpr double far = 1e15;
    if (!(size < far)) return {0, 0, std::numeric_limits<float>::infinity()};
    // Rounding a coordinate costs at most 2⁻²⁴ of it; the rest of the room is for the sums and
    // products made of it.
    const double enlarged = radius * (1 + 0x1p-20) + size * 0x1p-20;
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(enlarged)};
  }

  /// The same for two at a time.
  [[gnu::always_inline]] static std::array<Rounded, 2> rounded2(Double2 x, Double2 y,
                                                                Double2 radius) {
    const Double2 size = absolute2(x) + absolute2(y);
    constexpr double far = 1e15;
    if (!(size[0] < far && size[1] < far))
      return {rounded(x[0], y[0], radius[0]), rounded(x[1], y[1], radius[1])};
    const Double2 enlarged = radius * (1 + 0x1p-20) + size * 0x1p-20;
    using Float2 = float __attribute__((vector_size(8)));
    const auto fx = __builtin_convertvector(x, Float2);
    const auto fy = __builtin_convertvector(y, Float2);
    const auto fr = __builtin_convertvector(enlarged, Float2);
    return {Rounded{fx[0], fy[0], fr[0]}, Rounded{fx[1], fy[1], fr[1]}};
  }

  /// Calls hit(i) for the discs i whose distance from (x, y) is at most own + factor·radius; for
  /// the same disc perhaps more than once.
  template <class Hit>
  void near(double x, double y, double own, float factor, Hit hit) const {
    const Disc disc(rounded(x, y, own), factor);
    const Slots slots(tree_);
    const auto scan = [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t slot = begin; slot < end; slot += 4)
        for_each_bit(hits(slots, disc, slot),
                     [&](std::uint32_t lane) { hit(slots.disc[slot + lane]); });
    };
    Runs runs;
    if (nine_squares(x, y, own, factor, runs)) {
      for (std::size_t row = 0; row < 3; ++row) scan(runs.begin[row], runs.end[row]);
      return;
    }
    for (const Quadtree::Level& level : tree_.levels_) {
      const double reach = own + double{factor} * level.largest + level.slack;
      squares(level, x - reach, x + reach, y - reach, y + reach, scan);
    }
    for (const std::uint32_t i : tree_.strays_) hit(i);
  }

  /// True if near() with factor 1 would call hit with other discs than a and b.
  bool any_near(double x, double y, double own, std::uint32_t a, std::uint32_t b) const {
    Runs runs;
    if (nine_squares(x, y, own, 1, runs)) {
      const Disc disc(rounded(x, y, own), 1);
      const Slots slots(tree_);
      const Int4 a4 = splat(a);
      const Int4 b4 = splat(b);
      const auto misses = [&](std::uint32_t slot) __attribute__((always_inline)) {
        const Int4 discs = load4(slots.disc + slot);
        return QuadtreeSearch::misses(slots, disc, slot) | (discs == a4) | (discs == b4);
      };
      return !all_miss(runs, misses);
    }
    bool any = false;
    near(x, y, own, 1, [&](std::uint32_t i) { any |= i != a && i != b; });
    return any;
  }

  /// True if a third disc may touch both i and j: come, both times, within `factor`·(sum of radii).
  bool any_near_both(std::uint32_t i, std::uint32_t j, float factor) const {
    const double x = tree_.x_[i];
    const double y = tree_.y_[i];
    const double own = tree_.radius_[i] * double{factor};
    const Disc disc_j(rounded(tree_.x_[j], tree_.y_[j], tree_.radius_[j] * double{factor}), factor);
    Runs runs;
    if (nine_squares(x, y, own, factor, runs)) {
      const Disc disc_i(rounded(x, y, own), factor);
      const Slots slots(tree_);
      const Int4 i4 = splat(i);
      const Int4 j4 = splat(j);
      const auto misses = [&](std::uint32_t slot) __attribute__((always_inline)) {
        const Int4 discs = load4(slots.disc + slot);
        return QuadtreeSearch::misses(slots, disc_i, slot) |
               QuadtreeSearch::misses(slots, disc_j, slot) | (discs == i4) | (discs == j4);
      };
      return !all_miss(runs, misses);
    }
    bool any = false;
    near(x, y, own, factor, [&](std::uint32_t k) { any |= k != i && k != j; });
    return any;
  }

  /// Calls hit(i) for the discs that, `factor` times as large, reach into the box, and some more;
  /// for the same disc perhaps more than once.
  template <class Hit>
  void box(Vec2 low, Vec2 high, double factor, Hit hit) const {
    const auto scan = [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t slot = begin; slot < end; ++slot) {
        const auto x = double{tree_.slot_x_[slot]};
        const auto y = double{tree_.slot_y_[slot]};
        const double r = factor * double{tree_.slot_radius_[slot]};
        if (x + r >= low.x && x - r <= high.x && y + r >= low.y && y - r <= high.y)
          hit(tree_.slot_disc_[slot]);
      }
    };
    for (const Quadtree::Level& level : tree_.levels_) {
      const double reach = factor * level.largest + level.slack;
      squares(level, low.x - reach, high.x + reach, low.y - reach, high.y + reach, scan);
    }
    for (const std::uint32_t i : tree_.strays_) hit(i);
  }

  /// Calls hit(i, j) at least once, in one order or the other, for each pair of discs that overlap,
  /// and perhaps for some that don't. Only after a build, before anything moved.
  template <class Hit>
  void pairs(Hit hit) const {
    pairs(0, static_cast<std::uint32_t>(tree_.size()), hit);
  }

  /// The same for the pairs that are seen from the discs in slots [begin, end).
  template <class Hit>
  void pairs(std::uint32_t begin, std::uint32_t end, Hit& hit) const {
    for (std::size_t l = 0; l < tree_.levels_.size(); ++l) {
      const Quadtree::Level& level = tree_.levels_[l];
      const std::uint32_t from = std::max(begin, level.begin);
      const std::uint32_t to = std::min(end, level.end);
      if (2.01 * level.largest <= level.side)
        pairs_within(level, from, to, hit);
      else
        pairs_anyhow(from, to, level, hit);
      for (std::size_t coarser = 0; coarser < l; ++coarser)
        pairs_anyhow(from, to, tree_.levels_[coarser], hit);
    }
  }

 private:
  /// Calls scan(begin, end) with the slots of the squares that a box, a hair larger, covers.
  template <class Scan>
  void squares(const Quadtree::Level& level, double x0, double x1, double y0, double y1,
               Scan scan) const {
    constexpr double hair = 1e-3;  // of a square: more than rounding costs in coordinate()
    const double more = hair * level.side;
    const auto [left, bottom] = Quadtree::place(level, x0 - more, y0 - more);
    const auto [right, top] = Quadtree::place(level, x1 + more, y1 + more);
    const std::int64_t cells = std::int64_t{level.mask} + 1;
    const std::int64_t width = right - left;
    const std::int64_t height = top - bottom;
    if (width >= cells || height >= cells || (width + 1) * (height + 1) >= cells) {
      scan(level.begin, level.end);
      return;
    }
    const std::uint32_t* const starts = tree_.starts_.data() + level.first_cell;
    const std::uint32_t stride = level.stride;
    std::uint32_t first = Quadtree::cell(level, {left, bottom});
    const auto w = static_cast<std::uint32_t>(width);
    if (first + height * stride + width <= level.mask) {
      for (std::int64_t row = 0; row <= height; ++row, first += stride)
        scan(starts[first], starts[first + w + 1]);
      return;
    }
    for (std::int64_t row = 0; row <= height; ++row, first = (first + stride) & level.mask) {
      const std::uint32_t last = (first + w) & level.mask;
      if (first <= last) {
        scan(starts[first], starts[last + 1]);
      } else {  // the run goes over the table's end
        scan(starts[first], level.end);
        scan(level.begin, starts[last + 1]);
      }
    }
  }

  /// The disc that four slots at a time are compared with.
  struct Disc {
    [[gnu::always_inline]] Disc(Rounded disc, float by)
        : x(splat(disc.x)), y(splat(disc.y)), radius(splat(disc.radius)), factor(splat(by)) {}
    Float4 x, y, radius, factor;
  };

  /// Where the slots are, for loops to keep in registers.
  struct Slots {
    [[gnu::always_inline]] explicit Slots(const Quadtree& tree)
        : x(tree.slot_x_.data()),
          y(tree.slot_y_.data()),
          radius(tree.slot_radius_.data()),
          disc(tree.slot_disc_.data()) {}
    const float* x;
    const float* y;
    const float* radius;
    const std::uint32_t* disc;
  };

  [[gnu::always_inline]] static Int4 misses(const Slots& slots, const Disc& disc,
                                            std::uint32_t slot) {
    const Float4 dx = load4(slots.x + slot) - disc.x;
    const Float4 dy = load4(slots.y + slot) - disc.y;
    const Float4 reach = load4(slots.radius + slot) * disc.factor + disc.radius;
    return dx * dx + dy * dy > reach * reach;
  }

  /// As bits. The lanes behind the end of a run hold discs too, or nothing: they do no harm.
  [[gnu::always_inline]] static unsigned hits(const Slots& slots, const Disc& disc,
                                              std::uint32_t slot) {
    return ~bits(misses(slots, disc, slot)) & 0xfU;
  }

  struct Runs {
    std::array<std::uint32_t, 3> begin;
    std::array<std::uint32_t, 3> end;
  };

  /// The three runs of slots of the 3 × 3 squares around a position, if these hold all that may
  /// come within own + factor·(its radius): with discs of about one size that is so nearly always.
  [[gnu::always_inline]] bool nine_squares(double x, double y, double own, float factor,
                                           Runs& runs) const {
    if (tree_.levels_.size() != 1 || !tree_.strays_.empty()) return false;
    const Quadtree::Level& level = tree_.levels_[0];
    const double reach = own + double{factor} * level.largest + level.slack;
    if (!(reach < 0.999 * level.side)) return false;
    const std::uint32_t middle = Quadtree::cell(level, Quadtree::place(level, x, y));
    const std::uint32_t low = middle - level.stride;
    const std::uint32_t high = middle + level.stride;
    if (low - 1 >= middle || high + 1 > level.mask) return false;
    const std::uint32_t* const starts = tree_.starts_.data();
    runs = {{starts[low - 1], starts[middle - 1], starts[high - 1]},
            {starts[low + 2], starts[middle + 2], starts[high + 2]}};
    return true;
  }

  /// True if misses(slot) is true in all lanes, for all slots of the runs. One branch for all: few
  /// runs have more than four discs, and what the lanes behind a run's end tell does no harm.
  template <class Misses>
  [[gnu::always_inline]] static bool all_miss(const Runs& runs, Misses misses) {
    Int4 miss = misses(runs.begin[0]) & misses(runs.begin[1]) & misses(runs.begin[2]);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::uint32_t slot = runs.begin[row] + 4; slot < runs.end[row]; slot += 4)
        miss &= misses(slot);
    return all(miss);
  }

  /// The disc in slot p against those in slots [begin, end), and perhaps some behind.
  template <class Hit>
  void overlaps(std::uint32_t p, std::uint32_t begin, std::uint32_t end, Hit& hit) const {
    const Slots slots(tree_);
    const Disc disc({slots.x[p], slots.y[p], slots.radius[p]}, 1);
    for (std::uint32_t slot = begin; slot < end; slot += 4)
      for_each_bit(hits(slots, disc, slot),
                   [&](std::uint32_t lane) { report(slots, p, slot + lane, hit); });
  }

  template <class Hit>
  [[gnu::always_inline]] void report(const Slots& slots, std::uint32_t p, std::uint32_t q,
                                     Hit& hit) const {
    if (q != p && q < tree_.size()) hit(slots.disc[p], slots.disc[q]);
  }

  // Half of the 3 × 3 squares around each: what is to the right in the disc's own square and in the
  // next, and the three above. The other half is seen from there.
  template <class Hit>
  void pairs_within(const Quadtree::Level& level, std::uint32_t from, std::uint32_t to,
                    Hit& hit) const {
    const std::uint32_t* const starts = tree_.starts_.data() + level.first_cell;
    const std::uint32_t* const slot_cell = tree_.slot_cell_.data();
    const Slots slots(tree_);
    const std::uint32_t stride = level.stride;
    const std::uint32_t last_whole = level.mask - std::min(level.mask, stride + 1);
    for (std::uint32_t p = from; p < to; ++p) {
      const std::uint32_t cell = slot_cell[p];
      if (cell > last_whole || stride >= level.mask) {  // the runs go over the table's end
        pairs_at_the_end(level, p, hit);
        continue;
      }
      const std::uint32_t end = starts[cell + 2];
      const std::uint32_t begin_above = starts[cell + stride - 1];
      const std::uint32_t end_above = starts[cell + stride + 2];
      const Disc disc({slots.x[p], slots.y[p], slots.radius[p]}, 1);
      // Nearly always four lanes are enough for each run, and nearly always nothing is hit: one
      // branch for both.
      const Int4 beside = misses(slots, disc, p + 1);
      const Int4 above = misses(slots, disc, begin_above);
      if (!all(beside & above)) {
        for_each_bit((~bits(beside) & 0xfU) | (~bits(above) & 0xfU) << 4, [&](std::uint32_t bit) {
          report(slots, p, (bit < 4 ? p + 1 : begin_above) + bit % 4, hit);
        });
      }
      if ((end > p + 5) | (end_above > begin_above + 4)) {
        overlaps(p, p + 5, end, hit);
        overlaps(p, begin_above + 4, end_above, hit);
      }
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

  // The discs in some slots against those of a level, perhaps their own, that are near.
  template <class Hit>
  void pairs_anyhow(std::uint32_t from, std::uint32_t to, const Quadtree::Level& others,
                    Hit& hit) const {
    for (std::uint32_t p = from; p < to; ++p) {
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

/// The columns, or rows, of two positions, with a constant added that is a multiple of 2³².
///
/// A number of the size of `no_fractions` has no room for fractions: the sum is rounded to the
/// nearest whole number, half a square down, and stands in its lowest bits. A position at a
/// boundary, to within rounding, may come to either side of it, and beyond 2⁴⁰ squares all are one,
/// so that rounding never costs more than 2⁻¹² of a square; a higher position never comes to a
/// lower square, so a range of positions is in the range of their squares.
inline constexpr double no_fractions = 0x1.8p52;
[[gnu::always_inline]] inline Long2 coordinates(Double2 positions, double per_side) {
  const Double2 most{0x1p40, 0x1p40};
  const Double2 scaled = max2(min2(positions * per_side, most), -most);
  return std::bit_cast<Long2>((scaled - 0.5) + no_fractions);
}

[[gnu::always_inline]] inline Quadtree::Place Quadtree::place(const Level& level, double x,
                                                              double y) {
  const Long2 both = coordinates(Double2{x, y}, level.per_side);
  constexpr auto zero = std::bit_cast<std::int64_t>(no_fractions);
  return {both[0] - zero, both[1] - zero};
}

[[gnu::always_inline]] inline std::uint32_t Quadtree::cell(const Level& level, Place place) {
  return (static_cast<std::uint32_t>(place.row) * level.stride +
          static_cast<std::uint32_t>(place.column)) &
         level.mask;
}

/// The quadtree as an index for RowPairs.
class QuadtreeIndex {
 public:
  void build(const Balls& balls) { tree_.build(balls.x, balls.y, balls.radius); }
  void moved(std::size_t i) { tree_.moved(i); }
  /// Threads that help, or none; must outlive this or be taken away.
  void set_thread_pool(ThreadPool* thread_pool) { tree_.thread_pool_ = thread_pool; }

  template <class Hit>
  void pairs(Hit hit) {
    const QuadtreeSearch search(tree_);
    if (tree_.thread_pool_ == nullptr) {
      search.pairs(hit);
      return;
    }
    // Each thread collects what it finds; which pairs there are does not depend on who found them,
    // nor does what the caller makes of them depend on their order.
    found_.resize(tree_.thread_pool_->size());
    tree_.thread_pool_->share(
        tree_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
          auto& found = found_[part];
          found.clear();
          auto collect = [&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); };
          search.pairs(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), collect);
        });
    for (const auto& found : found_)
      for (const auto& [i, j] : found) hit(i, j);
  }
  template <class Hit>
  void near(double x, double y, double own, float factor, Hit hit) const {
    QuadtreeSearch(tree_).near(x, y, own, factor, hit);
  }
  bool any_near(double x, double y, double own, std::uint32_t a, std::uint32_t b) const {
    return QuadtreeSearch(tree_).any_near(x, y, own, a, b);
  }
  bool any_near_both(std::uint32_t i, std::uint32_t j, float factor) const {
    return QuadtreeSearch(tree_).any_near_both(i, j, factor);
  }
  template <class Hit>
  void box(Vec2 low, Vec2 high, double factor, Hit hit) const {
    QuadtreeSearch(tree_).box(low, high, factor, hit);
  }

 private:
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found_;  ///< by thread
  Quadtree tree_;
};

}  // namespace carom
