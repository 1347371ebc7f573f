#include "carom/quadtree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <tuple>

#include "carom/arithmetic.hpp"
#include "carom/internal/quadtree_search.hpp"
#include "carom/internal/thread_pool.hpp"

namespace carom {

namespace {

// A square's side over the largest diameter that its level takes. Wider squares are fewer, and hold
// more discs that are in vain compared with each other (docs/performance.md).
constexpr double side_per_diameter = 1.3;
// The levels' form fits a state of the world that changes slowly.
constexpr int builds_per_shape = 64;
// Discs that moved further than a square from theirs: looked at one by one, so not too many.
constexpr std::size_t max_strays = 64;
constexpr std::size_t padding = 8;  // slots behind the last that may be read

template <class Item>
void sort_unique(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

double largest_of(std::span<const double> numbers) {
  Double2 most{0, 0};
  std::size_t i = 0;
  for (; i + 2 <= numbers.size(); i += 2) most = max2(most, load<Double2>(&numbers[i]));
  double largest = std::max(most[0], most[1]);
  for (; i < numbers.size(); ++i) largest = std::max(largest, numbers[i]);
  return largest;
}

}  // namespace

void Quadtree::build(std::span<const double> x, std::span<const double> y,
                     std::span<const double> radius) {
  const ExactArithmetic exact;
  x_ = x;
  y_ = y;
  radius_ = radius;
  strays_.clear();
  if (slot_x_.size() < size() + padding) {
    slot_x_.resize(size() + padding);
    slot_y_.resize(size() + padding);
    slot_radius_.resize(size() + padding);
    slot_disc_.resize(size() + padding);
    slot_cell_.resize(size() + padding);
    slot_.resize(size());
    cell_.resize(size());
    // As much as other discs could need: a table has less than four squares a disc, or 16.
    level_.reserve(size());
    levels_.reserve(max_depths);
    starts_.reserve(4 * size() + 16 * max_depths + 2);
    strays_.reserve(max_strays);
  }
  if (size() == 0) {
    levels_.clear();
    return;
  }
  if (builds_until_shape_-- == 0 || shaped_size_ != size()) shape();
  sort_into_squares();
  // Behind the last slot there is nothing near.
  for (std::size_t slot = size(); slot < size() + padding; ++slot) {
    slot_x_[slot] = slot_y_[slot] = 1e18F;
    slot_radius_[slot] = 0;
    slot_disc_[slot] = 0;
  }
}

void Quadtree::set_slot(std::uint32_t slot, std::size_t i) {
  const auto rounded = QuadtreeSearch::rounded(x_[i], y_[i], radius_[i]);
  slot_x_[slot] = rounded.x;
  slot_y_[slot] = rounded.y;
  slot_radius_[slot] = rounded.radius;
  slot_disc_[slot] = static_cast<std::uint32_t>(i);
  slot_[i] = slot;
}

// Chooses the levels and their tables. Whatever it chooses, what is found is right: only the time
// it takes depends on it.
void Quadtree::shape() {
  builds_until_shape_ = builds_per_shape;
  shaped_size_ = size();
  largest_ = *std::max_element(radius_.begin(), radius_.end());

  struct Extent {
    std::size_t discs = 0;
    std::int64_t left = std::numeric_limits<std::int64_t>::max();
    std::int64_t right = std::numeric_limits<std::int64_t>::min();
    std::int64_t bottom = std::numeric_limits<std::int64_t>::max();
    std::int64_t top = std::numeric_limits<std::int64_t>::min();
  };
  std::array<Extent, max_depths> extents;
  std::array<double, max_depths> sides;
  sides[0] = 2 * side_per_diameter * largest_;
  for (std::size_t depth = 1; depth < max_depths; ++depth) sides[depth] = sides[depth - 1] / 2;
  for (std::size_t i = 0; i < size(); ++i) {
    const std::size_t depth = depth_of(radius_[i]);
    const auto [column, row] = place({.per_side = 1 / sides[depth]}, x_[i], y_[i]);
    Extent& extent = extents[depth];
    ++extent.discs;
    extent.left = std::min(extent.left, column);
    extent.right = std::max(extent.right, column);
    extent.bottom = std::min(extent.bottom, row);
    extent.top = std::max(extent.top, row);
  }

  levels_.clear();
  std::uint32_t cells = 0;
  for (std::size_t depth = 0; depth < max_depths; ++depth) {
    const Extent& extent = extents[depth];
    if (extent.discs > 0) {
      // Enough squares for all of the level's part of the plane, if that is not too many; otherwise
      // the plane is folded.
      const auto columns = static_cast<std::uint64_t>(extent.right - extent.left + 1);
      const auto rows = static_cast<std::uint64_t>(extent.top - extent.bottom + 1);
      const std::uint64_t most = 2 * extent.discs;
      const bool fits = columns <= most && rows <= most && columns * rows <= most;
      const std::uint32_t count =
          std::bit_ceil(std::max(16U, static_cast<std::uint32_t>(fits ? columns * rows : most)));
      Level level;
      level.depth = static_cast<int>(depth);
      level.side = sides[depth];
      level.per_side = 1 / sides[depth];
      level.first_cell = cells;
      level.mask = count - 1;
      // At least 4, so that the eight neighbours of a square are different ones.
      level.stride = fits ? std::max(4U, static_cast<std::uint32_t>(columns))
                          : std::uint32_t{1} << (std::bit_width(count) / 2) | 1U;
      cells += count;
      levels_.push_back(level);
    }
    // A radius that comes later and whose own level does not exist goes to the next coarser.
    level_at_depth_[depth] = static_cast<std::uint8_t>(levels_.size() - 1);
  }
  starts_.resize(cells + 2);
}

std::size_t Quadtree::depth_of(double radius) const {
  std::size_t depth = 0;
  for (double limit = largest_ / 2; radius <= limit && depth + 1 < max_depths; limit /= 2) ++depth;
  return depth;
}

void Quadtree::sort_into_squares() {
  std::fill(starts_.begin(), starts_.end(), 0U);
  for (Level& level : levels_) level.largest = 0;
  if (levels_.size() == 1) {
    place_discs([](std::size_t) { return std::size_t{0}; });
  } else {
    level_.resize(size());
    for (std::size_t i = 0; i < size(); ++i) level_[i] = level_at_depth_[depth_of(radius_[i])];
    place_discs([this](std::size_t i) { return std::size_t{level_[i]}; });
  }
  for (Level& level : levels_) {
    level.begin = starts_[level.first_cell];
    level.end = starts_[level.first_cell + level.mask + 1];
    level.slack = 0;
  }
}

// The squares of all discs when there is one level, two at a time; as cell() and place() say.
void Quadtree::squares_of_two(const Level& level, std::size_t begin, std::size_t end) {
  std::size_t i = begin;
  for (; i + 2 <= end; i += 2) {
    const Long2 columns = coordinates(load<Double2>(&x_[i]), level.per_side);
    const Long2 rows = coordinates(load<Double2>(&y_[i]), level.per_side);
    const Long2 squares = (multiply_low(rows, level.stride) + columns) & std::int64_t{level.mask};
    cell_[i] = static_cast<std::uint32_t>(squares[0]);
    cell_[i + 1] = static_cast<std::uint32_t>(squares[1]);
  }
  for (; i < end; ++i) cell_[i] = cell(level, place(level, x_[i], y_[i]));
}

// A counting sort. Discs of a square keep the order of their indices.
template <class LevelOf>
void Quadtree::place_discs(LevelOf level_of) {
  // Local copies: the compiler knows that what the loops write does not change them.
  std::array<Level, max_depths> levels;
  std::copy(levels_.begin(), levels_.end(), levels.begin());
  const std::size_t n = size();
  const double* const x = x_.data();
  const double* const y = y_.data();
  const double* const radius = radius_.data();
  std::uint32_t* const starts = starts_.data();
  std::uint32_t* const square_of = cell_.data();

  if (levels_.size() == 1) {
    if (thread_pool_ == nullptr)
      squares_of_two(levels[0], 0, n);
    else
      thread_pool_->share(n, [&](std::size_t, std::size_t begin, std::size_t end) {
        squares_of_two(levels[0], begin, end);
      });
    levels_[0].largest = largest_of(radius_);
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      const Level& level = levels[level_of(i)];
      square_of[i] = level.first_cell + cell(level, place(level, x[i], y[i]));
      levels_[level_of(i)].largest = std::max(levels_[level_of(i)].largest, radius[i]);
    }
  }
  // Counts are kept two places further on, …
  for (std::size_t i = 0; i < n; ++i) ++starts[square_of[i] + 2];
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts_) {
    sum += start;
    start = sum;
  }
  // … so that the entry behind a square's own is where its next disc goes, and ends as the start of
  // the next square. Two discs at a time are rounded.
  const auto put = [&](std::size_t i, QuadtreeSearch::Rounded rounded)
      __attribute__((always_inline)) {
    const Level& level = levels[level_of(i)];
    const std::uint32_t slot = starts[square_of[i] + 1]++;
    slot_x_[slot] = rounded.x;
    slot_y_[slot] = rounded.y;
    slot_radius_[slot] = rounded.radius;
    slot_disc_[slot] = static_cast<std::uint32_t>(i);
    slot_cell_[slot] = square_of[i] - level.first_cell;
    slot_[i] = slot;
  };
  if (thread_pool_ == nullptr) {
    std::size_t i = 0;
    for (; i + 2 <= n; i += 2) {
      const auto two = QuadtreeSearch::rounded2(load<Double2>(x + i), load<Double2>(y + i),
                                                load<Double2>(radius + i));
      put(i, two[0]);
      put(i + 1, two[1]);
    }
    for (; i < n; ++i) put(i, QuadtreeSearch::rounded(x[i], y[i], radius[i]));
    return;
  }
  // Each thread fills its own squares, in the order of all discs: so every disc comes where one
  // thread would have put it.
  thread_pool_->share(starts_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = 0; i < n; ++i)
      if (square_of[i] >= begin && square_of[i] < end)
        put(i, QuadtreeSearch::rounded(x[i], y[i], radius[i]));
  });
}

