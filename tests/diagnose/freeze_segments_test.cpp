// What is taken of segments where errors are taken, one stage after the other.
#include "diagnose/evidence/freeze_segments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "diagnose/evidence/frozen_directions.hpp"
#include "diagnose/evidence/frozen_states.hpp"
#include "diagnose/evidence/left_in_channels.hpp"
#include "diagnose/evidence/taken_off.hpp"
#include "tests/diagnose/driven_segment.hpp"
#include "tests/diagnose/frozen_decays.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing_support::as_measured;
using testing_support::decay;
using testing_support::frozen_decay;
using testing_support::Laboratory;
using testing_support::natural;
using testing_support::segment_model;

TEST(FreezeSegments, IsRepeatedExactly) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({{"alpha3", -2e7}});
  const SegmentModel model = segment_model(lab);
  std::vector<FrozenSegment> first = frozen_decay(lab, truth, 7), second = first;
  freeze_segments(model, second, truth, 0, 1);
  freeze_segments(model, second, truth, 0, 1);
  std::vector<FrozenSegment> third = second;
  freeze_segments(model, third, truth, 0, 2);  // each segment goes as it would alone
  for (std::size_t i = 0; i < first.size(); ++i) {
    // A search that begins where the last one ended goes on by less than its tolerance.
    EXPECT_LT((second[i].state - first[i].state).norm(), 1e-5 * first[i].state.norm());
    EXPECT_EQ(third[i].segment.response, second[i].segment.response);
    EXPECT_LT((third[i].state - second[i].state).norm(), 1e-9 * second[i].state.norm());
  }
  std::vector<FrozenSegment> fourth = as_measured(decay(lab, truth, 7));
  freeze_segments(model, fourth, truth, 0, 2);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(fourth[i].state, first[i].state);
    EXPECT_EQ(fourth[i].directions.of_state, first[i].directions.of_state);
    EXPECT_EQ(fourth[i].directions.of_change, first[i].directions.of_change);
  }
}

TEST(FreezeSegments, NoStepOfTheStateLeavesLess) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({{"alpha3", -2e7}});
  const SegmentModel model = segment_model(lab);
  for (FrozenSegment& f : frozen_decay(lab, truth, 7)) {
    const double least = seen_errors(model, std::span(&f, 1), truth).front().squaredNorm();
    const VectorXd best = f.state;
    for (Index k = 0; k < best.size(); ++k)
      for (const double side : {1e-3, -1e-3}) {
        f.state = best;
        f.state(k) += side * best.cwiseAbs().maxCoeff();
        EXPECT_GT(seen_errors(model, std::span(&f, 1), truth).front().squaredNorm(), least);
      }
  }
}

// To first order nothing is left of a state that is a little off, nor, beside the first rows, of a damping.
TEST(FreezeSegments, DirectionsHoldWhatStateAndDampingDo) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  const SegmentModel model = segment_model(lab);
  VectorXd damped = truth;
  damped(static_cast<Index>(lab.symbol("mu1"))) *= 1.001;
  for (FrozenSegment& f : frozen_decay(lab, truth, 7)) {
    const auto errors = [&](const VectorXd& at) { return seen_errors(model, std::span(&f, 1), at).front(); };
    const VectorXd still = errors(truth), by_damping = errors(damped) - still;
    f.state *= 1.001;
    const VectorXd by_state = errors(truth) - still;
    const auto& [of_state, of_change, foreign] = f.directions;
    EXPECT_LT((by_state - of_state * (of_state.transpose() * by_state)).norm(), 1e-4 * by_state.norm());
    VectorXd left = by_damping - of_state * (of_state.transpose() * by_damping);
    left -= of_change * (of_change.transpose() * left);
    EXPECT_LT(left.norm(), 1e-3 * by_damping.norm());
    EXPECT_GT((of_change.transpose() * by_damping).norm(), 0.1 * by_damping.norm());
  }
}

