#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "carom/scene.hpp"

namespace bench {

/// Workloads: start states, and how far each is run. The same on every machine, bit by bit.
struct Workload {
  std::string scene;  ///< "GAS"
  int balls = 0;      ///< in each of the start states
  /// Start states, built anew by each call; those of one call are run one after another.
  std::function<std::vector<carom::Scene>()> starts;
  int warm_up = 0;  ///< steps before the clock starts
  int steps = 0;    ///< steps measured; 0: until every ball is slower than carom::rest_speed
  /// Of a throw in a level, after which it is over; 0: until rest, which always comes.
  std::uint64_t most_steps = 0;
  /// For engines that know more than our model does (ours bounces without loss and without grip).
  double restitution = 1;   ///< between any two bodies
  double grip = 0;          ///< Coulomb friction between any two bodies
  bool ours_alone = false;  ///< only our engine knows holes and levels
  bool big = false;         ///< only part of the full run

  bool is_shot() const { return steps == 0; }
  std::string name() const { return scene + "/" + std::to_string(balls); }
};

/// All of them, the smallest of each scene first; `levels`: the folder of the shipped ones.
std::vector<Workload> workloads(const std::filesystem::path& levels);

}  // namespace bench
