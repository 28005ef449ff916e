// What a fit of damped exponentials leaves: no more than noise where frequency and damping are constant, more where
// they change with amplitude or where two modes were taken for one.
#include "measure/modal/fit_residual.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "numerics/distribution.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr double rate_of_samples = 128, turn_per_hertz = 2 * std::numbers::pi;
const Complex slow_pole(-0.8, 11.3 * turn_per_hertz), fast_pole(-1.1, 27 * turn_per_hertz);

// Two records of two channels; `motion(t, a)`: of the first mode from amplitude a.
MatrixXd two_records(testing_support::Gaussian& gaussian, const std::function<Complex(double, double)>& motion) {
  MatrixXd samples(512, 4);
  for (Index i = 0; i < samples.rows(); ++i) {
    const double t = static_cast<double>(i) / rate_of_samples;
    const Complex other = std::exp(fast_pole * t) * Complex(0.4, 0.3);
    for (Index s = 0; s < 4; ++s) {
      const double a = s < 2 ? 1 : 0.4, shape = s % 2 == 0 ? 0.6 : -0.9;
      samples(i, s) = (shape * motion(t, a) + other * (1.0 + static_cast<double>(s))).real() + 0.02 * gaussian();
    }
  }
  return samples;
}

struct Probabilities {
  double constant_law, one_exponential;
};

Probabilities left_by_two_poles(const MatrixXd& samples) {
  const PoleFit fit = refine_poles(samples, rate_of_samples, Eigen::Vector2cd(slow_pole, fast_pole));
  const FitResidual residual(samples, rate_of_samples, fit);
  double one_exponential = 1;
  for (const ExplainedSquares& squares : residual.along_powers(0))
    one_exponential = std::min(one_exponential, squares.probability());
  return {residual.along_laws(0, {1, 0.4}, 2).probability(), one_exponential};
}

TEST(StatisticalFitResidual, ConstantMotionsLeaveNoise) {
  testing_support::Gaussian gaussian(41);
  constexpr int runs = 200;
  int low = 0, high = 0, several = 0;
  for (int run = 0; run < runs; ++run) {
    const Probabilities p =
        left_by_two_poles(two_records(gaussian, [](double t, double a) { return a * std::exp(slow_pole * t); }));
    low += p.constant_law < 0.1;
    high += p.constant_law > 0.9;
    several += p.one_exponential < 0.1;
  }
  EXPECT_GT(binomial_upper_tail(low, runs, 0.1), 1e-3) << low;
  EXPECT_GT(binomial_upper_tail(high, runs, 0.1), 1e-3) << high;
  EXPECT_GT(binomial_upper_tail(several, runs, 0.1), 1e-3) << several;
}

TEST(FitResidual, ChangeWithAmplitudeIsTold) {
  testing_support::Gaussian gaussian(43);
  // Frequency lower by 0.3 rad/s at amplitude one: the phase is the integral of the amplitude.
  const Probabilities p = left_by_two_poles(two_records(gaussian, [](double t, double a) {
    const double turned = -0.3 * a * std::expm1(slow_pole.real() * t) / slow_pole.real();
    return a * std::exp(slow_pole * t + Complex(0, turned));
  }));
  EXPECT_LT(p.constant_law, 1e-6);
}

TEST(FitResidual, TwoModesOneBandwidthApartAreNoExponential) {
  testing_support::Gaussian gaussian(47);
  const Complex beside = slow_pole + Complex(0, 2 * slow_pole.real());
  const Probabilities p = left_by_two_poles(two_records(
      gaussian, [&](double t, double a) { return a * (std::exp(slow_pole * t) + 0.7 * std::exp(beside * t)); }));
  EXPECT_LT(p.one_exponential, 1e-6);
}

}  // namespace
}  // namespace secular
