#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "carom/scene.hpp"
#include "scenes.hpp"

namespace bench {

/// An engine with one start state in it, stepped by carom::time_step. A virtual call costs a run,
/// not a step.
class Simulator {
 public:
  Simulator() = default;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;
  virtual ~Simulator() = default;

  virtual void advance(int steps) = 0;
  /// Steps until every ball is slower than carom::rest_speed; at most `limit`. Returns how many.
  virtual int run_until_rest(int limit) = 0;
  /// Positions, velocities and radii as they are now.
  virtual std::vector<carom::Ball> balls() const = 0;
  /// carom::World::state_hash(); nothing for engines that are not ours.
  virtual std::optional<std::uint64_t> hash() const { return std::nullopt; }
};

using MakeSimulator = std::unique_ptr<Simulator>(const carom::Scene& start, const Workload& load);

// The contestants, each in a file of its name.
MakeSimulator make_carom;
MakeSimulator make_carom_never_skip;  ///< every step tested, also where surely nothing meets
MakeSimulator make_carom_pairs;       ///< every pair tested: the reference
MakeSimulator make_carom_quadtree;    ///< even for a few balls
MakeSimulator make_carom_1_thread;    ///< as make_carom, but timed by the clock on the wall
MakeSimulator make_carom_2_threads;
MakeSimulator make_carom_4_threads;
MakeSimulator make_chipmunk_tree;  ///< with its default, a tree of bounding boxes
MakeSimulator make_chipmunk_hash;  ///< with its spatial hash
MakeSimulator make_box2d;
/// No engine: x += v·dt and a reflection at the sides, over arrays of numbers. What no engine that
/// keeps its balls in memory can beat.
MakeSimulator make_streaming;

}  // namespace bench
