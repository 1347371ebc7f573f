#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "carom/public.hpp"
#include "carom/vec2.hpp"

namespace CAROM_PUBLIC carom {

/// An event of a step. Rules, sounds and effects read only these (docs/physics.md#one-step).
enum class EventKind : std::uint8_t {
  pair,       ///< two balls collided (§1.2.3); a triple gives three of these (§1.2.4)
  cushion,    ///< a ball was thrown back by an edge (§1.2.2)
  floor,      ///< the same by the bottom edge under gravity (§2.2.3)
  wall,       ///< by an obstacle's wall (§2.2.5)
  cap,        ///< by an obstacle's rounded top (§2.2.5)
  damage,     ///< a shock wore a ball down; follows the collision it belongs to (§2.2.3)
  pocketed,   ///< a ball fell into a hole (§1.2.5)
  destroyed,  ///< a ball's solidity went below zero; follows its damage (§2.1.1)
  left,       ///< a ball left by an open side (§2.1.3)
};

/// A set of kinds, written as EventKind::pocketed | EventKind::left.
class EventKinds {
 public:
  constexpr EventKinds() = default;
  constexpr EventKinds(EventKind kind) : bits_(1U << static_cast<unsigned>(kind)) {}

  constexpr bool has(EventKind kind) const {
    return (bits_ >> static_cast<unsigned>(kind) & 1U) != 0;
  }
  constexpr bool empty() const { return bits_ == 0; }

  friend constexpr EventKinds operator|(EventKinds a, EventKinds b) {
    a.bits_ |= b.bits_;
    return a;
  }
  friend constexpr bool operator==(EventKinds, EventKinds) = default;

 private:
  std::uint32_t bits_ = 0;
};

constexpr EventKinds operator|(EventKind a, EventKind b) { return EventKinds(a) | EventKinds(b); }

enum class Side : std::uint8_t { left, right, bottom, top };

struct Event {
  EventKind kind = EventKind::pair;
  std::uint32_t ball = 0;  ///< id of the ball; of a pair the first
  /// pair: id of the second ball. cushion, floor: the Side. wall, cap: index of the obstacle.
  /// pocketed: index of the hole. Otherwise 0.
  std::uint32_t other = 0;
  Vec2 position{};  ///< px, where: the ball's centre, for a pair the point of contact
  /// px/s. pair: the deviation dv of the exchange (the first ball loses it, the second gains it).
  /// cushion, floor, wall, cap: the whole change of the ball's velocity, zero if it was parting.
  Vec2 deviation{};
  double damage = 0;    ///< damage: the solidity lost, ds
  double solidity = 0;  ///< damage: the solidity left, negative when it broke the ball

  /// The edge of a cushion or floor.
  std::optional<Side> side() const {
    if (kind != EventKind::cushion && kind != EventKind::floor) return std::nullopt;
    return static_cast<Side>(other);
  }
  /// The index of the hole that a ball fell into.
  std::optional<std::size_t> hole() const {
    if (kind != EventKind::pocketed) return std::nullopt;
    return other;
  }
  /// The index of the obstacle whose wall or cap was hit.
  std::optional<std::size_t> obstacle() const {
    if (kind != EventKind::wall && kind != EventKind::cap) return std::nullopt;
    return other;
  }

  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace carom