// A tone in the readings comes off, and the state is that of the motion beneath it.
TEST(FreezeSegments, AToneComesOffTheReadings) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  const SegmentModel model = segment_model(lab);
  const std::vector<FrozenSegment> clean = frozen_decay(lab, truth, 7);
  std::vector<Segment> segments = decay(lab, truth, 7);
  const double frequency = 2.3 * natural, size = 50 * segments.front().noise_sd(0);
  for (Segment& s : segments) {
    s.tones = {{0, frequency, 0}};
    for (Index i = 0; i < s.response.cols(); ++i)
      s.response(0, i) += size * std::cos(frequency * s.sample_s * static_cast<double>(i) + 0.7);
  }
  std::vector<FrozenSegment> toned = as_measured(segments);
  freeze_segments(model, toned, truth, 1e-2, 1);
  for (const FrozenSegment& f : toned) EXPECT_EQ(f.held, 0);  // small beside wide errors
  freeze_segments(model, toned, truth, 0, 1);
  freeze_segments(model, toned, truth, 0, 1);
  for (std::size_t i = 0; i < toned.size(); ++i) {
    const FrozenSegment& f = toned[i];
    EXPECT_EQ(f.held, 4);
    EXPECT_EQ(f.directions.foreign, 4);
    // Four amplitudes of noise, and what they share with the state.
    const double noise = f.segment.noise_sd(0);
    EXPECT_LT((f.segment.response - clean[i].measured.response).norm(), 6 * noise);
    EXPECT_LT((f.segment.response + f.taken_off - f.measured.response).norm(), 1e-12 * f.measured.response.norm());
    FrozenSegment again = f;
    again.restore();
    EXPECT_LT((again.segment.response - f.segment.response).norm(), 1e-12 * f.measured.response.norm());
  }
  // What is left holds the tone, the noise beside it does not.
  for (const LeftInChannel& left : left_in_channels(model, toned, truth)) {
    const auto rms = [](const std::vector<double>& values) {
      return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size())).norm() /
             std::sqrt(static_cast<double>(values.size()));
    };
    EXPECT_EQ(left.rest.size(), left.reading.size());
    EXPECT_GT(left.rms, 0.5 * size / std::numbers::sqrt2);
    EXPECT_NEAR(rms(left.noise), segments.front().noise_sd(0), 0.2 * segments.front().noise_sd(0));
  }
}

// Samples beyond the horizon do not count, and neither the state nor what is left knows of them.
TEST(FreezeSegments, NothingKnowsOfSamplesBeyondTheHorizon) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({{"eta1", 1}});
  const SegmentModel model = segment_model(lab);
  testing_support::Gaussian gaussian(3);
  const auto base = [](double t) { return 3 * std::cos(0.98 * natural * t); };
  Segment s =
      testing_support::driven_segment(lab, truth, {1000, 2e-3, base}, Eigen::Vector2d(2e-3, 0.1), 0.02, gaussian);
  std::vector<FrozenSegment> true_end = as_measured({s});
  freeze_segments(model, true_end, truth, 1e-2, 1);
  const Index horizon = true_end.front().horizon();
  ASSERT_LT(horizon, 1000);
  ASSERT_GT(horizon, 100);
  EXPECT_EQ(static_cast<Index>(true_end.front().silent.size()), 1000 - horizon);
  EXPECT_TRUE(seen_errors(model, true_end, truth).front().tail(1000 - horizon).isZero(0));
  s.response.rightCols(1000 - horizon).array() *= -0.5;  // of no other largest value
  std::vector<FrozenSegment> other_end = as_measured({s});
  freeze_segments(model, other_end, truth, 1e-2, 1);
  EXPECT_EQ(other_end.front().horizon(), horizon);
  EXPECT_LT((other_end.front().state - true_end.front().state).norm(), 1e-3 * true_end.front().state.norm());
}

// The likeliest excitation: errors stay what they were, and its noise is less than it was read with.
TEST(FreezeSegments, NoiseComesOffTheExcitationAndErrorsStay) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({{"eta1", 1}});
  const SegmentModel model = segment_model(lab);
  testing_support::Gaussian gaussian(5);
  constexpr Index samples = 600;
  const auto base = [](double t) { return 3 * std::cos((0.98 * natural + 2 * t) * t); };
  Segment s = testing_support::driven_segment(lab, truth, {samples, 2e-3, base}, Eigen::Vector2d(2e-3, 0.1), 0.02,
                                              gaussian);
  const MatrixXd driven = s.excitation;
  s.excitation_noise_sd = VectorXd::Constant(1, 0.1);
  s.excitation += at_half_samples(MatrixXd(0.1 * gaussian.vector(samples).transpose()));
  std::vector<FrozenSegment> frozen = as_measured({s});
  FrozenSegment& f = frozen.front();
  freeze_states(model, frozen, truth);
  f.driven_noise = DrivenNoise(model, f.trial(truth), f.silent);
  freeze_directions(model, frozen, truth);
  const VectorXd before = model.errors({f.trial(truth)}).front();
  take_driven_noise_off(model, f, truth);
  const VectorXd after = model.errors({f.trial(truth)}).front();
  EXPECT_LT((after - before).norm(), 1e-9 * before.norm());
  EXPECT_LT((f.segment.excitation - driven).norm(), 0.95 * (s.excitation - driven).norm());
}

}  // namespace
}  // namespace secular
