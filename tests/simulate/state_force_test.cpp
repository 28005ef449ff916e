// Forces that the language of models cannot say.
#include "motion/balance/state_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

RowVectorXd harmonic(double amplitude, double phase, Index points) {
  RowVectorXd x(points);
  for (Index i = 0; i < points; ++i)
    x(i) =
        amplitude * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points) + phase);
  return x;
}

// Work that a signal does on a closed path: sum of signal times change of path, by the midpoints.
double work(const RowVectorXd& signal, const RowVectorXd& path) {
  double sum = 0;
  for (Index i = 0; i < path.size(); ++i) {
    const Index next = (i + 1) % path.size();
    sum += 0.5 * (signal(i) + signal(next)) * (path(next) - path(i));
  }
  return sum;
}

double value_of(const StateForce& force, double displacement, double velocity, double exponent) {
  return force.law.value(displacement, velocity, exponent, force.scale);
}

TEST(StateForce, PowersAreInTheScaleOfTheForceAndOddButForOneSidedDamping) {
  StateForce force;
  force.scale = 2;
  force.law = force_law::displacement_power;
  EXPECT_DOUBLE_EQ(value_of(force, 3, 7, 3), 27.0 / 4);
  EXPECT_DOUBLE_EQ(value_of(force, -3, 7, 3), -27.0 / 4);
  EXPECT_DOUBLE_EQ(value_of(force, 3, 7, 1), 3);
  EXPECT_EQ(value_of(force, 0, 7, 0), 0);
  force.law = force_law::velocity_power;
  EXPECT_DOUBLE_EQ(value_of(force, 3, -4, 2), -8);
  EXPECT_DOUBLE_EQ(value_of(force, 3, -4, 0), -2);
  force.law = force_law::loss_power;
  EXPECT_DOUBLE_EQ(value_of(force, -4, -5, 2), -20);
  force.law = force_law::speed_power;
  EXPECT_DOUBLE_EQ(value_of(force, 3, -4, 2), 8);
  EXPECT_DOUBLE_EQ(value_of(force, 3, 4, 1), 4);
}

// Slips spread evenly between 0 and `slip`: a swing of amplitude A < slip loses the integral of 4 f (A - f) df/slip
// over f from 0 to A, 2 A^3/(3 slip), for a stiffness of one (Iwan 1966); eight sliders come within 2 % of it where
// more than half of them slip.
TEST(StateForce, MicroSlipLosesTheCubeOfTheAmplitude) {
  StateForce force;
  force.law = force_law::spread_slider;
  const double slip = 0.5;
  for (const double amplitude : {0.3, 0.4, 0.5}) {
    const RowVectorXd path = harmonic(amplitude, 0.2, 4000);
    const RowVectorXd signal =
        signal_over_turn(force, path, MatrixXd::Zero(1, path.size()), slip) / force.per_stretch(slip);
    const double expected = 2 * std::pow(amplitude, 3) / (3 * slip);
    EXPECT_NEAR(work(signal, path), expected, 0.02 * expected) << amplitude;
  }
}

// dz/dx = 1 - z|z|/slip^2 forwards (and 1 + z|z|/slip^2 backwards), by the classical Runge-Kutta method in small
// steps.
double integrated(double z, double way, double slip) {
  constexpr int steps = 2000;
  const double h = way / steps, sign = way < 0 ? -1 : 1;
  const auto slope = [&](double y) { return 1 - sign * y * std::abs(y) / (slip * slip); };
  for (int i = 0; i < steps; ++i) {
    const double k1 = slope(z), k2 = slope(z + 0.5 * h * k1), k3 = slope(z + 0.5 * h * k2), k4 = slope(z + h * k3);
    z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return z;
}

TEST(StateForce, SmoothSliderFollowsItsDifferentialEquation) {
  for (const double slip : {0.3, 1.0})
    for (const double share : {-0.9, -0.2, 0.0, 0.5, 0.95})
      for (const double way : {-2.0, -0.4, -0.05, 0.1, 0.6, 3.0}) {
        const double z = share * slip;
        EXPECT_NEAR((Slider{slip, true}.advanced(z, way * slip)), integrated(z, way * slip, slip), 1e-6 * slip)
            << slip << " " << share << " " << way;
      }
}

TEST(StateForce, SmoothSliderInStepsIsTheSameAsAtOnce) {
  const Slider slider{0.7, true};
  double z = -0.5;
  for (int i = 0; i < 10; ++i) z = slider.advanced(z, 0.13);
  EXPECT_NEAR(z, slider.advanced(-0.5, 1.3), 1e-14);
}

// Even where it hardly gives way, so that a turn changes its stretch by little more than where it began.
TEST(StateForce, SmoothSliderClosesWithItsPath) {
  for (const double amplitude : {0.05, 0.3, 1.0, 5.0}) {
    const RowVectorXd path = harmonic(amplitude, 0.4, 255);
    const Slider slider{1, true};
    const RowVectorXd stretch = slider_stretch(path, slider);
    EXPECT_NEAR(slider.advanced(stretch(254), path(0) - path(254)), stretch(0), 1e-9) << amplitude;
    // Half a turn on it is the opposite: 255 points lie between each other's opposites.
    EXPECT_NEAR(stretch.mean(), 0, 2e-3 * amplitude) << amplitude;
  }
}

TEST(StateForce, SlidersAreSpringsBelowTheirSlipAndOneForceAbove) {
  StateForce force;
  force.law = force_law::spread_slider;
  const RowVectorXd small = harmonic(0.03, 0, 400), large = harmonic(40, 0, 4000);
  const MatrixXd rest = MatrixXd::Zero(1, 4000);
  // The smallest slip is a sixteenth of the largest.
  const RowVectorXd elastic = signal_over_turn(force, small, rest.leftCols(400), 0.5) / force.per_stretch(0.5);
  EXPECT_LT(((elastic - small).array() - (elastic - small)(0)).abs().maxCoeff(), 1e-12);
  EXPECT_NEAR(signal_over_turn(force, large, rest, 0.5).maxCoeff(), 1, 1e-12);
  force.law = force_law::slider;
  EXPECT_NEAR(signal_over_turn(force, large, rest, 0.5).maxCoeff(), 1, 1e-12);
  // Of a slip the size counts alone, and the force is in the scale that is usual.
  force.scale = 3;
  EXPECT_NEAR(signal_over_turn(force, large, rest, -0.5).maxCoeff(), 3, 1e-12);
}

}  // namespace
}  // namespace secular
