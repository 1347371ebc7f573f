#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "carom/public.hpp"
#include "carom/result.hpp"
#include "carom/vec2.hpp"

namespace CAROM_PUBLIC carom {

// Limits of what is accepted; they hold in every build. Anything beyond is refused, never clamped.
inline constexpr std::size_t max_balls = 10'000'000;
inline constexpr std::size_t max_fixtures = 100'000;  ///< holes, and obstacles, each
inline constexpr double max_speed = 100'000;          ///< px/s
/// Lengths (px), gravity and hole pull (px/s²), damage_per_speed.
inline constexpr double max_quantity = 1e9;
/// Radii, heights and the play area's size (px). A coordinate is up to 10¹² times as large, and
/// what rounding makes of it is far below all margins by which pairs are found.
inline constexpr double min_size = 0.001;
inline constexpr int max_throws = 1000;

inline constexpr double infinite_solidity = std::numeric_limits<double>::infinity();

/// The meaning of a ball for the rules; the physics only asks whether it is the lead (cue,
/// projectile).
enum class Role : std::uint8_t { neutral, cue, red, enemy, projectile };

/// The cue ball or the projectile: always ball 0, kept there when it goes out of play (§1.4.1).
constexpr bool is_lead(Role role) { return role == Role::cue || role == Role::projectile; }

inline constexpr double default_radius = 10;     ///< px, a red ball's (§1.4.2)
inline constexpr double default_cue_radius = 8;  ///< px (§1.4.2)

/// A ball (§1.1.2, §2.1.1). All balls have the same mass.
struct Ball {
  /// Stable name, whatever index the ball moves to. World::create sets it to the index in the
  /// scene.
  std::uint32_t id = 0;
  Role role = Role::neutral;
  Vec2 position{};                 ///< px, the centre
  Vec2 velocity{};                 ///< px/s, at most max_speed long when given
  Vec2 acceleration{};             ///< px/s², what acts in the next step's move; zero at the start
  double radius = default_radius;  ///< px, ≥ min_size
  /// Worn down by shocks; below 0 the ball is destroyed. ≥ 0, or infinite (the default, and
  /// always for a projectile) (§2.1.1).
  double solidity = infinite_solidity;

  friend bool operator==(const Ball&, const Ball&) = default;
};

/// A disc that pulls balls and pockets those wholly inside it (§1.1.3, §1.2.5).
struct Hole {
  Vec2 position{};     ///< px, the centre
  double radius = 16;  ///< px, ≥ min_size (§1.4.2)

  friend bool operator==(const Hole&, const Hole&) = default;
};

/// An indestructible wall planted in the floor, capped by a fixed disc (§2.1.2).
struct Obstacle {
  double x = 0;         ///< px, the middle of the wall
  double height = 120;  ///< px, ≥ min_size, the altitude of the cap's centre
  double radius = 12;   ///< px, ≥ min_size, the cap's radius and half the wall's width

  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// A solid edge throws balls back; an open one lets them go (§1.2.2, §2.1.3).
enum class Edge : std::uint8_t { solid, open };

/// The four sides of the play area. Open left and right remove a ball that is wholly outside; an
/// open top or bottom removes nothing.
struct Edges {
  Edge left = Edge::solid;
  Edge right = Edge::solid;
  Edge bottom = Edge::solid;
  Edge top = Edge::solid;

  friend bool operator==(const Edges&, const Edges&) = default;
};

/// A whole world as data: what a scene file or a level file says (docs/formats.md; §1.1.4, §2.1.3).
struct Scene {
  std::string name{};
  // Nothing of these three counts for the physics, the rules or a level's identity.
  std::string author{};
  std::string licence{};  ///< such as "CC-BY-4.0"
  std::string description{};
  double width = 800;           ///< px, ≥ min_size
  double height = 400;          ///< px, ≥ min_size
  Edges edges{};                ///< all solid
  double friction = 0.995;      ///< factor on every velocity per step, in (0, 1] (§1.1.4)
  double gravity = 0;           ///< px/s² downwards, ≥ 0 (§2.2.1)
  double hole_pull = 100'000;   ///< px/s², ≥ 0, "Poids" (§1.2.5)
  double damage_per_speed = 4;  ///< solidity units per px/s of deviation, ≥ 0 (§2.2.3)
  double damage_threshold = 0;  ///< solidity units, ≥ 0; a weaker shock costs nothing (§2.1.1)
  int throws = 3;               ///< of the projectile, 1 to max_throws (§2.3.2)
  std::vector<Hole> holes{};    ///< §1.1.3
  std::vector<Obstacle> obstacles{};  ///< §2.1.2
  /// A lead (cue ball or projectile), if any, must be ball 0. Balls may overlap each other, but no
  /// obstacle and no solid edge, and not in more than max_overlaps() pairs. Nor may centres lie in
  /// holes in more.
  std::vector<Ball> balls{};

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// The number of pairs of this many balls that may overlap at the start: more could be resolved,
/// but a single step would take minutes.
constexpr std::size_t max_overlaps(std::size_t balls) { return 20 * balls + 10'000; }

/// All that is wrong with a scene's values (pointers as in its file), at most max_errors of them;
/// empty when it is sound.
Errors check(const Scene& scene);

/// Errors are listed up to this many; a last one then says that there are more.
inline constexpr std::size_t max_errors = 1000;

}  // namespace carom
