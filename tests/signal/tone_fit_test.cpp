#include "measure/signal/tone_fit.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "gaussian.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd complex_tone(Eigen::Index n, double rate, Complex b, Complex s) {
  VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double tau = (static_cast<double>(i) - 0.5 * static_cast<double>(n - 1)) / rate;
    y(i) = 2 * (b * std::exp(s * tau)).real();
  }
  return y;
}

TEST(ToneFit, RecoversFrequencyGrowthAndHarmonicsWithoutNoise) {
  const Complex b(0.3, -0.4), s(-0.2, 40), third(0.01, 0.02);
  MatrixXd y(600, 2);
  y.col(0) = complex_tone(600, 256, b, s) + complex_tone(600, 256, third, 3.0 * s);
  y.col(1) = complex_tone(600, 256, 2.0 * b * Complex(0, 1), s);
  y.col(0).array() += 0.7;
  ToneOptions options;
  options.harmonics = {1, 3};
  options.fit_growth = true;
  const ToneFit fit = fit_harmonic_tone(y, 256, 40.3, options);
  EXPECT_EQ(fit.ending, SolverEnding::converged);
  EXPECT_NEAR(fit.frequency, 40, 1e-8);
  EXPECT_NEAR(fit.growth, -0.2, 1e-8);
  EXPECT_LT(std::abs(fit.amplitude(0, 0) - b), 1e-9);
  EXPECT_LT(std::abs(fit.amplitude(1, 0) - third), 1e-9);
  EXPECT_LT(std::abs(fit.amplitude(0, 1) - 2.0 * b * Complex(0, 1)), 1e-9);
  EXPECT_NEAR(fit.offset(0), 0.7, 1e-9);
}

TEST(ToneFit, InvariantUnderScalingOfChannelsAndTime) {
  testing_support::Gaussian noise(1);
  const VectorXd y = complex_tone(400, 100, {1, 0.5}, {0, 30}) + 0.01 * noise.vector(400);
  const ToneFit fit = fit_harmonic_tone(y, 100, 30.1, {});
  const ToneFit louder = fit_harmonic_tone(1e6 * y, 100, 30.1, {});
  EXPECT_NEAR(louder.frequency, fit.frequency, 1e-9);
  const ToneFit faster = fit_harmonic_tone(y, 1e5, 30.1e3, {});
  EXPECT_NEAR(faster.frequency, 1e3 * fit.frequency, 1e-5);
}

TEST(ToneFitStatistical, VarianceAtTheCramerRaoBoundAndHonestErrorBars) {
  // Bound for the frequency of one tone with unknown amplitude and phase: var >= 6 sd^2 / (4|B|^2 ... ) in the
  // centred form sd^2 / (sum tau^2 (2|B|)^2 / 2).
  testing_support::Gaussian noise(2);
  const Complex b(0.6, 0.8);
  const double rate = 256, omega = 77.85, sd = 0.2;
  constexpr Eigen::Index n = 1024;
  const VectorXd clean = complex_tone(n, rate, b, {0, omega});
  double moment = 0;
  for (Eigen::Index i = 0; i < n; ++i) moment += std::pow((static_cast<double>(i) - 0.5 * (n - 1)) / rate, 2);
  const double bound = sd * sd / (moment * 2 * std::norm(b));
  constexpr int draws = 600;
  double square = 0, sum = 0;
  int covered = 0;
  ToneOptions options;
  options.offset = false;
  for (int d = 0; d < draws; ++d) {
    const ToneFit fit = fit_harmonic_tone(clean + sd * noise.vector(n), rate, omega + 0.1, options);
    const double error = fit.frequency - omega;
    square += error * error;
    sum += error;
    covered += std::abs(error) < 1.959964 * fit.frequency_sd;
  }
  const boost::math::chi_squared law(draws);
  EXPECT_GT(square / bound, boost::math::quantile(law, 0.0005));
  EXPECT_LT(square / bound, boost::math::quantile(law, 0.9995));
  EXPECT_LT(std::abs(sum / draws), 3.5 * std::sqrt(bound / draws));
  const double expected = 0.95 * draws, spread = std::sqrt(draws * 0.95 * 0.05);
  EXPECT_NEAR(covered, expected, 3.5 * spread);
}

TEST(KnownFrequency, ExactWithoutNoiseAndUnbiasedErrorBars) {
  const Complex b(0.3, -0.2), c(-0.1, 0.05);
  const VectorXd y = complex_tone(512, 256, b, {0, 40}) + complex_tone(512, 256, c, {0, 80});
  const double frequencies[] = {40, 80};
  const KnownFrequencyFit fit = known_frequency_components(y, 256, frequencies, true);
  EXPECT_LT(std::abs(fit.amplitude(0, 0) - b), 1e-12);
  EXPECT_LT(std::abs(fit.amplitude(1, 0) - c), 1e-12);
  testing_support::Gaussian noise(3);
  double square = 0;
  constexpr int draws = 400;
  for (int d = 0; d < draws; ++d) {
    const KnownFrequencyFit noisy = known_frequency_components(y + 0.1 * noise.vector(512), 256, frequencies, true);
    square += std::norm((noisy.amplitude(0, 0) - b) / noisy.amplitude_sd(0, 0));
  }
  const boost::math::chi_squared law(2 * draws);
  EXPECT_GT(square, boost::math::quantile(law, 0.0005));
  EXPECT_LT(square, boost::math::quantile(law, 0.9995));
}

}  // namespace
}  // namespace secular
