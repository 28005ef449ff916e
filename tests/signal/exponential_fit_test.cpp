// What people know beside the circular-hyperbolic decomposition: exact truths of each.
#include "measure/signal/exponential_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "gaussian.hpp"
#include "measure/signal/arma.hpp"
#include "measure/signal/model_order.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd times(Index n, double rate) {
  return VectorXd::LinSpaced(n, 0, static_cast<double>(n - 1)) / rate;
}

double nearest_pole(const ExponentialFit& fit, std::complex<double> pole) {
  return (fit.poles.array() - pole).abs().minCoeff();
}

TEST(Prony, EightSamplesOfTwoDecayingTonesGiveTheirPoles) {
  const VectorXd t = times(8, 10);
  const VectorXd y = (-0.5 * t).array().exp() * (8 * t).array().cos() + 0.3 * (17 * t).array().sin();
  const ExponentialFit fit = prony(y, 10, 2);
  EXPECT_LT(nearest_pole(fit, {-0.5, 8}), 1e-9);
  EXPECT_LT(nearest_pole(fit, {0, -17}), 1e-9);
  EXPECT_LT((fit.reconstruct(8, 10) - y).norm(), 1e-10);
  EXPECT_THROW(prony(y.head(7), 10, 2), std::invalid_argument);
}

TEST(ComplexExponential, ExactWithoutNoiseAndEqualToPronyOnAsManySamples) {
  const VectorXd t = times(60, 10);
  Eigen::MatrixXd y(60, 2);
  y.col(0) = (-0.5 * t).array().exp() * (8 * t).array().cos() + 0.3 * (17 * t).array().sin();
  y.col(1) = 0.2 * (-0.5 * t).array().exp() * (8 * t).array().sin();
  const ExponentialFit fit = complex_exponential(y, 10, 2);
  EXPECT_LT(nearest_pole(fit, {-0.5, -8}), 1e-9);
  EXPECT_LT(nearest_pole(fit, {0, 17}), 1e-9);
  EXPECT_LT((fit.reconstruct(60, 10) - y).norm(), 1e-9);
}

TEST(Pisarenko, FrequenciesOfALongRecordOfTwoTones) {
  const VectorXd t = times(4000, 10);
  const VectorXd y = (8 * t).array().cos() + 0.5 * (17 * t).array().sin();
  const PisarenkoFit fit = pisarenko(y, 10, 2);
  ASSERT_EQ(fit.frequencies.size(), 2);
  EXPECT_NEAR(fit.frequencies(0), 8, 5e-3);  // the autocorrelation of a finite record is not that of a tone
  EXPECT_NEAR(fit.frequencies(1), 17, 5e-3);
}

TEST(SpectrumPeak, ExactForAPeriodicToneOnly) {
  const Index n = 256;
  const VectorXd t = times(n, 64);
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

TEST(Arma, RecoversALinearOscillatorAndItsZeros) {
  // v(i) + a1 v(i+1) + a2 v(i+2) = b0 u(i) + b1 u(i+1), run backwards in time so that alpha_0 = 1 is explicit.
  testing_support::Gaussian random(5);
  const Index n = 300;
  const VectorXd u = random.vector(n);
  VectorXd v = VectorXd::Zero(n);
  const double a1 = -1.6, a2 = 0.9, b0 = 0.3, b1 = -0.1;
  for (Index i = n - 3; i >= 0; --i) v(i) = -a1 * v(i + 1) - a2 * v(i + 2) + b0 * u(i) + b1 * u(i + 1);
  const ArmaFit fit = arma(u, v, 2, 1);
  EXPECT_NEAR(fit.alpha(1), a1, 1e-10);
  EXPECT_NEAR(fit.alpha(2), a2, 1e-10);
  EXPECT_NEAR(fit.beta(0), b0, 1e-10);
  EXPECT_NEAR(fit.beta(1), b1, 1e-10);
  EXPECT_LT(fit.residual, 1e-10);
}

TEST(OrderSingularValues, NoiseLiftsTheBiasedOnesAndAveragesOutOfTheOthers) {
  testing_support::Gaussian random(6);
  const VectorXd t = times(20000, 10);
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
