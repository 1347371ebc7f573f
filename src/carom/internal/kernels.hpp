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
  /// The least of so many times; never (infinity), if there are none. Readable as floats are.
  double (*least)(const double* times, std::size_t count);
  /// A bit for each of the times that is not later than `now`.
  std::uint64_t (*not_after)(const double* times, std::size_t count, double now);
  /// Stage 1 of whole steps, for balls whose acceleration stays as it is.
  struct Motion {
    double* x;
    double* y;
    double* vx;
    double* vy;
    const double* ax;  ///< null: no ball is accelerated
    const double* ay;
    std::uint64_t balls;  ///< a bit for each that is to move
    double friction;
    double part;  ///< s, of a sub-step
    int parts;    ///< of a step
    int steps;
  };
  void (*advance)(const Motion& motion);
};

/// The functions that run on every machine.
const Kernels& plain_kernels();
/// None where there is no AVX2.
const Kernels* avx2_kernels();
/// The widest of these; chosen once.
const Kernels& kernels();

}  // namespace carom
