#pragma once

#include <cstdint>

namespace games {

/// Repeatable random numbers: the generator SplitMix64 (Steele, Lea and Flood, 2014). The standard
/// library's distributions may differ from one compiler to the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
  }

  /// From 0 to `count`, exclusive; `count` > 0 and far below 2^64.
  std::uint64_t below(std::uint64_t count) { return next() % count; }
  bool one_in(std::uint64_t count) { return below(count) == 0; }
  /// From `low` to `high`, exclusive but for rounding.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

}  // namespace games
