// Samples of a record against the full equations of motion.
#include "diagnose/evidence/segment_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/evidence/line_evidence.hpp"
#include "diagnose/inference/refit.hpp"
#include "tests/diagnose/decay_segments.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing_support::decay;
using testing_support::Laboratory;
using testing_support::natural;

Discrepancy decay_of(const Laboratory& lab, const VectorXd& truth) {
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<SegmentEvidence>(lab.compiled, std::vector<StateForce>{}, lab.sensors,
                                                    lab.faults, decay(lab, truth, 7)));
  return discrepancy;
}

TEST(SegmentEvidence, ADecayGivesFrequencyAndDampingBack) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  Discrepancy discrepancy = decay_of(lab, truth);
  VectorXd unknowns = lab.unknowns({{"omega0", 1.01 * natural}, {"mu1", 0.5}});
  const std::vector<std::size_t> free{lab.symbol("omega0"), lab.symbol("mu1")};
  Refit fit;
  for (const double coarse : {1e-2, 1e-3, 0.0, 0.0}) {
    discrepancy.freeze(unknowns, coarse);
    fit = refit(discrepancy, unknowns, free);
    unknowns = fit.unknowns;
  }
  for (std::size_t f = 0; f < free.size(); ++f) {
    const auto u = static_cast<Index>(free[f]), i = static_cast<Index>(f);
    const double sd = std::sqrt(fit.covariance(i, i));
    // A normal variable exceeds four standard deviations once in 16000 times.
    EXPECT_NEAR(unknowns(u), truth(u), 4 * sd) << "unknown " << u;
    EXPECT_LT(sd, 1e-2 * truth(u));
  }
}

// Motions side by side give the differences of the rows themselves; a fault of the channel alone moves no motion.
TEST(SegmentEvidence, SlopesAreCentralDifferencesToTheLastBit) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({{"alpha3", -2e7}, {"mu3", 30}});
  Discrepancy discrepancy = decay_of(lab, truth);
  discrepancy.freeze(truth);
  std::vector<std::size_t> which;
  for (std::size_t s = 0; s < lab.compiled.symbols.size(); ++s) which.push_back(s);
  for (const std::size_t fault : {lab.faults.gain(0), lab.faults.delay(0), lab.faults.frequency_drift(0)})
    which.push_back(lab.compiled.symbols.size() + fault);
  VectorXd scale(static_cast<Index>(which.size()));
  for (std::size_t w = 0; w < which.size(); ++w) {
    const double value = std::abs(truth(static_cast<Index>(which[w])));
    scale(static_cast<Index>(w)) = value > 0 ? 1e-3 * value : 1e-3;
  }
  const Eigen::MatrixXd slopes = discrepancy.slopes(truth, which, scale, 2);
  for (std::size_t w = 0; w < which.size(); ++w) {
    const auto u = static_cast<Index>(which[w]), column = static_cast<Index>(w);
    VectorXd moved = truth;
    moved(u) = truth(u) + 0.5 * scale(column);
    VectorXd difference = discrepancy(moved);
    moved(u) = truth(u) - 0.5 * scale(column);
    difference -= discrepancy(moved);
    EXPECT_EQ(slopes.col(column), difference) << "unknown " << which[w];
  }
}

// Where the frequency would be passed by a difference there is no slope.
TEST(SegmentEvidence, NoSlopeWhereAnEndHasNoFrequency) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  Discrepancy discrepancy = decay_of(lab, truth);
  discrepancy.freeze(truth);
  EXPECT_TRUE(discrepancy.slopes(truth, {lab.symbol("omega0")}, VectorXd::Constant(1, 3 * natural), 1).isZero(0));
}

// Squares of natural frequencies are the same from either side, damping is not: nothing but this keeps a fit of a
// model that is far off from walking through zero.
TEST(SegmentEvidence, NoFitPassesTheFrequencyZero) {
  const Laboratory lab;
  const VectorXd truth = lab.unknowns({});
  Discrepancy discrepancy = decay_of(lab, truth);
  discrepancy.add(std::make_unique<LineEvidence>(
      lab.model, std::vector{lab.dwell(natural, 3, std::complex<double>(2e-3, -1.5e-3))}, truth));
  discrepancy.freeze(truth);
  EXPECT_TRUE(discrepancy(truth).allFinite());
  for (const double frequency : {0.0, -1e-3, -natural, std::nan("")}) {
    const VectorXd rows = discrepancy(lab.unknowns({{"omega0", frequency}}));
    EXPECT_FALSE(rows.array().isFinite().any()) << frequency;
  }
  const std::vector<std::size_t> free{lab.symbol("omega0"), lab.symbol("mu1"), lab.symbol("alpha3")};
  for (const double start : {1e-300, 1e-3, 1.0, 10.0, 1e3, 1e150}) {
    const VectorXd far = lab.unknowns({{"omega0", start}});
    discrepancy.freeze(far, 1e-2);
    const Refit fit = refit(discrepancy, far, free);
    EXPECT_GT(fit.unknowns(static_cast<Index>(free[0])), 0) << start;
  }
}

}  // namespace
}  // namespace secular
