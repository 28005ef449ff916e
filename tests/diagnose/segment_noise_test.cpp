// What segments repeat to: docs/inference.md (29).
#include "diagnose/evidence/segment_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "diagnose/evidence/noise_of_decays.hpp"
#include "tests/diagnose/frozen_decays.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing_support::Gaussian;
using testing_support::quiet_segments;

constexpr Index stretch_length = 96;
constexpr std::size_t stretches = 40;
const VectorXd mode_frequency = VectorXd::Constant(1, 500);

std::vector<LeftOfSegment> left_of_noise(const std::vector<FrozenSegment>& segments,
                                         const std::function<VectorXd(std::size_t)>& noise) {
  std::vector<VectorXd> errors;
  for (std::size_t i = 0; i < segments.size(); ++i) errors.push_back(noise(i));
  return left_of_segments(segments, errors);
}

// x_i = 0.9 x_(i-1) + e_i.
VectorXd coloured_stretch(Gaussian& gaussian) {
  VectorXd values = gaussian.vector(stretch_length);
  values(0) /= std::sqrt(1 - 0.81);
  for (Index i = 1; i < stretch_length; ++i) values(i) += 0.9 * values(i - 1);
  return values;
}

// Of what noise leaves, by the degrees of freedom that are left.
double mean_square_of_rows(const std::vector<FrozenSegment>& segments, const std::vector<LeftOfSegment>& left,
                           const std::vector<SegmentNoise>& noise) {
  double sum = 0, freedom = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    VectorXd rest(stretch_length);
    noise[i].whiten(left[i].rest, rest);
    sum += rest.squaredNorm();
    freedom += static_cast<double>(stretch_length - segments[i].directions.count());
  }
  return sum / freedom;
}

TEST(SegmentNoise, RowsOfWhiteNoiseHaveUnitVariance) {
  for (const double sd : {0.2, 1.0, 5.0}) {
    Gaussian gaussian(3);
    const std::vector<FrozenSegment> segments = quiet_segments(stretch_length, stretches, stretches, gaussian);
    const auto left =
        left_of_noise(segments, [&](std::size_t) -> VectorXd { return sd * gaussian.vector(stretch_length); });
    const std::vector<SegmentNoise> noise = noise_of_segments(segments, left, mode_frequency, {});
    ASSERT_EQ(noise.size(), stretches);
    EXPECT_EQ(noise.front().coloured, nullptr);  // of one decay
    EXPECT_NEAR(mean_square_of_rows(segments, left, noise), 1, 0.1) << sd;
    double changes = 0;
    for (std::size_t i = 0; i < stretches; ++i)
      changes += left[i].changes.cwiseQuotient(noise[i].change_sd).squaredNorm() / (2.0 * stretches);
    EXPECT_NEAR(changes, 1, 0.4) << sd;
    EXPECT_EQ(noise.front().disturbance, 0);
  }
}

TEST(SegmentNoise, RowsOfColouredNoiseOfTwoDecaysHaveUnitVariance) {
  Gaussian gaussian(5);
  const std::vector<FrozenSegment> segments = quiet_segments(stretch_length, stretches, stretches / 2, gaussian);
  const auto left = left_of_noise(segments, [&](std::size_t) { return coloured_stretch(gaussian); });
  const std::vector<SegmentNoise> noise = noise_of_segments(segments, left, mode_frequency, {});
  ASSERT_NE(noise.front().coloured, nullptr);
  EXPECT_EQ(noise.front().coloured, noise.back().coloured);
  EXPECT_NEAR(mean_square_of_rows(segments, left, noise), 1, 0.15);
  EXPECT_EQ(noise.front().white_sd(), noise.front().coloured->least);
}

TEST(SegmentNoise, OneDecayAloneTellsNoColour) {
  Gaussian gaussian(5);
  const std::vector<FrozenSegment> segments = quiet_segments(stretch_length, stretches, stretches, gaussian);
  const auto left = left_of_noise(segments, [&](std::size_t) { return coloured_stretch(gaussian); });
  EXPECT_EQ(noise_of_decays(segments, left, mode_frequency), nullptr);
}

