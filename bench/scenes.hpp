#pragma once

#include <functional>
#include <string>
#include <vector>

#include "carom/scene.hpp"

namespace bench {

/// What is measured: start states, and how far each is run. The same on every machine, bit by bit.
struct Workload {
  std::string scene;  ///< "GAS"
  int balls = 0;      ///< in each of the start states
  /// Start states, built anew by each call; those of one call are run one after another.
  std::function<std::vector<carom::Scene>()> starts;
  int warm_up = 0;  ///< steps before the clock starts
  int steps = 0;    ///< steps measured; 0: until every ball is slower than carom::rest_speed
  /// For engines that know more than our model does (ours bounces without loss and without grip).
  double restitution = 1;  ///< between any two bodies
  double grip = 0;         ///< Coulomb friction between any two bodies
  bool has_holes = false;  ///< only our engine knows holes
  bool big = false;        ///< only part of the full run

  bool is_shot() const { return steps == 0; }
  std::string name() const { return scene + "/" + std::to_string(balls); }
};

/// All of them, the smallest of each scene first.
std::vector<Workload> workloads();

}  // namespace bench
