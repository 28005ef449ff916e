// Decays predicted under an explanation, and the one that tells explanations apart.
#include "diagnose/verdict/next_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/diagnose/decay_segments.hpp"
#include "tests/diagnose/made_up_explanation.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing_support::damping, testing_support::natural;
using testing_support::decay, testing_support::explanation, testing_support::Laboratory;

constexpr double first_displacement = 1e-3;  // of decay()

SegmentEvidence frozen_decay(const Laboratory& lab, const VectorXd& truth) {
  SegmentEvidence evidence(lab.compiled, {}, lab.sensors, lab.faults, decay(lab, truth, 7));
  evidence.freeze(truth, 0);
  return evidence;
}

TEST(PredictedRecord, OfALinearOscillatorGrowsWithItsLevel) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  const SegmentEvidence measured = frozen_decay(lab, truth);
  const std::vector<Segment> once = measured.predicted(0, truth, 1), twice = measured.predicted(0, truth, 2),
                             was = decay(lab, truth, 7);
  ASSERT_EQ(once.size(), was.size());
  ASSERT_EQ(twice.size(), was.size());
  for (std::size_t i = 0; i < was.size(); ++i) {
    EXPECT_LT((twice[i].response - 2 * once[i].response).norm(), 1e-9 * once[i].response.norm());
    // The noise of the measured one is all that it differs by, less what its state takes of it.
    const double left = (once[i].response - was[i].response).norm(),
                 samples = static_cast<double>(was[i].response.cols());
    EXPECT_NEAR(left / (was[i].noise_sd(0) * std::sqrt(samples)), 1, 0.4);
  }
}

Explanation of_law(const Laboratory& lab, const char* symbol, double value) {
  return explanation(lab, lab.unknowns({{"mu1", 0.9 * damping}, {symbol, value}}), symbol, 0.01 * value);
}

// Two laws of damping that add a tenth at the amplitude measured: 3/4 mu3 w^2 X^2 and 8/(3 pi) mu2 w X.
TEST(NextRecord, GoesWhereTheLawsPartWithinItsLimits) {
  const Laboratory lab;
  const double added = 0.2 * damping;
  const Explanation cubic = of_law(lab, "mu3", added / (0.75 * std::pow(natural * first_displacement, 2))),
                    drag = of_law(lab, "mu2", added / (8 / (3 * std::numbers::pi) * natural * first_displacement));
  const SegmentEvidence measured = frozen_decay(lab, cubic.fit.unknowns);
  const ProposedTest next = next_record(measured, {{&cubic, 0.5}, {&drag, 0.5}}, {});
  EXPECT_EQ(next.compared, 4u);  // half to half again
  EXPECT_LE(next.level, 1.5);
  EXPECT_DOUBLE_EQ(next.before, 0.5);
  EXPECT_GE(next.probability, next.typical);
  EXPECT_GT(next.separation, 0);
  EXPECT_EQ(next_record(measured, {{&cubic, 0.5}, {&drag, 0.5}}, {.highest_level = 2}).compared, 5u);
  const ProposedTest none = next_record(measured, {{&cubic, 0.5}, {&cubic, 0.5}}, {});
  EXPECT_LT(none.separation, 1e-3);
  EXPECT_EQ(none.chance, 0);
  EXPECT_EQ(next_record(measured, {{&cubic, 1}}, {}).compared, 0u);
}

// Errors are those that were measured: with a tenth of the noise ten times the separation, as long as the laws'
// own freedom does not count.
TEST(NextRecord, TellsMoreWithLessNoise) {
  const Laboratory lab;
  const double added = 0.02 * damping;
  Explanation cubic = of_law(lab, "mu3", added / (0.75 * std::pow(natural * first_displacement, 2))),
              drag = of_law(lab, "mu2", added / (8 / (3 * std::numbers::pi) * natural * first_displacement));
  cubic.fit.covariance *= 1e-8;
  drag.fit.covariance *= 1e-8;
  const std::vector<Segment> segments = decay(lab, cubic.fit.unknowns, 3);
  SegmentEvidence loud(lab.compiled, {}, lab.sensors, lab.faults, segments);
  loud.freeze(cubic.fit.unknowns, 0);
  const std::vector<Segment> clean = loud.predicted(0, cubic.fit.unknowns, 1);
  double separation[2];
  for (double& found : separation) {
    const double scale = &found == separation ? 1 : 0.1;
    std::vector<Segment> quiet = segments;
    for (std::size_t i = 0; i < quiet.size(); ++i) {  // the same noise, a tenth as much
      quiet[i].response = clean[i].response + scale * (segments[i].response - clean[i].response);
      quiet[i].noise_sd *= scale;
    }
    SegmentEvidence measured(lab.compiled, {}, lab.sensors, lab.faults, quiet);
    measured.freeze(cubic.fit.unknowns, 0);
    const ProposedTest next = next_record(measured, {{&cubic, 0.5}, {&drag, 0.5}}, {.highest_level = 1});
    found = next.separation / std::sqrt(next.length);
  }
  EXPECT_NEAR(separation[1] / separation[0], 10, 2);
}

}  // namespace
}  // namespace secular