TEST(SegmentNoise, ColouredNoiseAlongAColumnIsWhatItsCosinesMake) {
  const NoiseInCosines noise{cosines(stretch_length), VectorXd::LinSpaced(stretch_length, 3, 1), 1};
  EXPECT_NEAR(sd_along(noise, noise.cosines.row(7).transpose())(0), noise.sd(7, 0), 1e-12);
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(stretch_length, stretch_length);
  EXPECT_NEAR(sd_along(noise, all).squaredNorm(), noise.sd.squaredNorm(), 1e-9);
}

// What a model lacks is large in most segments, by a smooth law: the quiet quarter tells the noise, and nothing is
// disturbed.
TEST(SegmentNoise, WhatFollowsTheAmplitudeIsNoNoise) {
  Gaussian gaussian(7);
  const std::vector<FrozenSegment> segments = quiet_segments(stretch_length, stretches, stretches, gaussian);
  const auto left = left_of_noise(segments, [&](std::size_t i) -> VectorXd {
    VectorXd error = gaussian.vector(stretch_length);
    for (Index k = 0; k < stretch_length; ++k)
      error(k) += 30 * std::exp(-0.25 * static_cast<double>(i)) * std::sin(0.3 * static_cast<double>(k));
    return error;
  });
  const std::vector<SegmentNoise> noise = noise_of_segments(segments, left, mode_frequency, {});
  EXPECT_NEAR(noise.front().rest_sd, 1, 0.15);
  EXPECT_EQ(noise.front().disturbance, 0);
}

// Segments that come and go by no law: each counts for no more than it holds.
TEST(SegmentNoise, ADisturbedRecordSaysWhatEachSegmentHolds) {
  Gaussian gaussian(9);
  const std::vector<FrozenSegment> segments = quiet_segments(stretch_length, stretches, stretches, gaussian);
  const auto left = left_of_noise(
      segments, [&](std::size_t i) -> VectorXd { return (i % 3 == 0 ? 8 : 1) * gaussian.vector(stretch_length); });
  const std::vector<SegmentNoise> noise = noise_of_segments(segments, left, mode_frequency, {});
  for (std::size_t i = 0; i < stretches; ++i) {
    EXPECT_GT(noise[i].disturbance, 0);
    VectorXd rest(stretch_length);
    noise[i].whiten(left[i].rest, rest);
    const double freedom = static_cast<double>(stretch_length - segments[i].directions.count());
    EXPECT_NEAR(rest.norm() / noise[i].disturbance, std::sqrt(freedom), 1e-6);
  }
}

// The repeatability of the first rows stays the largest; that of the others is what it is now.
TEST(SegmentNoise, OfTheFirstRowsIsTheLargestSinceErrorsWereWide) {
  Gaussian gaussian(11);
  const std::vector<FrozenSegment> segments = quiet_segments(stretch_length, stretches, stretches, gaussian);
  const auto loud =
      left_of_noise(segments, [&](std::size_t) -> VectorXd { return 4 * gaussian.vector(stretch_length); });
  const auto quiet = left_of_noise(segments, [&](std::size_t) { return gaussian.vector(stretch_length); });
  const std::vector<SegmentNoise> before = noise_of_segments(segments, loud, mode_frequency, {}),
                                  after = noise_of_segments(segments, quiet, mode_frequency, before),
                                  alone = noise_of_segments(segments, quiet, mode_frequency, {});
  EXPECT_EQ(after.front().change_sd, before.front().change_sd);
  EXPECT_GT((before.front().change_sd - alone.front().change_sd).minCoeff(), 0);
  EXPECT_EQ(after.front().rest_sd, alone.front().rest_sd);
}

}  // namespace
}  // namespace secular
