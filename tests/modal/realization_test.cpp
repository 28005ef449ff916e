// Exact truths: what analytic impulse responses are made of comes back.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "measure/modal/eigensystem_realization.hpp"
#include "measure/modal/modal_assurance.hpp"
#include "measure/modal/pole_fit.hpp"
#include "measure/modal/stabilisation.hpp"
#include "tests/modal/pole_of.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

struct System {
  VectorXcd poles;    // n
  MatrixXcd shapes;   // p x n
  MatrixXcd factors;  // n x q
  MatrixXd direct;    // p x q
  double rate = 0;

  ResponseSequence responses(Index samples) const {
    ResponseSequence y;
    for (Index k = 0; k < samples; ++k) {
      const VectorXcd power = (poles * (static_cast<double>(k) / rate)).array().exp();
      const MatrixXcd sum = shapes * power.asDiagonal() * factors;
      y.emplace_back(2 * sum.real());
      if (k == 0) y.back() += direct;
    }
    return y;
  }
};

constexpr double hz = 2 * std::numbers::pi;

System three_modes() {
  System s;
  s.rate = 256;
  s.poles.resize(3);
  s.poles << pole_of(12.42 * hz, 0.0037), pole_of(33.32 * hz, 0.0014), pole_of(39.31 * hz, 0.0022);
  s.shapes.resize(3, 3);
  s.shapes << Complex(0.84, 0), Complex(-0.53, 0.01), 0.01, 0.53, 0.85, Complex(-0.01, 0.02), -0.12, 0.02, 1;
  s.factors.resize(3, 2);
  s.factors << Complex(0.3, -0.9), 0.5, Complex(-0.6, 0.2), Complex(0.1, 1.1), Complex(0.05, -0.4), Complex(0, 0.7);
  s.direct = MatrixXd(3, 2);
  s.direct << 1.9, 0.1, -0.3, 1.4, 0.2, 0.7;
  return s;
}

Index nearest(const VectorXcd& poles, Complex pole) {
  Index best = 0;
  (poles.array() - pole).abs().minCoeff(&best);
  return best;
}

void expect_system(const System& truth, const Realization& found, double tolerance) {
  for (Index r = 0; r < truth.poles.size(); ++r) {
    const Index i = nearest(found.poles, truth.poles(r));
    EXPECT_LT(std::abs(found.poles(i) - truth.poles(r)) / std::abs(truth.poles(r)), tolerance) << r;
    const MatrixXcd residue = truth.shapes.col(r) * truth.factors.row(r);
    const MatrixXcd product = found.C.col(i) * found.B.row(i);
    EXPECT_LT((product - residue).norm() / residue.norm(), 1e3 * tolerance) << r;
    EXPECT_NEAR(modal_assurance(found.C.col(i), truth.shapes.col(r)), 1, 1e-9);
  }
  EXPECT_LT((found.D - truth.direct).norm(), 1e-8 * (1 + truth.direct.norm()));
}

MatrixXd response(const Realization& system, Index k) {
  Eigen::VectorXcd power(system.z.size());
  for (Index i = 0; i < power.size(); ++i) power(i) = std::pow(system.z(i), static_cast<double>(k));
  MatrixXd y = (system.C * power.asDiagonal() * system.B).real();
  if (k == 0) y += system.D;
  return y;
}

TEST(Realization, RecoversModesAndFeedThrough) {
  const System truth = three_modes();
  const ResponseSequence y = truth.responses(200);
  const EigensystemRealization era(y, truth.rate, true, hankel_size(200, 3, 2, 6, true));
  EXPECT_EQ(era.rank(), 6);
  const Realization found = era.realize(6);
  expect_system(truth, found, 1e-11);
  for (const Index k : {Index(0), Index(1), Index(57), Index(199)})
    EXPECT_LT((response(found, k) - y[static_cast<std::size_t>(k)]).norm(), 1e-9) << k;
}

TEST(Realization, WithoutFeedThroughTheFirstSampleCounts) {
  System truth = three_modes();
  truth.direct.setZero();
  const EigensystemRealization era(truth.responses(150), truth.rate, false, hankel_size(150, 3, 2, 6, false));
  EXPECT_EQ(era.rank(), 6);
  expect_system(truth, era.realize(6), 1e-11);
}

// A pulse that the realization is not told of is taken for a mode.
TEST(Realization, IgnoredFeedThroughSpoilsTheRank) {
  const System truth = three_modes();
  const EigensystemRealization era(truth.responses(200), truth.rate, false, hankel_size(200, 3, 2, 8, false));
  EXPECT_GT(era.rank(), 6);
}

// Two modes 0.2 % apart: a twentieth of the resolution of the record.
TEST(Realization, SeparatesCloseModes) {
  System truth = three_modes();
  truth.poles(2) = pole_of(33.32 * 1.002 * hz, 0.0016);
  const EigensystemRealization era(truth.responses(256), truth.rate, true, hankel_size(256, 3, 2, 6, true));
  expect_system(truth, era.realize(6), 1e-9);
}

// One channel and one reference: poles of a scalar sequence (Prony's case).
TEST(Realization, ScalarSequence) {
  System truth = three_modes();
  truth.shapes = truth.shapes.topRows(1).eval();
  truth.factors = truth.factors.leftCols(1).eval();
  truth.direct = MatrixXd::Constant(1, 1, -2);
  const EigensystemRealization era(truth.responses(256), truth.rate, true, hankel_size(256, 1, 1, 6, true));
  expect_system(truth, era.realize(6), 1e-9);
}

