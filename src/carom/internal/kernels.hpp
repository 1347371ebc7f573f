#pragma once

#include <cstddef>
#include <cstdint>

namespace carom {

/// The inner loops of a Forecast, in as wide vectors as the machine has. Each lane is rounded as a
/// single number is, and nothing is fused: every set gives the same bits. Arrays of floats are
/// readable up to the next multiple of 8.
struct Kernels {
  const char* name;  ///< of the instructions used

  struct Discs {
    const float* x;
    const float* y;
    const float* vx;  ///< null: all stand
    const float* vy;
    const float* radius;
    std::size_t count;  ///< ≤ 64
  };
  struct Disc {
    float x, y, vx, vy;
    float radius;  ///< with all slack
  };

  /// A bit for each disc that `one` overlaps or, if both go straight on, may overlap later.
  std::uint64_t (*may_meet)(const Discs& discs, const Disc& one);
  /// A bit for each disc whose centre is within factor·(sum of radii) + slack of the disc's.
  std::uint64_t (*within)(const Discs& discs, const Disc& one, float factor, float slack);
  void (*to_floats)(const double* from, float* to, std::size_t count);
  /// Stage 1 of whole steps, for balls whose acceleration stays 0 along x, and ay along y.
  struct Motion {
    double* x;
    double* y;
    double* vx;
    double* vy;
    const double* ay;      ///< null: 0
    std::uint64_t moving;  ///< others may be left out: they stand
    std::size_t count;
    double friction;
    double part;  ///< s, of a sub-step
    int parts;    ///< of a step
    int steps;
  };
  void (*advance)(const Motion& motion);
};

/// What every machine has.
const Kernels& plain_kernels();
/// None where there is no AVX2.
const Kernels* avx2_kernels();
/// The widest of these; chosen once.
const Kernels& kernels();

}  // namespace carom
