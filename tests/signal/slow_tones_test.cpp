// Tones of slowly changing amplitude in a window: exact where the amplitude is a polynomial, linear in the samples,
// and biased in the way its Taylor series says.
#include "measure/signal/slow_tones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "gaussian.hpp"
#include "measure/signal/tone_separation.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr double rate = 400, first = 31, second = 75;

// samples x 1 of 2 Re(B(tau) exp(i w tau)) at the window's times.
template <class Envelope>
MatrixXd samples_of(Index count, double frequency, const Envelope& envelope) {
  MatrixXd y(count, 1);
  for (Index i = 0; i < count; ++i) {
    const double t = (static_cast<double>(i) - 0.5 * static_cast<double>(count - 1)) / rate;
    y(i, 0) = 2 * (envelope(t) * std::exp(Complex(0, frequency * t))).real();
  }
  return y;
}

TEST(TonesOfSlowAmplitude, PolynomialAmplitudesAreExact) {
  const Complex b0(1, 0.5), b1(-0.7, 0.2), b2(0.9, -2), c0(0.1, -0.2), c1(0.3, 0.1);
  const auto fundamental = [&](double t) { return b0 + b1 * t + 0.5 * b2 * t * t; };
  MatrixXd y = samples_of(400, first, fundamental) + samples_of(400, second, [&](double t) { return c0 + c1 * t; });
  y.array() += 3;
  const SlowToneFit fit = fit_slow_tones(y, rate, {first, second}, 2, 1);
  EXPECT_NEAR(std::abs(fit.derivative[0](0, 0) - b0), 0, 1e-10);
  EXPECT_NEAR(std::abs(fit.derivative[1](0, 0) - b1), 0, 1e-9);
  EXPECT_NEAR(std::abs(fit.derivative[2](0, 0) - b2), 0, 1e-8);
  EXPECT_NEAR(std::abs(fit.derivative[0](1, 0) - c0), 0, 1e-10);
  EXPECT_NEAR(std::abs(fit.derivative[1](1, 0) - c1), 0, 1e-9);
  EXPECT_NEAR(fit.offset(0), 3, 1e-10);
  EXPECT_LT(fit.noise_sd(0), 1e-10);
}

// A decay exp(g tau): its third derivative g^3 makes the slope wrong by g^3 L^2/40 (least squares of a cubic on a
// straight line; samples many a window).
TEST(TonesOfSlowAmplitude, SlopeIsBiasedByTheSquareOfTheWindow) {
  const double g = -0.8;
  const auto error = [&](Index count) {
    const MatrixXd y = samples_of(count, first, [&](double t) { return Complex(std::exp(g * t)); });
    return fit_slow_tones(y, rate, {first}, 2, 0).derivative[1](0, 0) - g;
  };
  const double period = 2 * std::numbers::pi / first * rate;
  for (const double periods : {3.0, 6.0}) {
    const auto count = static_cast<Index>(std::lround(periods * period));
    const double length = static_cast<double>(count) / rate;
    EXPECT_NEAR(error(count).real(), g * g * g * length * length / 40, 0.1 * std::abs(error(count))) << periods;
  }
  const double ratio = std::abs(error(static_cast<Index>(std::lround(6 * period)))) /
                       std::abs(error(static_cast<Index>(std::lround(3 * period))));
  EXPECT_NEAR(ratio, 4, 0.4);
}

