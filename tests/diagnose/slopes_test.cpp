// Rows of a condition and their slopes.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "diagnose/thresholds.hpp"
#include "tests/diagnose/laboratory.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing_support::Laboratory;
using testing_support::natural;

// Quadratic and cubic forces so strong that slaved lines carry some percent of the motion.
VectorXd strong_forces(const Laboratory& lab) {
  return lab.unknowns({{"alpha2", 6e5}, {"alpha3", -2e7}, {"delta2", 20}, {"mu3", 30}, {"eta2", 1.5}});
}

Condition swinging(const Laboratory& lab) {
  return lab.dwell(80.3, 3, Complex(2e-3, -1.5e-3));
}

// Held lines and a linear correction for what follows them give what solving anew for every change gives.
TEST(ConditionSlopes, AreThoseOfTheSolvedRows) {
  const Laboratory lab;
  const VectorXd unknowns = strong_forces(lab);
  const Condition dwell = swinging(lab);
  const ConditionRows rows = lab.model.rows(dwell, unknowns, nullptr);
  ASSERT_TRUE(rows.motion.converged());
  ASSERT_GT(rows.motion.displacement.col(2).cwiseAbs()(0), 0.04 * std::abs(rows.amplitudes(0)));
  std::vector<std::size_t> which(lab.compiled.symbols.size());
  std::iota(which.begin(), which.end(), std::size_t{0});
  const std::size_t first_fault = which.size();
  for (const std::size_t fault : {lab.faults.gain(0), lab.faults.delay(0), lab.faults.cross(0),
                                  lab.faults.frequency_drift(0), lab.faults.shaker_harmonic(0)})
    which.push_back(first_fault + fault);
  VectorXd scale(static_cast<Index>(which.size()));
  for (std::size_t w = 0; w < which.size(); ++w) {
    const double value = std::abs(unknowns(static_cast<Index>(which[w])));
    scale(static_cast<Index>(w)) = value > 0 ? 1e-5 * value : 1e-6;
  }
  const MatrixXd slopes = lab.model.slopes(dwell, unknowns, rows.motion.displacement, which, scale);
  for (std::size_t w = 0; w < which.size(); ++w) {
    const auto u = static_cast<Index>(which[w]), column = static_cast<Index>(w);
    VectorXd moved = unknowns;
    moved(u) += 0.5 * scale(column);
    const VectorXd up = lab.model.rows(dwell, moved, nullptr).values;
    moved(u) = unknowns(u) - 0.5 * scale(column);
    const VectorXd solved = up - lab.model.rows(dwell, moved, nullptr).values;
    // Balances are found to 1e-10 of forces of some 1e4; that divided by a change of this size is what may differ.
    EXPECT_LT((slopes.col(column) - solved).norm(), 1e-4 * solved.norm() + 1e-6) << "unknown " << which[w];
  }
}

// Every reading that the motion follows from is changed by its error; those that it does not follow from are in
// their own rows alone. What the lines do is linear: errors of 1e-4 leave their square.
TEST(ConditionCovariance, IsThatOfTheSolvedRows) {
  const Laboratory lab;
  const VectorXd unknowns = strong_forces(lab);
  const Condition dwell = swinging(lab);
  const ConditionRows here = lab.model.rows(dwell, unknowns, nullptr);
  const double floor = diagnose_thresholds().trusted_share;
  const double response_sd = std::hypot(dwell.response_sd(0, 0), floor * std::abs(dwell.response(0, 0))),
               excitation_sd = std::hypot(dwell.excitation_sd(0, 0), floor * std::abs(dwell.excitation(0, 0)));
  const Index size = here.values.size();
  MatrixXd expected = MatrixXd::Zero(size, size);
  expected.diagonal().tail(4).setConstant(response_sd * response_sd);
  const auto add = [&](const Condition& moved) {
    const VectorXd change = lab.model.rows(moved, unknowns, nullptr).values - here.values;
    expected += change * change.transpose();
  };
  for (const Complex turn : {Complex(1, 0), Complex(0, 1)}) {
    Condition moved = dwell;
    moved.response(0, 0) += response_sd * turn;
    add(moved);
    moved = dwell;
    moved.excitation(0, 0) += excitation_sd * turn;
    add(moved);
  }
  const MatrixXd covariance = lab.model.covariance(dwell, unknowns, here);
  const VectorXd sd = expected.diagonal().cwiseSqrt();
  EXPECT_LT(((covariance - expected).array() / (sd * sd.transpose()).array()).abs().maxCoeff(), 1e-3);
}

// A dwell on which no mode is seen to swing, under a model that does not move yet either: what it lacks has slopes.
TEST(ConditionSlopes, DoNotVanishAtRest) {
  const Laboratory lab;
  const VectorXd unknowns = lab.unknowns({{"eta1", 0.0}});
  Condition dwell = lab.dwell(160, 3, Complex(2e-3, -1.5e-3));
  dwell.masters.clear();
  const ConditionRows rows = lab.model.rows(dwell, unknowns, nullptr);
  ASSERT_TRUE(rows.motion.converged());
  ASSERT_EQ(rows.motion.displacement.cwiseAbs().maxCoeff(), 0);
  const std::vector<std::size_t> which{lab.symbol("eta1")};
  const double size = 1e-5;
  const MatrixXd slopes =
      lab.model.slopes(dwell, unknowns, rows.motion.displacement, which, VectorXd::Constant(1, size));
  VectorXd moved = unknowns;
  moved(static_cast<Index>(which[0])) = size;
  const VectorXd solved = lab.model.rows(dwell, moved, nullptr).values - rows.values;
  ASSERT_GT(solved.norm(), 0);
  EXPECT_LT((slopes.col(0) - solved).norm(), 1e-4 * solved.norm());
}

// What is cut off depends on the harmonics that go with the line that is cut: they are the model's.
TEST(ConditionRows, ACutChannelGivesBackTheAmplitudeOfItsMotion) {
  const Laboratory lab;
  VectorXd unknowns = lab.unknowns({{"alpha3", -9e7}, {"alpha2", 1e5}});
  const Complex amplitude(2e-3, -1.5e-3);
  const double peak = 2 * 80.3 * 80.3 * std::abs(amplitude);
  for (const double level : {0.95, 0.7, 0.5})
    for (const double noise : {0.0, 0.05, 0.2}) {
      unknowns(static_cast<Index>(lab.compiled.symbols.size() + lab.faults.inverse_level(0))) = 1 / (level * peak);
      Condition dwell = lab.dwell(80.3, 3, amplitude);
      dwell.response_noise = VectorXd::Constant(1, noise * peak);
      Eigen::VectorXcd amplitudes(1);
      amplitudes(0) = amplitude;
      const ConditionForecast shown = lab.model.forecast(dwell, amplitudes, unknowns, nullptr);
      ASSERT_TRUE(shown.motion.converged());
      ASSERT_GT(9 * std::abs(shown.motion.displacement(0, 3)), 0.05 * std::abs(amplitude));
      dwell.response = shown.response;
      const ConditionRows rows = lab.model.rows(dwell, unknowns, nullptr);
      EXPECT_LT(std::abs(rows.amplitudes(0) - amplitude), 1e-7 * std::abs(amplitude)) << level << " " << noise;
      EXPECT_LT(rows.values.tail(rows.values.size() - 2).norm(), 1e-6 * peak);
    }
}

}  // namespace
}  // namespace secular
