#pragma once

#include <cstdint>

namespace search {

/// What a number of simulations say of a mean, with the interval that holds the true one in 95 of
/// 100 cases.
struct Estimate {
  double mean = 0;
  std::uint64_t n = 0;  ///< simulations
  double low = 0;
  double high = 0;
  friend bool operator==(const Estimate&, const Estimate&) = default;
};

/// The mean of `n` whole numbers with these sums; the interval is Gaussian. One number alone says
/// nothing of its spread: low and high are then the mean.
Estimate estimate_mean(std::uint64_t n, std::int64_t sum, std::int64_t sum_of_squares);

/// The rate of `hits` in `n`; the interval is Wilson's. Without simulations it is [0, 1].
Estimate estimate_rate(std::uint64_t n, std::uint64_t hits);

}  // namespace search
