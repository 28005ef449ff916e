// Slopes of a condition's rows.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/diagnose/laboratory.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing_support::Laboratory;
using testing_support::natural;

// Held lines and a linear correction for what follows them give what solving anew for every change gives.
TEST(ConditionSlopes, AreThoseOfTheSolvedRows) {
  const Laboratory lab;
  // Quadratic and cubic forces so strong that slaved lines carry some percent of the motion.
  const VectorXd unknowns =
      lab.unknowns({{"alpha2", 6e5}, {"alpha3", -2e7}, {"delta2", 20}, {"mu3", 30}, {"eta2", 1.5}});
  const Condition dwell = lab.dwell(80.3, 3, Complex(2e-3, -1.5e-3));
  const ConditionRows rows = lab.model.rows(dwell, unknowns, nullptr);
  ASSERT_TRUE(rows.motion.converged);
  ASSERT_GT(rows.motion.displacement.col(2).cwiseAbs()(0), 0.04 * std::abs(rows.amplitudes(0)));
  std::vector<std::size_t> which(lab.compiled.symbols.size());
  std::iota(which.begin(), which.end(), std::size_t{0});
  const std::size_t first_fault = which.size();
  for (const std::size_t fault : {lab.faults.gain(0), lab.faults.delay(0), lab.faults.cross(0), lab.faults.drift(0),
                                  lab.faults.shaker_harmonic(0)})
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

}  // namespace
}  // namespace secular
