#pragma once

#include <cstdint>
#include <vector>

#include "carom/packed_index.hpp"
#include "carom/quadtree_search.hpp"
#include "carom/row_pairs.hpp"

namespace carom {

/// What World::step keeps from call to call to save allocations. No part of the state.
struct Workspace {
  std::vector<std::uint8_t> gone;  ///< by index: went out of play in this sub-step
  PackedIndex packed;
  QuadtreeIndex tree;
  RowPairsBuffers rows;
};

}  // namespace carom
