#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "carom/result.hpp"
#include "carom/rollouts.hpp"
#include "search/candidates.hpp"
#include "search/simulation.hpp"

namespace search {

/// The aims of a map, one for each of its cells.
struct MapArea {
  int first_tenths = 0;  ///< of column 0, 0.1°
  int tenths_step = 10;  ///< from column to column, 1 to 3600
  int columns = 90;
  int first_speed = 50;  ///< of row 0, px/s; all speeds must be in [least_speed, greatest_speed]
  int speed_step = 50;
  int rows = 40;

  Aim aim(std::size_t cell) const;  ///< cells go row by row
  std::size_t cells() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

/// The area around an aim with so many cells of this size on each side of it, as far as there are
/// speeds.
MapArea area_around(const Aim& aim, int cells, int tenths_step, int speed_step);

/// What each exact shot of an area comes to, filled in by slices, evenly over the whole area. The
/// same for every number of threads.
class ShotMap {
 public:
  /// Refuses what Search::create refuses of a game, a cue ball in hand, an area without cells or of
  /// more than 1 000 000, and speeds out of range.
  static carom::Result<ShotMap> create(Game game, const MapArea& area);

  /// Plays at most so many cells.
  void advance(std::uint64_t simulations, carom::Rollouts& rollouts);
  bool done() const { return played_ == cells_.size(); }
  const MapArea& area() const { return area_; }
  /// None until it is played.
  const std::optional<Trial>& cell(std::size_t index) const { return cells_[index]; }
  /// Of the cells played so far that clear the table or level the one whose drag is nearest to
  /// `aim`'s.
  std::optional<std::size_t> nearest_clearing(const Aim& aim) const;

 private:
  ShotMap(Game game, const MapArea& area);
  std::size_t cell_of(std::uint64_t job) const;

  Game game_;
  MapArea area_;
  std::uint64_t stride_ = 1;
  std::vector<std::optional<Trial>> cells_;
  std::uint64_t played_ = 0;
  std::vector<Trial> trials_;
};

}  // namespace search