void Quadtree::moved(std::size_t i) {
  set_slot(slot_[i], i);
  Level& level = levels_[levels_.size() == 1 ? 0 : level_[i]];
  const auto [column, row] = place(level, x_[i], y_[i]);
  const std::uint32_t home = cell_[i] - level.first_cell;
  if (cell(level, {column, row}) == home) return;
  // It stays listed in its old square. If that is a neighbour of the new one, searches are widened
  // by what it is outside of it.
  const auto outside = [&](double position, std::int64_t coordinate, int direction) {
    const double low = static_cast<double>(coordinate) * level.side;
    if (direction == 0) return 0.0;
    const double out = direction < 0 ? position - low : low + level.side - position;
    // Far away a position is not in the square that it counts to, and none is next to that one.
    return out >= -1e-3 * level.side ? out : std::numeric_limits<double>::infinity();
  };
  for (const int up : {-1, 0, 1})
    for (const int right : {-1, 0, 1})
      if (cell(level, {column + right, row + up}) == home) {
        const double out = std::max(outside(x_[i], column, right), outside(y_[i], row, up));
        if (!(out <= level.side)) continue;
        level.slack = std::max(level.slack, out + level.side * 1e-3);
        return;
      }
  if (strays_.size() < max_strays)
    strays_.push_back(static_cast<std::uint32_t>(i));
  else
    build(x_, y_, radius_);
}

