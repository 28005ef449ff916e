// Rows of frozen segments, their slopes, and what is between the samples of blows: docs/inference.md (42).
#include "diagnose/evidence/segment_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "diagnose/evidence/between_samples.hpp"
#include "diagnose/evidence/segment_slopes.hpp"
#include "tests/diagnose/driven_segment.hpp"
#include "tests/diagnose/frozen_decays.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing_support::frozen_decay;
using testing_support::Laboratory;
using testing_support::natural;
using testing_support::segment_model;

std::vector<SegmentNoise> known_noise(std::size_t segments) {
  return {segments, {VectorXd::Ones(2), 1}};
}

VectorXd filled(const SegmentRows& rows, const std::function<VectorXd(const FrozenSegment&)>& error) {
  const std::vector<Index> begins = rows.begins();
  VectorXd all(begins.back());
  for (std::size_t i = 0; i < rows.segments.size(); ++i)
    rows.fill(i, error(rows.segments[i]), all.segment(begins[i], rows.count(i)));
  return all;
}

TEST(SegmentRows, OfNoiseAloneHaveUnitVarianceByTheirFreedom) {
  const Laboratory lab;
  const SegmentModel model = segment_model(lab);
  const std::vector<FrozenSegment> segments = frozen_decay(lab, lab.unknowns({}), 7);
  const std::vector<SegmentNoise> noise = known_noise(segments.size());
  const SegmentRows rows{model, segments, noise};
  // Two directions of a state off 64 samples each; the two first rows are rows as well.
  const Index freedom = freedom_of(rows);
  EXPECT_EQ(freedom, static_cast<Index>(segments.size()) * (64 - 2));
  testing_support::Gaussian gaussian(3);
  double sum = 0;
  constexpr int draws = 50;
  for (int d = 0; d < draws; ++d)
    sum += filled(rows, [&](const FrozenSegment& f) { return gaussian.vector(f.samples()); }).squaredNorm() / draws;
  const auto expected = static_cast<double>(freedom);
  EXPECT_NEAR(sum, expected, 4 * std::sqrt(2 * expected / draws));
}

// A state that is off moves no row, a change of the mode the first ones alone.
TEST(SegmentRows, DoNotSeeTheState) {
  const Laboratory lab;
  const SegmentModel model = segment_model(lab);
  const std::vector<FrozenSegment> segments = frozen_decay(lab, lab.unknowns({}), 7);
  const std::vector<SegmentNoise> noise = known_noise(segments.size());
  const SegmentRows rows{model, segments, noise};
  EXPECT_LT(filled(rows, [](const FrozenSegment& f) { return VectorXd(f.directions.of_state.col(1)); }).norm(),
            1e-12);
  const VectorXd changed =
      filled(rows, [](const FrozenSegment& f) { return VectorXd(f.directions.of_change.col(1)); });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const VectorXd own = changed.segment(rows.begins()[i], rows.count(i));
    EXPECT_NEAR(own(1), 1, 1e-12);
    EXPECT_LT(own.tail(own.size() - 2).norm() + std::abs(own(0)), 1e-12);
  }
}

TEST(SegmentRows, CountForAsMuchAsNoiseWideningAndDisturbanceSay) {
  const Laboratory lab;
  const SegmentModel model = segment_model(lab);
  std::vector<FrozenSegment> segments = frozen_decay(lab, lab.unknowns({}), 7);
  const auto error = [](const FrozenSegment& f) -> VectorXd { return VectorXd::LinSpaced(f.samples(), -1, 2); };
  const VectorXd unit = filled({model, segments, known_noise(6)}, error);
  std::vector<SegmentNoise> noise(6, {Eigen::Vector2d(2, 4), 5});
  for (SegmentNoise& n : noise) n.disturbance = 10;
  const VectorXd scaled = filled({model, segments, noise}, error);
  for (FrozenSegment& f : segments) f.widening = 3;
  const VectorXd wide = filled({model, segments, {}}, error);
  const std::vector<Index> begins = SegmentRows{model, segments, {}}.begins();
  for (Index r = 0; r < unit.size(); ++r) {
    const Index in_segment = (r - begins[0]) % (begins[1] - begins[0]);
    const double factor = in_segment == 0 ? 2 : in_segment == 1 ? 4 : 5 * 10;
    EXPECT_NEAR(scaled(r), unit(r) / factor, 1e-12) << r;
    EXPECT_NEAR(wide(r), unit(r) / 3, 1e-12) << r;
  }
}

// Of a decay in one piece readings hold everything, and changes of the mode can be told apart from them afterwards.
TEST(SegmentRows, InFoldsAreReadingsAlone) {
  const Laboratory lab;
  const SegmentModel model = segment_model(lab);
  std::vector<FrozenSegment> segments = frozen_decay(lab, lab.unknowns({}), 7);
  const auto error = [](const FrozenSegment& f) -> VectorXd { return VectorXd::LinSpaced(f.samples(), -1, 2); };
  const VectorXd apart = filled({model, segments, known_noise(6)}, error);
  for (FrozenSegment& f : segments) f.segment.folds = 4;
  const std::vector<SegmentNoise> noise = known_noise(6);
  const SegmentRows rows{model, segments, noise};
  const VectorXd together = filled(rows, error);
  for (std::size_t i = 0; i < segments.size(); ++i)
    EXPECT_TRUE(together.segment(rows.begins()[i], 2).isZero(0)) << i;
  EXPECT_NEAR(together.squaredNorm(), apart.squaredNorm(), 1e-9 * apart.squaredNorm());
  EXPECT_LT((rows.by_balance(together) - apart).norm(), 1e-9 * apart.norm());
}

