#include "reflect.hpp"

#include <algorithm>

namespace bench {

// Selections instead of branches, so that the compiler makes vectors of it.
void reflect(double* __restrict position, double* __restrict velocity, std::size_t count,
             double time_step, double low, double high) {
  for (std::size_t i = 0; i < count; ++i) {
    const double moved = position[i] + velocity[i] * time_step;
    position[i] = std::min(std::max(moved, low), high);
    velocity[i] = position[i] == moved ? velocity[i] : -velocity[i];
  }
}

}  // namespace bench
