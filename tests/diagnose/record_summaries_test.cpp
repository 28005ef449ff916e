// What segments say of their records, and what is predicted of them.
#include "diagnose/evidence/record_summaries.hpp"

#include <gtest/gtest.h>

#include "diagnose/evidence/predicted_segments.hpp"
#include "tests/diagnose/frozen_decays.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing_support::as_measured;
using testing_support::decay;
using testing_support::frozen_decay;
using testing_support::Laboratory;
using testing_support::segment_model;

TEST(RecordSummaries, ADisturbedRecordNamesItsWorstSegments) {
  testing_support::Gaussian gaussian(1);
  std::vector<FrozenSegment> segments = testing_support::quiet_segments(16, 9, 3, gaussian);
  std::vector<SegmentNoise> noise(9);
  for (std::size_t i = 3; i < 6; ++i) {
    segments[i].segment.in_record_s = static_cast<double>(i);
    noise[i].disturbance = i == 4 ? 5 : 1.5;
  }
  const std::vector<DisturbedRecord> found = disturbed_records(segments, noise);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].record, 1U);
  EXPECT_EQ(found[0].segments, 3U);
  EXPECT_EQ(found[0].worst_s, std::vector<double>{4});
  EXPECT_TRUE(disturbed_records(segments, {}).empty());  // before true errors
}

TEST(RecordSummaries, SizesAreThoseOfWhatDrivesOrOfTheLargestReading) {
  testing_support::Gaussian gaussian(1);
  std::vector<FrozenSegment> segments = testing_support::quiet_segments(16, 4, 2, gaussian);
  segments[1].measured.response(0, 3) = -7;
  segments[2].measured.excitation = Eigen::MatrixXd::Constant(1, 31, 4);
  segments[3].measured.excitation = Eigen::MatrixXd::Constant(1, 31, -6);
  const std::vector<RecordSize> sizes = record_sizes(segments);
  ASSERT_EQ(sizes.size(), 2U);
  EXPECT_FALSE(sizes[0].driven);
  EXPECT_EQ(sizes[0].size, 7);
  EXPECT_TRUE(sizes[1].driven);
  EXPECT_EQ(sizes[1].size, 6);
}

TEST(RecordSummaries, AtTheTruthTheErrorIsTheNoise) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  const SegmentModel model = segment_model(lab);
  const std::vector<FrozenSegment> segments = frozen_decay(lab, truth, 7);
  const double noise = segments.front().segment.noise_sd(0),
               left = mean_square_error(model, segments, truth)(0) / (noise * noise);
  // 6 segments of 64 samples, less two of each for its state.
  EXPECT_NEAR(left, 62.0 / 64, 4 * std::sqrt(2.0 / (6 * 64)));
  EXPECT_GT(mean_square_signal(model, segments)(0), 1e6 * noise * noise);
}

// A linear structure: at a level, all readings are that level times those at one.
TEST(PredictedSegments, ScaleWithTheLevelAndLeaveNothing) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  const SegmentModel model = segment_model(lab);
  const std::vector<FrozenSegment> segments = frozen_decay(lab, truth, 7);
  const std::vector<SegmentNoise> noise(segments.size(), {VectorXd::Ones(2), 3});
  const std::vector<Segment> once = predicted_segments(model, segments, noise, truth, 1),
                             twice = predicted_segments(model, segments, noise, truth, 2);
  ASSERT_EQ(once.size(), segments.size());
  ASSERT_EQ(twice.size(), segments.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_LT((twice[i].response - 2 * once[i].response).norm(), 1e-9 * twice[i].response.norm());
    EXPECT_EQ(once[i].noise_sd, 3 * segments[i].segment.noise_sd);
  }
  EXPECT_LT(mean_square_error(model, as_measured(once), truth)(0),
            1e-6 * once.front().noise_sd(0) * once.front().noise_sd(0));
}

// A spring that softens to nothing within this motion: nothing is predicted.
TEST(PredictedSegments, AreNoneWhereAMotionRunsAway) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({{"alpha3", -1e9}});
  const SegmentModel model = segment_model(lab);
  const std::vector<FrozenSegment> segments = frozen_decay(lab, truth, 7);
  EXPECT_EQ(predicted_segments(model, segments, {}, truth, 1).size(), segments.size());
  EXPECT_TRUE(predicted_segments(model, segments, {}, truth, 30).empty());
}

}  // namespace
}  // namespace secular
