#include "search/shot_map.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "carom/arithmetic.hpp"

namespace search {

namespace {

constexpr std::size_t most_cells = 1'000'000;

bool is_speed(std::int64_t speed) { return speed >= least_speed && speed <= greatest_speed; }

}  // namespace

Aim MapArea::aim(std::size_t cell) const {
  const auto column = static_cast<std::int64_t>(cell % static_cast<std::size_t>(columns));
  const auto row = static_cast<std::int64_t>(cell / static_cast<std::size_t>(columns));
  // In (−1800, 1800].
  const std::int64_t turned = (1800 - (first_tenths + column * tenths_step)) % 3600;
  return {.tenths = static_cast<int>(1800 - (turned < 0 ? turned + 3600 : turned)),
          .speed = static_cast<int>(first_speed + row * speed_step)};
}

MapArea area_around(const Aim& aim, int cells, int tenths_step, int speed_step) {
  const int below = std::min(cells, (aim.speed - least_speed) / speed_step);
  const int above = std::min(cells, (greatest_speed - aim.speed) / speed_step);
  return {.first_tenths = aim.tenths - cells * tenths_step,
          .tenths_step = tenths_step,
          .columns = 2 * cells + 1,
          .first_speed = aim.speed - below * speed_step,
          .speed_step = speed_step,
          .rows = below + 1 + above};
}

carom::Result<ShotMap> ShotMap::create(Game game, const MapArea& area) {
  if (const carom::Status waiting = check_waiting(game); !waiting) return waiting.errors();
  const auto* table = std::get_if<games::billiards::Game>(&game);
  if (table != nullptr && table->phase() == games::billiards::Phase::place)
    return carom::Error{.problem = "has the cue ball in hand", .expected = "one that lies"};
  const std::int64_t last = area.first_speed + std::int64_t{area.rows - 1} * area.speed_step;
  if (area.columns < 1 || area.rows < 1 || area.tenths_step < 1 || area.tenths_step > 3600 ||
      area.speed_step < 1 || area.cells() > most_cells || !is_speed(area.first_speed) ||
      !is_speed(last))
    return carom::Error{.pointer = "area",
                        .problem = "is wrong",
                        .expected = "1 to 1000000 cells of speeds from 31 to 2000 px/s"};
  return ShotMap(std::move(game), area);
}

// A stride without common factor with their number, near the golden section, reaches all cells and
// spreads the first ones evenly.
ShotMap::ShotMap(Game game, const MapArea& area)
    : game_(std::move(game)), area_(area), cells_(area.cells()) {
  stride_ = std::max<std::uint64_t>(1, area.cells() * 618 / 1000);
  while (std::gcd(stride_, area.cells()) != 1) ++stride_;
}

std::size_t ShotMap::cell_of(std::uint64_t job) const {
  return static_cast<std::size_t>(job * stride_ % cells_.size());
}

void ShotMap::advance(std::uint64_t simulations, carom::Rollouts& rollouts) {
  const carom::ExactArithmetic exact;
  while (simulations > 0 && !done()) {
    const std::uint64_t now = std::min({simulations, cells_.size() - played_, most_at_once});
    trials_.resize(static_cast<std::size_t>(now));
    rollouts.run(world_of(game_), std::span(trials_), [this](carom::World& world, std::size_t k) {
      return simulate(world, {}, drag(area_.aim(cell_of(played_ + k))));
    });
    for (std::uint64_t k = 0; k < now; ++k)
      cells_[cell_of(played_ + k)] = trials_[static_cast<std::size_t>(k)];
    played_ += now;
    simulations -= now;
  }
}

std::optional<std::size_t> ShotMap::nearest_clearing(const Aim& aim) const {
  const carom::ExactArithmetic exact;
  const carom::Vec2 from = drag(aim);
  std::optional<std::size_t> nearest;
  double least = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!cells_[i] || !cells_[i]->cleared) continue;
    const double square = carom::length_squared(drag(area_.aim(i)) - from);
    if (nearest && square >= least) continue;
    nearest = i;
    least = square;
  }
  return nearest;
}

}  // namespace search
