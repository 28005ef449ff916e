// Dry friction in stretches of motion: its switches, and rows that are continuous in its strength.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/inference/refit.hpp"
#include "generated/registry.hpp"
#include "tests/diagnose/laboratory.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double swing = 5.77, friction = 0.4, sample_s = 0.04;

class FrictionEvidence : public testing::TestWithParam<int> {
 protected:
  std::size_t symbol(const std::string& name) const { return symbol_named(model, name); }
  VectorXd unknowns(double strength) const {
    return testing_support::unknowns_of(model, FaultTable(model, sensors),
                                        {{"omega0", swing}, {"mu1", 0.01}, {"fc", strength}});
  }
  StretchOfMotion motion(double strength, const VectorXd& state, Index samples, int substeps) const {
    const VectorXd values = unknowns(strength);
    return MotionIntegrator(model, {}).motion({{values.data(), values.data() + model.symbols.size()},
                                               state,
                                               std::make_shared<const DrivingSignal>(DrivingSignal{{}, sample_s}),
                                               samples,
                                               substeps});
  }
  // A decay as it is measured, with noise of a thousandth of its begin.
  SegmentEvidence decay() const {
    constexpr Index length = 160;
    const StretchOfMotion m = motion(friction, Eigen::Vector2d(0.9, 0), 3 * length, 64);
    const Eigen::MatrixXd& seen = GetParam() == 2 ? m.acceleration : GetParam() == 1 ? m.velocity : m.displacement;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::vector<Segment> segments;
    for (int i = 0; i < 3; ++i) {
      Segment s;
      s.fold = i;
      s.sample_s = sample_s;
      s.substeps = 4;
      s.response = seen.middleCols(i * length, length);
      s.noise_sd = VectorXd::Constant(1, 1e-3 * 0.9 * std::pow(swing, GetParam()));
      for (double& reading : s.response.row(0)) reading += s.noise_sd(0) * normal(random);
      segments.push_back(std::move(s));
    }
    return {model, {}, sensors, FaultTable(model, sensors), std::move(segments)};
  }
  static VectorXd rows_of(const SegmentEvidence& evidence, const VectorXd& at) {
    VectorXd rows(evidence.size());
    evidence.evaluate(at, rows);
    return rows;
  }

  const CompiledModel& model = *generated::find_compiled_model("pendulum");
  SensorModel sensors = testing_support::one_sensor("theta", GetParam());
};

TEST_P(FrictionEvidence, RowsAreContinuousInItsStrength) {
  SegmentEvidence evidence = decay();
  evidence.freeze(unknowns(friction), 0);
  const double step = 2e-6;
  VectorXd before = rows_of(evidence, unknowns(friction - 100 * step));
  for (int i = -99; i <= 100; ++i) {
    const VectorXd here = rows_of(evidence, unknowns(friction + i * step));
    ASSERT_LT((here - before).cwiseAbs().maxCoeff(), 0.01) << i;
    ASSERT_LT(std::abs(here.squaredNorm() - before.squaredNorm()), 1) << i;
    before = here;
  }
}

TEST_P(FrictionEvidence, ItsFitConvergesToTheTruth) {
  SegmentEvidence* evidence = new SegmentEvidence(decay());
  Discrepancy discrepancy;
  discrepancy.add(std::unique_ptr<Evidence>(evidence));
  VectorXd at = unknowns(0.8 * friction);
  Refit fit;
  for (int round = 0; round < 3; ++round) {
    discrepancy.freeze(at);
    fit = refit(discrepancy, at, {symbol("omega0"), symbol("mu1"), symbol("fc")});
    at = fit.unknowns;
  }
  EXPECT_EQ(fit.ending, SolverEnding::converged);
  EXPECT_NEAR(at(static_cast<Index>(symbol("fc"))), friction, 4 * std::sqrt(fit.covariance(2, 2)));
  // Four standard deviations of chi-squared.
  const auto freedom = static_cast<double>(discrepancy.freedom());
  EXPECT_NEAR(fit.chi_squared, freedom, 4 * std::sqrt(2 * freedom));
}

// Numbers that are far off leave more than the records' noise, which stays what it was.
TEST_P(FrictionEvidence, ATrialThatRunsAwayDoesNotRaiseTheNoise) {
  SegmentEvidence evidence = decay(), tried = decay();
  evidence.freeze(unknowns(friction), 0);
  for (const double far : {1.5 * friction, 5.0, -0.1}) {
    tried.freeze(unknowns(far), 0);
    tried.freeze(unknowns(friction), 0);
    const double once = rows_of(evidence, unknowns(friction)).squaredNorm();
    EXPECT_NEAR(rows_of(tried, unknowns(friction)).squaredNorm(), once, 1e-2 * once) << far;
  }
}

INSTANTIATE_TEST_SUITE_P(Derivatives, FrictionEvidence, testing::Values(0, 1, 2));

// x'' + w^2 x = -f sgn(x'): every half turn about +-f/w^2, until it stays within.
class FrictionStretch : public FrictionEvidence {};

TEST_P(FrictionStretch, IsPiecewiseExactAndComesToRest) {
  const double about = GetParam() == 0 ? 0.02 : 0.045, start = 0.35, f = about * swing * swing;
  VectorXd values = unknowns(f);
  values(static_cast<Index>(symbol("mu1"))) = 0;
  const auto silent = std::make_shared<const DrivingSignal>(DrivingSignal{{}, sample_s});
  const auto worst = [&](int substeps) {
    const StretchOfMotion m = MotionIntegrator(model, {}).motion(
        {{values.data(), values.data() + model.symbols.size()}, Eigen::Vector2d(start, 0), silent, 200, substeps});
    double error = 0;
    for (Index i = 0; i < 200; ++i) {
      const double turns = swing * sample_s * static_cast<double>(i) / std::numbers::pi;
      double peak = start, side = 1;  // of this half turn
      int half = 0;
      while (half < static_cast<int>(turns) && std::abs(peak) > about) {
        peak = 2 * side * about - peak;
        side = -side;
        ++half;
      }
      const double exact = std::abs(peak) <= about
                               ? peak
                               : side * about + (peak - side * about) * std::cos(std::numbers::pi * (turns - half));
      error = std::max(error, std::abs(m.displacement(0, i) - exact));
    }
    EXPECT_EQ(m.velocity(0, 199), 0);
    EXPECT_EQ(m.acceleration(0, 199), 0);
    return error;
  };
  const double coarse = worst(2), fine = worst(4);
  EXPECT_LT(fine, 1e-6);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Strengths, FrictionStretch, testing::Values(0, 1));

}  // namespace
}  // namespace secular
