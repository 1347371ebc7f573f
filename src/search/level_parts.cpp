#include "search/level_parts.hpp"

#include <cmath>

#include "carom/arithmetic.hpp"

namespace search {

namespace {

using carom::Ball;
using carom::Role;

constexpr double width = 1000;  // px, all of them
constexpr double height = 500;
constexpr double launch_x = 110;
constexpr double first_part = 360;  // where parts begin and end
constexpr double last_part = 940;
constexpr double apart = 1.01;  // of two balls that touch, in sums of radii
constexpr double half_root_of_3 = 0.86602540378443865;

constexpr std::array<double, 3> enemy_solidities{1200, 2600, 5200};
constexpr double neutral_solidity = 5200;
constexpr double hard_solidity = 12'000;

// To hundredths, as people write levels.
double written(double px) { return std::round(px * 100) / 100; }

class Assembly {
 public:
  explicit Assembly(games::Random& random) : random_(random) {
    level_.width = width;
    level_.height = height;
    level_.edges = {.left = carom::Edge::open,
                    .right = carom::Edge::open,
                    .bottom = carom::Edge::solid,
                    .top = carom::Edge::open};
    level_.gravity = 600;
    level_.damage_threshold = 400;
    level_.balls.push_back({.role = Role::projectile, .position = {launch_x, 120}, .radius = 12});
    next_ = first_part + whole(0, 10) * 10;
  }

  /// Puts a part on the floor if there is room left.
  void add(Part part) {
    const std::size_t balls = level_.balls.size();
    const std::size_t obstacles = level_.obstacles.size();
    const double before = next_;
    put(part);
    if (next_ <= last_part || balls == 1) {
      next_ += whole(1, 8) * 10;
      return;
    }
    level_.balls.resize(balls);
    level_.obstacles.resize(obstacles);
    next_ = before;
  }

  carom::Scene level() && { return std::move(level_); }

 private:
  void put(Part part) {
    switch (part) {
      case Part::ball:
        enemy(take(radius()), 0);
        break;
      case Part::sentinel:
        on_obstacle();
        break;
      case Part::tower:
        tower();
        break;
      case Part::pyramid:
        pyramid();
        break;
      case Part::pit:
        pit();
        break;
      case Part::wall:
        obstacle(whole(12, 26) * 10);
        next_ += whole(1, 4) * 10;
        enemy(take(radius()), 0);
        break;
      case Part::chain:
        chain();
        break;
      case Part::room:
        level_.edges.right = carom::Edge::solid;
        level_.edges.top = carom::Edge::solid;
        on_obstacle();
        break;
    }
  }

  int whole(int least, int most) {
    return least + static_cast<int>(random_.below(static_cast<std::uint64_t>(most - least + 1)));
  }
  double radius() { return whole(14, 18); }

  struct Place {
    double x = 0;
    double radius = 0;
  };
  /// Room for a ball of this radius from `next_` on.
  Place take(double radius) {
    const Place place{.x = next_ + radius, .radius = radius};
    next_ += 2 * radius + 2;
    return place;
  }

  void ball(Role role, const Place& place, double bottom, double solidity) {
    level_.balls.push_back({.role = role,
                            .position = {written(place.x), written(bottom + place.radius)},
                            .radius = place.radius,
                            .solidity = solidity});
  }
  void enemy(const Place& place, double bottom) {
    ball(Role::enemy, place, bottom,
         enemy_solidities[static_cast<std::size_t>(random_.below(enemy_solidities.size()))]);
  }

  double obstacle(double high) {
    constexpr double radius = 12;
    const Place place = take(radius);
    level_.obstacles.push_back({.x = written(place.x), .height = high, .radius = radius});
    return place.x;
  }
  void on_obstacle() {
    const double high = whole(8, 28) * 10;
    const double x = obstacle(high);
    const double own = radius();
    enemy({.x = x, .radius = own}, high + apart * (12 + own) - own);
  }

  void tower() {
    const double own = radius();
    const Place place = take(own);
    double bottom = 0;
    for (int n = whole(1, 3); n > 0; --n) {
      ball(Role::neutral, place, bottom, neutral_solidity);
      bottom += 2 * apart * own;
    }
    enemy(place, bottom);
  }

  void pyramid() {
    const double own = radius();
    const double side = 2 * apart * own;  // a triangle's
    const double x = next_ + own;
    next_ += 2 * side + 2 * own + 2;
    for (int row = 0; row < 3; ++row)
      for (int i = 0; i < 3 - row; ++i) {
        const Place place{.x = x + side * (i + row / 2.0), .radius = own};
        const double bottom = row * side * half_root_of_3;
        if (row == 2 || random_.one_in(4))
          enemy(place, bottom);
        else
          ball(Role::neutral, place, bottom, neutral_solidity);
      }
  }

  void pit() {
    const double high = whole(8, 20) * 10;
    obstacle(high);
    next_ += whole(1, 4) * 10;
    for (int n = whole(1, 3); n > 0; --n) {
      enemy(take(radius()), 0);
      next_ += 10;
    }
    next_ += whole(0, 3) * 10;
    obstacle(high);
  }

  void chain() {
    const double own = radius();
    for (int n = whole(2, 5); n > 0; --n) {
      ball(Role::neutral, {.x = next_ + own, .radius = own}, 0, hard_solidity);
      next_ += 2 * apart * own;
    }
    next_ += whole(1, 6) * 10;
    enemy(take(own), 0);
  }

  games::Random& random_;
  carom::Scene level_;
  double next_ = first_part;  // px, where the next part begins
};

}  // namespace

carom::Scene assemble(Part first, std::size_t parts, games::Random& random) {
  const carom::ExactArithmetic exact;
  Assembly assembly(random);
  assembly.add(first);
  // A room is no part to be put beside others.
  for (std::size_t i = 1; i < parts; ++i)
    assembly.add(static_cast<Part>(random.below(static_cast<std::uint64_t>(Part::room))));
  return std::move(assembly).level();
}

}  // namespace search
