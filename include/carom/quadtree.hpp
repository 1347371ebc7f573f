#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/public.hpp"
#include "carom/vec2.hpp"

namespace CAROM_PUBLIC carom {

/// Two indices, first < second; compared first by `first`, then by `second`: the order in which
/// pairs collide (docs/physics.md#one-step).
struct Pair {
  std::size_t first = 0;
  std::size_t second = 0;

  friend constexpr bool operator==(const Pair&, const Pair&) = default;
  friend constexpr bool operator<(const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

class ThreadPool;

/// A loose quadtree without pointers, for discs of any size anywhere in the plane (§1.3).
///
/// The plane is divided into squares, each of which is divided into four, and so on; all squares of
/// one size make a level. A disc lives in the one square that holds its centre, on the level whose
/// squares are just wide enough (1.3 to 2.6 diameters): what it overlaps on its own level then lies
/// in the 3 × 3 squares around, and each coarser level needs no more. Levels without discs do not
/// exist.
///
/// A level is a table of squares, row by row, and the discs sorted by their square: three squares
/// beside each other are one run of memory. The table has about as many squares as discs; the plane
/// is folded onto it, so that it needs no bounds and a disc far away costs no more than another.
///
/// With n discs: build O(n), a query O(squares of each level it covers + discs in them), the
/// overlapping pairs O(n + p log p) for p pairs, as long as no square is crowded, that is, as long
/// as the discs of about one size do not lie upon each other in heaps. Memory: about 40 bytes a
/// disc. Once it has been built with as many discs before, a build allocates nothing.
class Quadtree {
 public:
  /// Takes the discs, which are named by their index in these three arrays of equal length, at most
  /// 2³¹ of them. Centres (px) may be anywhere, radii (px) must be from min_size to
  /// max_quantity (scene.hpp). The tree goes on
  /// reading the arrays: they must stay where they are as long as it is asked.
  void build(std::span<const double> x, std::span<const double> y, std::span<const double> radius);

  /// To be told when disc i's centre was changed in the arrays: it is found at its new place from
  /// now on. O(1); after many long moves a whole build().
  void moved(std::size_t i);

  /// Discs that overlap the one given: squared distance of the centres < squared sum of the radii.
  /// Replaces what `found` holds by their indices, ascending.
  void query_disc(Vec2 centre, double radius, std::vector<std::uint32_t>& found) const;

  /// Discs that reach into the box from `low` to `high` (px), its boundary included. Replaces what
  /// `found` holds by their indices, ascending. Infinities are welcome.
  void query_box(Vec2 low, Vec2 high, std::vector<std::uint32_t>& found) const;

  /// All pairs with |oj − oi|² < (ri + rj)². Replaces what `pairs` holds, in ascending order.
  void overlapping_pairs(std::vector<Pair>& pairs) const;

  std::size_t size() const { return x_.size(); }

  /// A square that holds at least one disc's centre; for pictures.
  struct Square {
    Vec2 low;     ///< px, its lower left corner
    double side;  ///< px
    int level;    ///< 0: the coarsest; those of the next have half the side
    friend bool operator==(const Square&, const Square&) = default;
  };
  /// Each once, by level, then row by row from below. O(n log n). A centre on a boundary may count
  /// to either side; those beyond 2⁴⁰ sides from the origin are shown there.
  std::vector<Square> squares() const;

 private:
  friend class QuadtreeIndex;
  friend class QuadtreeSearch;
  static constexpr std::size_t max_depths = 42;  ///< of levels, each with half the side

  struct Level {
    int depth = 0;                 ///< 0: the coarsest that could be
    double side = 0;               ///< px, of a square
    double per_side = 0;           ///< 1/px
    std::uint32_t first_cell = 0;  ///< the level's table in starts_
    std::uint32_t mask = 0;        ///< squares in the table − 1; they are a power of two
    std::uint32_t stride = 0;      ///< from a square to the one above it
    std::uint32_t begin = 0;       ///< its discs' slots
    std::uint32_t end = 0;
    double largest = 0;  ///< px, the largest radius on it
    double slack = 0;    ///< px, no disc is further outside its square than this
  };

  void shape();
  void sort_into_squares();
  void squares_of_two(const Level& level, std::size_t begin, std::size_t end);
  template <class LevelOf>
  void place_discs(LevelOf level_of);
  void set_slot(std::uint32_t slot, std::size_t i);
  std::size_t depth_of(double radius) const;
  /// A square's column and row on its level; 0, 0 has the origin at its lower left.
  struct Place {
    std::int64_t column;
    std::int64_t row;
  };
  static Place place(const Level& level, double x, double y);
  static std::uint32_t cell(const Level& level, Place place);

  ThreadPool* thread_pool_ = nullptr;  ///< helps to build, if there is one
  std::span<const double> x_;
  std::span<const double> y_;
  std::span<const double> radius_;

  std::vector<Level> levels_;   ///< coarsest first
  int builds_until_shape_ = 0;  ///< the levels' form is kept for some builds
  std::size_t shaped_size_ = 0;
  double largest_ = 0;  ///< px, the largest radius when they were formed
  std::array<std::uint8_t, max_depths> level_at_depth_{};

  // By disc.
  std::vector<std::uint8_t> level_;  ///< only with several levels
  std::vector<std::uint32_t> cell_;  ///< its square's index in starts_
  std::vector<std::uint32_t> slot_;
  // By slot: discs sorted by level and square.
  std::vector<float> slot_x_;
  std::vector<float> slot_y_;
  std::vector<float> slot_radius_;
  std::vector<std::uint32_t> slot_disc_;
  std::vector<std::uint32_t> slot_cell_;
  /// By square of all levels: its first slot; one more at the end.
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> strays_;  ///< discs that are found by looking at each of them
};

}  // namespace carom
