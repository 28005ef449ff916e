// Noise of the measured excitation that the structure does not feel: what it does to errors is known, and taken
// out.
#include "diagnose/evidence/driven_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/diagnose/driven_segment.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing_support::driven_segment;
using testing_support::Laboratory;
using testing_support::natural;

constexpr Index samples = 600;
constexpr double spacing_s = 2e-3, base = 3, response_noise = 0.02;

struct Driven {
  Segment segment;
  VectorXd state = Eigen::Vector2d(2e-3, 0.1);
};

// A stretch of a sweep through the resonance, its base read with noise of `base_noise`.
Driven sweep(const Laboratory& lab, const VectorXd& unknowns, double base_noise, std::uint64_t seed) {
  testing_support::Gaussian gaussian(seed);
  Driven d;
  const auto swept = [](double t) { return base * std::cos((0.98 * natural + 2 * t) * t); };
  d.segment = driven_segment(lab, unknowns, {samples, spacing_s, swept}, d.state, response_noise, gaussian);
  Segment& s = d.segment;
  s.excitation_noise_sd = VectorXd::Constant(1, base_noise);
  const VectorXd noise = base_noise * gaussian.vector(samples);
  for (Index i = 0; i < samples; ++i) s.excitation(0, 2 * i) += noise(i);
  for (Index i = 0; i + 1 < samples; ++i) s.excitation(0, 2 * i + 1) += (noise(i) + noise(i + 1)) / 2;
  return d;
}

double mean_square(const VectorXd& values) {
  return values.squaredNorm() / static_cast<double>(values.size());
}

TEST(DrivenNoise, WhatItDoesToErrorsIsWhitened) {
  const Laboratory lab;
  const SegmentModel model(lab.compiled, {}, lab.sensors, lab.faults);
  for (const double hardening : {0.0, 2e7})
    for (const double direct : {1.0, 0.1}) {
      const VectorXd unknowns = lab.unknowns({{"alpha3", hardening}, {"eta1", direct}});
      const double base_noise = 0.02 / direct;
      double raw = 0, white = 0;
      VectorXd lagged = VectorXd::Zero(20);
      constexpr int runs = 6;
      for (std::uint64_t seed = 1; seed <= runs; ++seed) {
        const Driven d = sweep(lab, unknowns, base_noise, seed);
        const SegmentTrial trial{d.segment, samples, unknowns, d.state};
        const VectorXd error = model.errors({trial}).front();
        const VectorXd rows = DrivenNoise(model, trial, {}).whitened(error);
        raw += mean_square(error) / runs;
        white += mean_square(rows) / runs;
        for (Index lag = 1; lag <= lagged.size(); ++lag)
          lagged(lag - 1) += rows.head(samples - lag).dot(rows.tail(samples - lag)) / (samples * runs);
      }
      const double sd = 1 / std::sqrt(static_cast<double>(samples * runs));
      EXPECT_GT(raw, 1.3) << hardening << " " << direct;  // else nothing is tested
      EXPECT_NEAR(white, 1, 5 * std::sqrt(2.0) * sd) << hardening << " " << direct;
      EXPECT_LT(lagged.cwiseAbs().maxCoeff(), 5 * sd) << hardening << " " << direct;
    }
}

// Damping by the cube of a velocity brings motions that begin apart together within a tenth of the stretch: what
// each sample's noise does is known all the same, and white where errors alone are not.
TEST(DrivenNoise, MotionsThatRunTogetherAreToldApart) {
  const Laboratory lab;
  const SegmentModel model(lab.compiled, {}, lab.sensors, lab.faults);
  const VectorXd unknowns = lab.unknowns({{"mu3", 2e4}, {"eta1", 1}});
  double raw = 0, white = 0;
  constexpr int runs = 4;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const Driven d = sweep(lab, unknowns, 0.04, seed);
    const SegmentTrial trial{d.segment, samples, unknowns, d.state};
    const DrivenNoise noise(model, trial, {});
    EXPECT_TRUE(noise.is_of_excitation()) << seed;
    const VectorXd error = model.errors({trial}).front();
    raw += mean_square(error) / runs;
    white += mean_square(noise.whitened(error)) / runs;
  }
  EXPECT_GT(raw, 1.3);  // else nothing is tested
  EXPECT_NEAR(white, 1, 5 * std::sqrt(2.0 / (samples * runs)));
}

// Innovations are of what came before: those of the first samples alone are the same, wherever these end among the
// parts about whose motion noise is linear.
TEST(DrivenNoise, WhatComesLaterDoesNotCount) {
  const Laboratory lab;
  const SegmentModel model(lab.compiled, {}, lab.sensors, lab.faults);
  const VectorXd unknowns = lab.unknowns({{"alpha3", 2e7}, {"eta1", 1}});
  const Driven d = sweep(lab, unknowns, 0.04, 1);
  const SegmentTrial whole{d.segment, samples, unknowns, d.state};
  const VectorXd rows = DrivenNoise(model, whole, {}).whitened(model.errors({whole}).front());
  for (const Index first : {34, 64, 66, 79, 81}) {
    Segment cut = d.segment;
    cut.excitation.conservativeResize(Eigen::NoChange, 2 * first - 1);
    cut.response.conservativeResize(Eigen::NoChange, first);
    const SegmentTrial begun{cut, first, unknowns, d.state};
    const VectorXd of_first = DrivenNoise(model, begun, {}).whitened(model.errors({begun}).front());
    EXPECT_LT((of_first - rows.head(first)).cwiseAbs().maxCoeff(), 3e-4) << first;
  }
}

// Where nearly all of an error is that motion, what the interpolation between samples does to noise is seen: a few
// hundredths.
TEST(DrivenNoise, TwentyTimesTheNoiseOfTheResponseIsTakenOut) {
  const Laboratory lab;
  const SegmentModel model(lab.compiled, {}, lab.sensors, lab.faults);
  const VectorXd unknowns = lab.unknowns({{"alpha3", 2e7}, {"eta1", 1}});
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Driven d = sweep(lab, unknowns, 20 * response_noise, seed);
    const SegmentTrial trial{d.segment, samples, unknowns, d.state};
    const VectorXd error = model.errors({trial}).front();
    EXPECT_GT(mean_square(error), 400) << seed;
    EXPECT_NEAR(mean_square(DrivenNoise(model, trial, {}).whitened(error)), 1, 0.25) << seed;  // 4 sd of 600
  }
}

TEST(DrivenNoise, WithoutNoiseOfTheExcitationErrorsStayAsTheyAre) {
  const Laboratory lab;
  const SegmentModel model(lab.compiled, {}, lab.sensors, lab.faults);
  const VectorXd unknowns = lab.unknowns({});
  Driven d = sweep(lab, unknowns, 0, 3);
  const VectorXd error = testing_support::Gaussian(4).vector(samples);
  EXPECT_EQ(DrivenNoise(model, {d.segment, samples, unknowns, d.state}, {}).whitened(error), error);
  d.segment.excitation_noise_sd.resize(0);
  EXPECT_EQ(DrivenNoise(model, {d.segment, samples, unknowns, d.state}, {}).whitened(error), error);
}

}  // namespace
}  // namespace secular
