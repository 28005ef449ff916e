// What people know beside the circular-hyperbolic decomposition: exact truths of each.
#include "measure/signal/exponential_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "gaussian.hpp"
#include "measure/signal/model_order.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

TEST(SpectrumPeak, ExactForAPeriodicToneOnly) {
  const Index n = 256;
  const VectorXd t = testing_support::sampled_times(n, 64);
  const double bin = 2 * std::numbers::pi * 64 / 256;
  const VectorXd y = 0.7 * (40 * bin * t).array().cos() - 0.2 * (40 * bin * t).array().sin();
  const SpectrumPeak peak = spectrum_peak(y, 64, 40.3 * bin);
  EXPECT_NEAR(peak.frequency, 40 * bin, 1e-10);
  EXPECT_NEAR(peak.p, 0.7, 1e-12);
  EXPECT_NEAR(peak.q, -0.2, 1e-12);
  const VectorXd between = 0.7 * (40.5 * bin * t).array().cos();
  const SpectrumPeak leaked = spectrum_peak(between, 64, 40.5 * bin);
  EXPECT_NEAR(std::hypot(leaked.p, leaked.q), 0.7 * 2 / std::numbers::pi, 0.01);  // sinc(1/2)
}

TEST(OrderSingularValues, NoiseLiftsTheBiasedOnesAndAveragesOutOfTheOthers) {
  testing_support::Gaussian random(6);
  const VectorXd t = testing_support::sampled_times(20000, 10);
  const double sd = 0.1;
  const VectorXd y = VectorXd((8 * t).array().cos()) + sd * random.vector(20000);
  const OrderSingularValues values = order_singular_values(y, 8);
  // One tone of mean square 1/2 over 8 delays: two values of about 8/4, then noise.
  EXPECT_NEAR(values.biased(0) + values.biased(1), 4, 0.1);
  for (Index k = 2; k < 8; ++k) {
    EXPECT_NEAR(values.biased(k), sd * sd, 0.1 * sd * sd);
    EXPECT_LT(values.unbiased(k), 0.1 * sd * sd);
  }
}

}  // namespace
}  // namespace secular