void Quadtree::query_disc(Vec2 centre, double radius, std::vector<std::uint32_t>& found) const {
  const ExactArithmetic exact;
  found.clear();
  QuadtreeSearch(*this).near(centre.x, centre.y, radius, 1, [&](std::uint32_t i) {
    const double sum = radius_[i] + radius;
    if (length_squared(Vec2{x_[i], y_[i]} - centre) < sum * sum) found.push_back(i);
  });
  sort_unique(found);
}

void Quadtree::query_box(Vec2 low, Vec2 high, std::vector<std::uint32_t>& found) const {
  const ExactArithmetic exact;
  found.clear();
  QuadtreeSearch(*this).box(low, high, 1, [&](std::uint32_t i) {
    const Vec2 centre{x_[i], y_[i]};
    const Vec2 nearest{std::min(std::max(centre.x, low.x), high.x),
                       std::min(std::max(centre.y, low.y), high.y)};
    if (length_squared(centre - nearest) <= radius_[i] * radius_[i]) found.push_back(i);
  });
  sort_unique(found);
}

void Quadtree::overlapping_pairs(std::vector<Pair>& pairs) const {
  const ExactArithmetic exact;
  pairs.clear();
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    if (i == j) return;
    const double sum = radius_[i] + radius_[j];
    if (length_squared(Vec2{x_[j], y_[j]} - Vec2{x_[i], y_[i]}) < sum * sum)
      pairs.push_back({std::min(i, j), std::max(i, j)});
  };
  const QuadtreeSearch search(*this);
  const bool as_built = strays_.empty() && std::all_of(levels_.begin(), levels_.end(),
                                                       [](const Level& l) { return l.slack == 0; });
  if (as_built) {
    search.pairs(add);
  } else {
    for (std::uint32_t i = 0; i < size(); ++i)
      search.near(x_[i], y_[i], radius_[i], 1, [&](std::uint32_t j) {
        if (i < j) add(i, j);
      });
  }
  sort_unique(pairs);
}

// From where the discs are now: the table has forgotten how the plane was folded.
std::vector<Quadtree::Square> Quadtree::squares() const {
  using Taken = std::tuple<int, std::int64_t, std::int64_t, double>;  // depth, row, column, side
  std::vector<Taken> taken;
  taken.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const Level& level = levels_[levels_.size() == 1 ? 0 : level_[i]];
    const auto [column, row] = place(level, x_[i], y_[i]);
    taken.emplace_back(level.depth, row, column, level.side);
  }
  sort_unique(taken);
  std::vector<Square> squares;
  squares.reserve(taken.size());
  for (const auto& [depth, row, column, side] : taken)
    squares.push_back({.low = {static_cast<double>(column) * side, static_cast<double>(row) * side},
                       .side = side,
                       .level = depth});
  return squares;
}

}  // namespace carom