TEST(Realization, RefusesWhatDoesNotFit) {
  const System truth = three_modes();
  ResponseSequence y = truth.responses(20);
  EXPECT_THROW(EigensystemRealization(y, 256, true, {15, 5}), std::invalid_argument);
  EXPECT_THROW(EigensystemRealization(y, 0, true, {10, 5}), std::invalid_argument);
  const EigensystemRealization era(y, 256, true, {10, 5});
  EXPECT_THROW(era.realize(era.rank() + 1), std::invalid_argument);
  EXPECT_THROW(era.realize(0), std::invalid_argument);
  y[3](0, 0) = std::nan("");
  EXPECT_THROW(EigensystemRealization(y, 256, true, {10, 5}), std::invalid_argument);
  y.resize(3);
  EXPECT_THROW(EigensystemRealization(y, 256, true, {1, 1}), std::invalid_argument);
}

TEST(Stabilisation, ExactModesStand) {
  const System truth = three_modes();
  const EigensystemRealization era(truth.responses(300), truth.rate, true, hankel_size(300, 3, 2, 40, true));
  const StabilisationDiagram diagram = stabilisation_diagram(era, {});
  ASSERT_EQ(diagram.modes.size(), 3u);
  for (std::size_t r = 0; r < 3; ++r)
    EXPECT_LT(std::abs(diagram.modes[r].pole / truth.poles(static_cast<Index>(r)) - 1.0), 1e-9);
}

MatrixXd decay_of(const System& truth, Index samples) {
  const ResponseSequence y = truth.responses(samples);
  MatrixXd decay(samples, truth.shapes.rows());
  for (Index k = 0; k < samples; ++k) decay.row(k) = y[static_cast<std::size_t>(k)].col(0).transpose();
  return decay;
}

TEST(PoleFit, RefinesToTheExactPolesInTime) {
  System truth = three_modes();
  truth.direct.setZero();
  const MatrixXd decay = decay_of(truth, 200).array() + 0.7;  // an offset is no part of the modes
  const VectorXcd start = truth.poles * Complex(1.0005, 0.0003);
  const PoleFit fit = refine_poles(decay, truth.rate, start);
  for (Index r = 0; r < 3; ++r) {
    EXPECT_LT(std::abs(fit.poles(r) / truth.poles(r) - 1.0), 1e-11);
    for (Index c = 0; c < 3; ++c)
      EXPECT_LT(std::abs(fit.residues(r, c) - truth.shapes(c, r) * truth.factors(r, 0)), 1e-9);
  }
}

// Samples tell a pole but for multiples of the sample rate: of the poles that explain a heavily damped motion
// alike, the one below half the sample rate is meant, wherever the fit starts.
TEST(PoleFit, StaysBelowHalfTheSampleRate) {
  System truth;
  truth.rate = 512;
  truth.poles.resize(1);
  truth.poles << pole_of(45 * hz, 0.1);
  truth.shapes = truth.factors = MatrixXcd::Ones(1, 1);
  truth.direct = MatrixXd::Zero(1, 1);
  const MatrixXd decay = decay_of(truth, 400);
  for (const double start : {60.0, 128.0, 200.0, 227.6, 240.0, 255.0}) {
    const PoleFit fit = refine_poles(decay, truth.rate, VectorXcd::Constant(1, pole_of(start * hz, 0.003)));
    EXPECT_LE(fit.poles(0).imag(), std::numbers::pi * truth.rate) << start;
  }
  const VectorXcd above = VectorXcd::Constant(1, pole_of(467 * hz, 0.01));
  EXPECT_THROW(fit_residues(decay, truth.rate, above), std::invalid_argument);
  EXPECT_THROW(refine_poles(decay, truth.rate, above), std::invalid_argument);
}

// Accelerance of normal and complex modes with a mode above and one below the band: three terms stand for the pulse
// and, to the accuracy of a power series, for what lies outside.
TEST(PoleFit, RefinesToTheExactPolesInFrequency) {
  const System truth = three_modes();
  const Index lines = 400;
  const Eigen::VectorXd omega = Eigen::VectorXd::LinSpaced(lines, 8 * hz, 45 * hz);
  MatrixXcd accelerance(lines, 6);
  for (Index i = 0; i < lines; ++i) {
    const Complex s(0, omega(i));
    for (Index j = 0; j < 2; ++j)
      for (Index c = 0; c < 3; ++c) {
        Complex sum = truth.direct(c, j);
        for (Index r = 0; r < 3; ++r) {
          const Complex residue = truth.shapes(c, r) * truth.factors(r, j);
          sum += residue / (s - truth.poles(r)) + std::conj(residue) / (s - std::conj(truth.poles(r)));
        }
        accelerance(i, j * 3 + c) = sum;
      }
  }
  const PoleFit fit =
      refine_poles(omega, accelerance, ResponseForm::accelerance, truth.poles * Complex(1.0005, 0.0003));
  for (Index r = 0; r < 3; ++r) {
    EXPECT_LT(std::abs(fit.poles(r) / truth.poles(r) - 1.0), 1e-10);
    EXPECT_LT(std::abs(fit.residues(r, 4) - truth.shapes(1, r) * truth.factors(r, 1)), 1e-8);
  }
}

}  // namespace
}  // namespace secular