TEST(SegmentRows, EveryRowHasALabel) {
  const Laboratory lab;
  const SegmentModel model = segment_model(lab);
  const std::vector<FrozenSegment> segments = frozen_decay(lab, lab.unknowns({}), 7);
  const SegmentRows rows{model, segments, {}};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::vector<RowLabel> labels = segment_labels(model, segments[i].segment);
    ASSERT_EQ(static_cast<Index>(labels.size()), rows.count(i));
    EXPECT_EQ(labels[0].component, EffectComponent::conservative);
    EXPECT_EQ(labels[1].component, EffectComponent::dissipative);
    EXPECT_EQ(labels[2].component, EffectComponent::measurement);
    EXPECT_EQ(labels.back().fold, static_cast<int>(i));
  }
}

// An offset's slope in closed form is the difference of rows beside it.
TEST(SegmentSlopes, ByAnOffsetAreThoseOfDifferences) {
  const Laboratory lab;
  const SegmentModel model = segment_model(lab);
  const VectorXd truth = lab.unknowns({});
  const std::vector<FrozenSegment> segments = frozen_decay(lab, truth, 7);
  const std::vector<SegmentNoise> noise = known_noise(segments.size());
  const SegmentRows rows{model, segments, noise};
  const std::size_t offset = model.offset(0);
  const double scale = 2 * segments.front().segment.noise_sd(0);
  const VectorXd slope = segment_slopes(rows, truth, {offset}, VectorXd::Constant(1, scale), 1);
  const auto rows_at = [&](double value) {
    VectorXd unknowns = truth;
    unknowns(static_cast<Index>(offset)) = value;
    const std::vector<VectorXd> errors = seen_errors(model, segments, unknowns);
    return filled(rows,
                  [&](const FrozenSegment& f) { return errors[static_cast<std::size_t>(&f - segments.data())]; });
  };
  const VectorXd difference = rows_at(0.5 * scale) - rows_at(-0.5 * scale);
  EXPECT_LT((slope - difference).norm(), 1e-9 * difference.norm());
  EXPECT_GT(difference.norm(), 1);
}

Segment blow(const Laboratory& lab, const VectorXd& unknowns) {
  testing_support::Gaussian gaussian(3);
  const auto base = [](double t) { return t < 0.02 ? 50 * std::pow(std::sin(std::numbers::pi * t / 0.02), 2) : 0; };
  return testing_support::driven_segment(lab, unknowns, {300, 4e-3, base}, Eigen::Vector2d(1e-3, 0), 0.02,
                                         gaussian);
}

TEST(BetweenSamples, ReadingsAtTheSamplesStay) {
  const Laboratory lab;
  const Segment s = blow(lab, lab.unknowns({{"eta1", 1}}));
  for (const Segment& moved : {stronger_between_samples(s, 0.1), later_between_samples(s, 1e-3)}) {
    EXPECT_EQ(moved.response, s.response);
    for (Index i = 0; i < s.excitation.cols(); i += 2) EXPECT_EQ(moved.excitation(0, i), s.excitation(0, i));
  }
  // Simpson's rule: stronger by that share in all, and later by that time.
  const auto simpson = [](const Segment& of, int power) {
    double sum = 0;
    for (Index i = 0; i + 2 < of.excitation.cols(); i += 2)
      for (const Index k : {0, 1, 2})
        sum += (k == 1 ? 4 : 1) * of.excitation(0, i + k) * std::pow(static_cast<double>(i + k) / 2, power);
    return sum * of.sample_s / 6;
  };
  EXPECT_NEAR(simpson(stronger_between_samples(s, 0.1), 0) / simpson(s, 0), 1.1, 0.01);
  const double middle = s.sample_s * simpson(s, 1) / simpson(s, 0);
  const Segment late = later_between_samples(s, 1e-3);
  EXPECT_NEAR(s.sample_s * simpson(late, 1) / simpson(late, 0), middle + 1e-3, 1e-4);
}

TEST(BetweenSamples, RowsOfTheNamedRecordsMoveInProportion) {
  const Laboratory lab;
  const SegmentModel model = segment_model(lab);
  const VectorXd truth = lab.unknowns({{"eta1", 1}});
  Segment first = blow(lab, truth), second = first;
  second.record = 1;
  std::vector<FrozenSegment> segments = testing_support::as_measured({first, second});
  freeze_segments(model, segments, truth, 0, 1);
  const std::vector<SegmentNoise> noise = known_noise(2);
  const SegmentRows rows{model, segments, noise};
  EXPECT_EQ(between_samples_columns(rows, truth, {}).size(), 0);
  const MatrixXd once = between_samples_columns(rows, truth, {{1}, 0.01, natural}),
                 twice = between_samples_columns(rows, truth, {{1}, 0.02, natural});
  EXPECT_TRUE(once.topRows(rows.count(0)).isZero(0));
  EXPECT_GT(once.bottomRows(rows.count(1)).colwise().norm().minCoeff(), 0);
  EXPECT_LT((twice - 2 * once).norm(), 1e-4 * twice.norm());
}

}  // namespace
}  // namespace secular
