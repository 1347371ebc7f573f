#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "carom/event.hpp"
#include "carom/internal/forecast.hpp"
#include "carom/internal/packed_index.hpp"
#include "carom/internal/places.hpp"
#include "carom/internal/quadtree_search.hpp"
#include "carom/internal/row_pairs.hpp"
#include "carom/internal/thread_pool.hpp"

namespace carom {

/// Buffers that World::step keeps from call to call to save allocations. Not part of the state.
struct Workspace {
  std::vector<Event> events;  ///< of the last step
  Forecast forecast;
  std::vector<std::uint8_t> gone;  ///< by index: went out of play in this sub-step
  PackedIndex packed;
  QuadtreeIndex tree;
  RowPairsBuffers rows;
  Places places;
  std::unique_ptr<ThreadPool> thread_pool;  ///< none: one thread
  std::size_t threads_wanted = 1;

  /// Balls came, went or got another radius otherwise than in a step.
  void forget_balls() {
    packed = {};
    tree = {};
    tree.set_thread_pool(thread_pool.get());
  }

  void set_threads(std::size_t threads) {
    if (threads == threads_wanted) return;
    threads_wanted = threads;
    thread_pool = threads > 1 ? std::make_unique<ThreadPool>(threads) : nullptr;
    tree.set_thread_pool(thread_pool.get());
  }
};

}  // namespace carom
