#include "estimator/regression/signed_rank.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace secular {
namespace {

// By definition: every pattern of signs in turn.
double enumerated(const std::vector<double>& d) {
  const std::size_t n = d.size();
  std::vector<double> rank(n);
  for (std::size_t i = 0; i < n; ++i) {
    double below = 0, same = 0;
    for (std::size_t j = 0; j < n; ++j) {
      below += std::abs(d[j]) < std::abs(d[i]);
      same += std::abs(d[j]) == std::abs(d[i]);
    }
    rank[i] = below + 0.5 * (same + 1);
  }
  double seen = 0, as_large = 0;
  for (std::size_t i = 0; i < n; ++i) seen += d[i] > 0 ? rank[i] : 0;
  for (unsigned signs = 0; signs < 1U << n; ++signs) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += (signs >> i & 1U) ? rank[i] : 0;
    as_large += sum >= seen - 1e-9;
  }
  return as_large / static_cast<double>(1U << n);
}

TEST(SignedRank, EqualsTheEnumerationOfAllSigns) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<double> d(3 + static_cast<std::size_t>(trial % 9));
    for (double& x : d) x = static_cast<double>(static_cast<int>(random() % 13) - 5) + 0.5;  // with ties
    EXPECT_NEAR(signed_rank_p_value(d), enumerated(d), 1e-12);
  }
}

TEST(SignedRank, ByHand) {
  // All of n positive: one pattern in 2^n. The smallest of four negative: sums of 10 and 9, two patterns of
  // sixteen.
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{1, 2, 3, 4, 5}), 1.0 / 32);
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{-1, 2, 3, 4}), 2.0 / 16);
  // Sizes count by their order alone, zeros not at all.
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{-1e-9, 0, 2, 1e3, 4e8}), 2.0 / 16);
  EXPECT_EQ(signed_rank_p_value(std::vector<double>{0, 0}), 1);
  EXPECT_EQ(signed_rank_p_value(std::vector<double>{-1, -2, -3}), 1);
  EXPECT_THROW(signed_rank_p_value(std::vector<double>{1, std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
}

TEST(SignedRank, NormalApproximationContinuesTheExactDistribution) {
  std::vector<double> exact, approximate;
  for (int i = 1; i <= 61; ++i) {
    const double d = i % 3 == 0 ? -i : i;
    if (i <= 60) exact.push_back(d);
    approximate.push_back(d);
  }
  // 61 is positive: one more rank on that side of a distribution whose sd is 137.
  const double p = signed_rank_p_value(exact), next = signed_rank_p_value(approximate);
  EXPECT_LT(next, p);
  EXPECT_GT(next, 0.4 * p);
}

}  // namespace
}  // namespace secular
