#pragma once

#include <cstddef>
#include <cstdint>

#include "carom/event.hpp"
#include "carom/public.hpp"
#include "carom/vec2.hpp"

namespace CAROM_PUBLIC carom {

// Regions that a world is asked about, and its answer.

struct Disc {
  Vec2 centre{};      ///< px
  double radius = 0;  ///< px, ≥ 0
};

struct Box {
  Vec2 low{};   ///< px, the lower left corner
  Vec2 high{};  ///< px, the upper right one
};

/// The first that a disc meets on its way (World::first_contact).
struct Contact {
  enum class With : std::uint8_t { ball, edge, obstacle };
  With with = With::ball;
  /// ball: its index; edge: the Side; obstacle: its index.
  std::size_t index = 0;
  double distance = 0;  ///< px, from where the disc was to where it touches
  Vec2 position{};      ///< px, the disc's centre there

  friend bool operator==(const Contact&, const Contact&) = default;
};

}  // namespace carom
