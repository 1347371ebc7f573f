#include "search/estimate.hpp"

#include <gtest/gtest.h>

#include "games/random.hpp"

namespace {

TEST(EstimateMean, OfKnownNumbers_HasTheirMeanAndGaussianInterval) {
  // 0, 100, 200: standard deviation 100
  const search::Estimate estimate = search::estimate_mean(3, 300, 50'000);
  EXPECT_DOUBLE_EQ(estimate.mean, 100);
  EXPECT_EQ(estimate.n, 3U);
  EXPECT_NEAR(estimate.low, 100 - 1.96 * 100 / 1.7320508, 1e-6);
  EXPECT_NEAR(estimate.high, 100 + 1.96 * 100 / 1.7320508, 1e-6);
}

TEST(EstimateMean, OfOneOrNoNumber_HasNoWidth) {
  EXPECT_EQ(search::estimate_mean(1, 300, 90'000),
            (search::Estimate{.mean = 300, .n = 1, .low = 300, .high = 300}));
  EXPECT_EQ(search::estimate_mean(0, 0, 0), search::Estimate{});
}

// By the formula of Wilson (1927), computed with bc.
TEST(EstimateRate, OfKnownHits_HasWilsonsInterval) {
  const search::Estimate estimate = search::estimate_rate(100, 55);
  EXPECT_DOUBLE_EQ(estimate.mean, 0.55);
  EXPECT_NEAR(estimate.low, 0.45244, 1e-5);
  EXPECT_NEAR(estimate.high, 0.64385, 1e-5);
}

TEST(EstimateRate, WithoutMissesOrHits_StaysWithinZeroAndOne) {
  EXPECT_EQ(search::estimate_rate(20, 0).low, 0);
  EXPECT_NEAR(search::estimate_rate(20, 0).high, 0.1611, 1e-4);
  EXPECT_EQ(search::estimate_rate(20, 20).high, 1);
  EXPECT_EQ(search::estimate_rate(0, 0), (search::Estimate{.high = 1}));
}

TEST(EstimateRate, OfManyExperiments_HoldsTheTruthInSome95Percent) {
  games::Random random(5);
  int held = 0;
  for (int i = 0; i < 2000; ++i) {
    std::uint64_t hits = 0;
    for (int k = 0; k < 60; ++k) hits += random.uniform(0, 1) < 0.3 ? 1 : 0;
    const search::Estimate estimate = search::estimate_rate(60, hits);
    held += estimate.low <= 0.3 && 0.3 <= estimate.high ? 1 : 0;
  }
  EXPECT_GT(held, 1860);
  EXPECT_LT(held, 1950);
}

}  // namespace
