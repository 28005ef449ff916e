// Error bars of what follows from a rest position: right to first order, and called doubtful where that is not
// enough.
#include "jobs/identify/following_estimates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace secular {
namespace {

// k = w^2 - 3*a3*x^2 and g = w^2*x - 2*a3*x^3, which hold the model, and a load c of w alone.
std::vector<FollowingCoefficient> spring(const std::map<std::string, double>& at) {
  const double w = at.at("w"), a = at.at("a3"), x = at.at("x");
  return {{"k", w * w - 3 * a * x * x, {{"w", 2 * w}, {"a3", -3 * x * x}, {"x", -6 * a * x}}},
          {"g",
           w * w * x - 2 * a * x * x * x,
           {{"w", 2 * w * x}, {"a3", -2 * x * x * x}, {"x", w * w - 6 * a * x * x}}},
          {"c", 2 * w, {{"w", 2}}}};
}

// a3 to a share, and x with it so that a3*x is nearly known, as of decays.
std::vector<FollowingEstimate> with_error(double share, double correlation) {
  Estimate estimate;
  const double values[] = {32.1, 1e5, 0.01}, sds[] = {1e-3, share * 1e5, share * 0.01};
  for (int p = 0; p < 3; ++p) {
    EstimatedValue& value = estimate.parameters.emplace_back();
    value.name = p == 0 ? "w" : p == 1 ? "a3" : "x";
    value.value = values[p];
    value.sd = sds[p];
    value.identifiable = true;
  }
  estimate.covariance = Eigen::Vector3d(sds).array().square().matrix().asDiagonal();
  estimate.covariance(1, 2) = estimate.covariance(2, 1) = correlation * sds[1] * sds[2];
  return following_estimates(spring, estimate);
}

TEST(FollowingEstimates, AreDoubtfulWhereFirstOrderIsNotEnough) {
  for (const double correlation : {0.0, -0.95}) {
    const auto sharp = with_error(0.03, correlation), wide = with_error(0.6, correlation);
    ASSERT_EQ(sharp.size(), 3U);
    for (const FollowingEstimate& following : sharp) EXPECT_FALSE(following.doubtful) << following.name;
    // At a3*(1 - s), x*(1 + s), s = 0.6*sqrt(1.95/2), a3*x^2 is off its slope by 0.84 of its deviation; without
    // correlation by 0.36/0.6/sqrt(5).
    EXPECT_EQ(wide[0].doubtful, correlation < 0);
    EXPECT_EQ(wide[1].doubtful, correlation < 0) << "its error is along the same direction";
    EXPECT_EQ(wide[2].doubtful, false) << "w is not of that direction";
    // var(k) = (2 w sd_w)^2 + (3 a x^2 share)^2 (1 + 4 + 4 correlation).
    EXPECT_NEAR(sharp[0].sd, std::hypot(2 * 32.1e-3, 30 * 0.03 * std::sqrt(5 + 4 * correlation)), 1e-12);
    EXPECT_NEAR(wide[2].sd, 2e-3, 1e-15);
  }
}

}  // namespace
}  // namespace secular
