#pragma once

#include <cstddef>

namespace bench {

// One step of `count` coordinates that are reflected at `low` and `high`. Apart from the rest and
// without a header of the engine, because it is compiled with options that the engine refuses.
void reflect(double* __restrict position, double* __restrict velocity, std::size_t count,
             double time_step, double low, double high);

}  // namespace bench
