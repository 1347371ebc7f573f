#pragma once

#include <optional>

#include "carom/world.hpp"

namespace app {

/// Where a ball first meets something if it rolls straight on.
struct FirstContact {
  carom::Vec2 center;                 ///< of the rolling ball, at the contact
  std::optional<carom::Vec2> target;  ///< centre of the ball it hits; none: an edge
};

/// For ball `index` rolling along `direction` (not zero) to a ball or a solid edge; holes are
/// ignored. None if it leaves by an open edge.
std::optional<FirstContact> first_contact(const carom::World& world, std::size_t index,
                                          carom::Vec2 direction);

}  // namespace app