// Noise adds its own fit and nothing else: no bias, and standard deviations that its scatter confirms.
TEST(StatisticalTonesOfSlowAmplitude, NoiseAddsLinearlyAndAsItsStandardDeviationsSay) {
  const Index count = 90;
  const MatrixXd y = samples_of(count, first, [](double t) { return Complex(std::exp(-0.5 * t), 0.2 * t); });
  const SlowToneFit clean = fit_slow_tones(y, rate, {first, second}, 2, 1);
  testing_support::Gaussian gaussian(5);
  const double sd = 0.05;
  const int draws = 2000;
  double square[3] = {0, 0, 0};
  double expected[3] = {0, 0, 0};
  for (int draw = 0; draw < draws; ++draw) {
    const MatrixXd noise = sd * gaussian.vector(count);
    const SlowToneFit noisy = fit_slow_tones(y + noise, rate, {first, second}, 2, 1);
    const SlowToneFit alone = fit_slow_tones(noise, rate, {first, second}, 2, 1);
    for (std::size_t p = 0; p < 3; ++p) {
      const Complex added = noisy.derivative[p](0, 0) - clean.derivative[p](0, 0);
      EXPECT_NEAR(std::abs(added - alone.derivative[p](0, 0)), 0, 1e-8 * (1 + std::abs(noisy.derivative[p](0, 0))));
      square[p] += 0.5 * std::norm(added) / draws;
      expected[p] += noisy.sd[p](0, 0) * noisy.sd[p](0, 0) / draws;
    }
  }
  // Mean squares of 2*draws values: relative standard deviation sqrt(2/(2 draws)) = 0.022; four of them.
  for (int p = 0; p < 3; ++p) EXPECT_NEAR(square[p] / expected[p], 1, 4 * std::sqrt(1.0 / draws)) << p;
}

// What the fit multiplies samples with is the fit: of any samples.
TEST(TonesOfSlowAmplitude, WeightsAreTheFit) {
  const Index count = 90;
  const MatrixXd y = testing_support::Gaussian(5).vector(count);
  const SlowToneFit fit = fit_slow_tones(y, rate, {first, second}, 2, 1);
  const SlowToneWeights weights = slow_tone_weights(count, rate, {first, second}, 2, 1);
  for (std::size_t p = 0; p < 3; ++p)
    for (Index tone = 0; tone < 2; ++tone)
      EXPECT_NEAR(std::abs((weights.derivative[p].row(tone) * y).value() - fit.derivative[p](tone, 0)), 0,
                  1e-11 * fit.sd[p](tone, 0) / fit.sd[0](tone, 0))
          << p;
  EXPECT_NEAR((weights.offset * y).value(), fit.offset(0), 1e-12);
}

TEST(TonesOfSlowAmplitude, TooFewSamplesAreRefused) {
  EXPECT_THROW(fit_slow_tones(MatrixXd::Zero(7, 1), rate, {first}, 2, 0), std::invalid_argument);
}

// Variances of the amplitude's derivatives where another tone is so many bins away, or a constant, over those of a
// tone that is far from all; the largest.
double worse_by(double bins, int degree, bool from_constant) {
  const Index count = 2000;
  const double bin = 2 * std::numbers::pi * rate / static_cast<double>(count), far = 250 * bin;
  const auto variances = [&](const std::vector<double>& frequencies) {
    const SlowToneWeights weights = slow_tone_weights(count, rate, frequencies, degree, 0);
    Eigen::VectorXd result(degree + 1);
    for (int p = 0; p <= degree; ++p)
      result(p) = weights.derivative[static_cast<std::size_t>(p)].row(0).squaredNorm();
    return result;
  };
  const auto beside = from_constant ? std::vector<double>{bins * bin} : std::vector<double>{far, far + bins * bin};
  return variances(beside).cwiseQuotient(variances({far})).maxCoeff();
}

// docs/inference.md (47): as many bins as unknowns, for the degrees that are in use.
TEST(TonesOfSlowAmplitude, AreToldApartFromAsManyBinsOnAsTheyHaveUnknowns) {
  const auto expect = [](int degree, double bins, bool from_constant) {
    for (const double more : {0.0, 0.25, 0.5, 1.0, 2.0, 5.0})
      EXPECT_LT(worse_by(bins + more, degree, from_constant), 1.5) << degree << ", " << bins + more;
    EXPECT_GT(worse_by(bins - 1, degree, from_constant), 3) << degree;
  };
  for (const int degree : {1, 2}) expect(degree, bins_between(degree, degree), false);
  expect(2, bins_between(2, 0), true);
}

}  // namespace
}  // namespace secular
