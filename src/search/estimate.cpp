#include "search/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "carom/arithmetic.hpp"

namespace search {

namespace {
constexpr double z = 1.96;  // 95 % of a Gaussian lie within so many standard deviations
}

Estimate estimate_mean(std::uint64_t n, std::int64_t sum, std::int64_t sum_of_squares) {
  const carom::ExactArithmetic exact;
  if (n == 0) return {};
  const auto count = static_cast<double>(n);
  const double mean = static_cast<double>(sum) / count;
  double half = 0;
  if (n > 1) {
    const double squares = static_cast<double>(sum_of_squares) - mean * static_cast<double>(sum);
    half = z * std::sqrt(std::max(0.0, squares) / (count - 1) / count);
  }
  return {.mean = mean, .n = n, .low = mean - half, .high = mean + half};
}

Estimate estimate_rate(std::uint64_t n, std::uint64_t hits) {
  const carom::ExactArithmetic exact;
  if (n == 0) return {.high = 1};
  const auto count = static_cast<double>(n);
  const double rate = static_cast<double>(hits) / count;
  const double scale = 1 + z * z / count;
  const double middle = (rate + z * z / (2 * count)) / scale;
  const double half =
      z / scale * std::sqrt(rate * (1 - rate) / count + z * z / (4 * count * count));
  return {.mean = rate,
          .n = n,
          .low = hits == 0 ? 0 : std::max(0.0, middle - half),
          .high = hits == n ? 1 : std::min(1.0, middle + half)};
}

}  // namespace search
