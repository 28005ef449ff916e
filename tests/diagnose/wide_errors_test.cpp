// How wide errors are, and how far segments count beside them: docs/inference.md (40).
#include "diagnose/evidence/wide_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace secular {
namespace {

using Eigen::Index;

constexpr Index sweep_samples = 2000;
constexpr double lowest_mode = 2 * std::numbers::pi * 10, spacing = 2.5e-3;  // 40 samples a turn, 50 turns

Segment driven_from(Index sample) {
  Segment s;
  s.sample_s = spacing;
  s.response = Eigen::MatrixXd::Constant(2, sweep_samples, 3);
  s.response.row(1) *= 4;
  s.noise_sd = Eigen::Vector2d(1, 2);
  s.excitation = Eigen::MatrixXd::Zero(1, 2 * sweep_samples - 1);
  s.excitation.rightCols(2 * (sweep_samples - sample) - 1).setOnes();
  return s;
}

Index counted(double share, Index driven_from_sample = 0) {
  return sweep_samples - beyond_horizon(driven_from(driven_from_sample), share, lowest_mode);
}

TEST(WideErrors, AreThatShareOfTheLoudestChannelBesideItsNoise) {
  const Segment s = driven_from(0);  // 3 and 6 times the noise
  EXPECT_NEAR(widening(s, 0.1), std::hypot(1, 0.6), 1e-12);
  EXPECT_EQ(widening(s, 0), 1);
}

TEST(WideErrors, FinerOnesReachFarther) {
  EXPECT_EQ(counted(0.1), 6 * 40);
  EXPECT_EQ(counted(0.04), 10 * 40);
  EXPECT_EQ(counted(0.01), 40 * 40);
  EXPECT_EQ(counted(1e-4), 40 * 40);  // no farther than (40) says
}

TEST(WideErrors, TurnsCountFromWhereSomethingDrives) {
  EXPECT_EQ(counted(0.1, 500), 500 + 6 * 40);
  EXPECT_EQ(counted(0.1, sweep_samples - 100), sweep_samples);
}

TEST(WideErrors, AFreeDecayCountsWhole) {
  Segment s = driven_from(0);
  s.excitation.resize(0, 0);
  EXPECT_EQ(beyond_horizon(s, 0.1, lowest_mode), 0);
}

}  // namespace
}  // namespace secular
