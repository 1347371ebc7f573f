#pragma once

#include <cstdint>
#include <initializer_list>

#include "games/random.hpp"

namespace search {

/// The same seed, the same answer.
using Seed = std::uint64_t;

/// Uses of one seed, each with random numbers of its own.
enum class Use : std::uint64_t {
  proposals,
  searching,
  fresh,
  hand,
  turn,
  match,
  played,
  solving,
  generating
};

/// Random numbers of the i-th thing, and the k-th of it, that a seed is used for.
inline games::Random random_of(Seed seed, Use use, std::uint64_t i = 0, std::uint64_t k = 0) {
  // Seeds next to each other would give the same sequence, shifted: each part is mixed in.
  for (const std::uint64_t part : {static_cast<std::uint64_t>(use), i, k})
    seed = games::Random(seed).next() ^ part;
  return games::Random(games::Random(seed).next());
}

}  // namespace search
