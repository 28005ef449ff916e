#include "measure/signal/circular_hyperbolic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "gaussian.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

TEST(CircularHyperbolic, RecoversEveryFamilyExactly) {
  const double rate = 100;
  const VectorXd t = testing_support::sampled_times(120, rate);
  VectorXd y = 1.5 * (12 * t).array().cos() - 0.5 * (12 * t).array().sin();  // circular
  CircularHyperbolicFit fit = circular_hyperbolic_decomposition(y, rate, 1);
  ASSERT_EQ(fit.circular.size(), 1U);
  EXPECT_NEAR(fit.circular[0].frequency, 12, 1e-9);
  EXPECT_NEAR(fit.circular[0].p, 1.5, 1e-9);
  EXPECT_NEAR(fit.circular[0].q, -0.5, 1e-9);
  y = 0.6 * (3 * t).array().cosh() - 0.4 * (3 * t).array().sinh();  // hyperbolic
  fit = circular_hyperbolic_decomposition(y, rate, 1);
  ASSERT_EQ(fit.hyperbolic.size(), 1U);
  EXPECT_NEAR(fit.hyperbolic[0].rate, 3, 1e-6);
  EXPECT_NEAR(fit.hyperbolic[0].a, 0.6, 1e-6);
  EXPECT_NEAR(fit.hyperbolic[0].b, -0.4, 1e-6);
  for (Eigen::Index l = 0; l < y.size(); ++l) y(l) *= l % 2 == 0 ? 1 : -1;  // at the Nyquist frequency
  fit = circular_hyperbolic_decomposition(y, rate, 1);
  ASSERT_EQ(fit.nyquist.size(), 1U);
  EXPECT_NEAR(fit.nyquist[0].rate, 3, 1e-6);
  EXPECT_NEAR(fit.nyquist[0].c, 0.6, 1e-6);
  y = (20 * t).array().cos() * (2 * t).array().cosh() +
      0.3 * (20 * t).array().sin() * (2 * t).array().sinh();  // product
  fit = circular_hyperbolic_decomposition(y, rate, 2);
  ASSERT_EQ(fit.products.size(), 1U);
  EXPECT_NEAR(fit.products[0].rate, 2, 1e-6);
  EXPECT_NEAR(fit.products[0].frequency, 20, 1e-6);
  EXPECT_NEAR(fit.products[0].e, 1, 1e-6);
  EXPECT_NEAR(fit.products[0].h, 0.3, 1e-6);
}

TEST(CircularHyperbolic, MixtureAndScaling) {
  const double rate = 50;
  const VectorXd t = testing_support::sampled_times(200, rate);
  const VectorXd y = (7 * t).array().cos() + 0.2 * (19 * t).array().sin() + 0.05 * (0.4 * t).array().cosh();
  const CircularHyperbolicFit fit = circular_hyperbolic_decomposition(y, rate, 3);
  EXPECT_EQ(fit.circular.size(), 2U);
  EXPECT_EQ(fit.hyperbolic.size(), 1U);
  EXPECT_NEAR(fit.correlation, 1, 1e-12);
  const CircularHyperbolicFit scaled = circular_hyperbolic_decomposition(1000 * y, rate, 3);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(scaled.circular[i].frequency, fit.circular[i].frequency, 1e-7);
}

TEST(CircularHyperbolic, CableExampleOfTheThesisInTheLimitOfSmallNoise) {
  // Table 4.4: kappa = 0.3, a = 0.6, b = -0.4, step 0.025. The record's length is not printed; with 400 samples the
  // estimate must approach the true value as noise goes down, with errors proportional to it at first order.
  testing_support::Gaussian noise(4);
  const VectorXd t = testing_support::sampled_times(400, 40);
  const VectorXd clean = 0.6 * (0.3 * t).array().cosh() - 0.4 * (0.3 * t).array().sinh();
  const VectorXd unit = noise.vector(400);
  std::vector<double> errors;
  for (const double sd : {1e-8, 1e-9}) {
    const CircularHyperbolicFit fit = circular_hyperbolic_decomposition(clean + sd * unit, 40, 1);
    ASSERT_EQ(fit.hyperbolic.size(), 1U);
    errors.push_back(std::abs(fit.hyperbolic[0].rate - 0.3));
    EXPECT_NEAR(fit.hyperbolic[0].a, 0.6, 1e5 * sd);
    EXPECT_NEAR(fit.hyperbolic[0].b, -0.4, 1e5 * sd);
  }
  EXPECT_LT(errors[1], 0.3 * errors[0]);
}

TEST(CircularHyperbolic, RefusesWhatItCannotDo) {
  EXPECT_THROW(circular_hyperbolic_decomposition(VectorXd::Ones(5), 1, 2), std::invalid_argument);
  EXPECT_THROW(circular_hyperbolic_decomposition(VectorXd::Ones(50), 1, 0), std::invalid_argument);
  VectorXd bad = VectorXd::Ones(50);
  bad(7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(circular_hyperbolic_decomposition(bad, 1, 2), std::invalid_argument);
}

}  // namespace
}  // namespace secular
