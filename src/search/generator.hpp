#pragma once

#include <cstdint>
#include <optional>

#include "carom/result.hpp"
#include "carom/rollouts.hpp"
#include "carom/scene.hpp"
#include "search/estimate.hpp"
#include "search/level_parts.hpp"
#include "search/seed.hpp"

/// Levels made to order (docs/search.md): put together, settled, solved, rated.
namespace search {

/// A new number whenever the same order gives another level than before.
inline constexpr int generator_version = 1;

struct Order {
  double difficulty = 0.5;  ///< wanted, in [0, 1]: 1 − the reference player's pass rate
  Seed seed = 1;
  std::optional<Part> first{};     ///< the part that the level is about; none: any
  std::uint64_t candidates = 100;  ///< levels that are put together, at most
};

struct Generated {
  carom::Scene level{};
  Estimate difficulty{};         ///< as measured
  std::uint64_t candidates = 0;  ///< put together
};

/// The first candidate that stays as it is, gives a player nothing to object to (level_check.hpp),
/// is won by throws that the solver finds, is not won by chance, and whose difficulty, once the
/// solidities of its enemies are tuned, is measured to be within 0.04 of what is wanted. The same
/// order gives the same level everywhere. Refuses a difficulty out of range, and tells when the
/// candidates are used up.
carom::Result<Generated> generate(const Order& order, carom::Rollouts& rollouts);

}  // namespace search
