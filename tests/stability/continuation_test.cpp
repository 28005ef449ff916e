#include "motion/response/continuation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <vector>

#include "fields.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::VectorXd;

ContinuationOptions between(double lower, double upper) {
  ContinuationOptions options;
  options.lower = lower;
  options.upper = upper;
  return options;
}

// Largest |f| over all points.
double worst_residual(const VectorField& field, VectorXd p, const Branch& branch) {
  double worst = 0;
  for (const Equilibrium& point : branch.points) {
    p(branch.parameter) = point.parameter;
    worst = std::max(worst, field.rate(point.state, p).norm());
  }
  return worst;
}

TEST(Continuation, SaddleNodeByHand) {
  const VectorField field = saddle_node_field();
  const Branch branch = continue_fixed_points(field, vector({0.5}), 0, vector({0.7}), between(-1, 1));
  ASSERT_EQ(branch.special.size(), 1u);
  const SpecialPoint& fold = branch.special.front();
  EXPECT_EQ(fold.kind, SpecialKind::saddle_node);
  EXPECT_TRUE(fold.polished);
  EXPECT_NEAR(fold.at.parameter, 0, 1e-12);
  EXPECT_NEAR(fold.at.state(0), 0, 1e-12);
  EXPECT_EQ(branch.first_end.status, TraceStatus::parameter_bound);
  EXPECT_EQ(branch.last_end.status, TraceStatus::parameter_bound);
  EXPECT_NEAR(branch.points.front().parameter, 1, 1e-14);
  EXPECT_NEAR(branch.points.back().parameter, 1, 1e-14);
  EXPECT_NEAR(branch.points.front().state(0) * branch.points.back().state(0), -1, 1e-12);
  EXPECT_LT(worst_residual(field, vector({0}), branch), 1e-11);
  for (const Equilibrium& point : branch.points) {
    EXPECT_NEAR(point.eigenvalues(0).real(), -2 * point.state(0), 1e-10);
    EXPECT_EQ(point.unstable, point.state(0) < 0 ? 1 : 0);
  }
}

TEST(Continuation, PitchforkByHand) {
  const VectorField field = pitchfork_field();
  const ContinuationOptions options = between(-1, 1);
  const Branch trivial = continue_fixed_points(field, vector({-0.5}), 0, vector({0}), options);
  ASSERT_EQ(trivial.special.size(), 1u);
  const SpecialPoint& crossing = trivial.special.front();
  EXPECT_EQ(crossing.kind, SpecialKind::pitchfork);
  EXPECT_NEAR(crossing.at.parameter, 0, 1e-12);
  EXPECT_NEAR(std::abs(crossing.branches(0, 1)), 1, 1e-6);
  EXPECT_EQ(trivial.points.front().unstable, 0);
  EXPECT_EQ(trivial.points.back().unstable, 1);

  const Branch other = switch_branch(field, vector({0}), 0, crossing, options);
  EXPECT_LT(worst_residual(field, vector({0}), other), 1e-11);
  EXPECT_NEAR(other.points.front().state(0) * other.points.back().state(0), -1, 1e-12);
  for (const Equilibrium& point : other.points)
    EXPECT_NEAR(point.parameter, point.state(0) * point.state(0), 1e-10);
  ASSERT_EQ(other.special.size(), 1u);  // the pitchfork again, and no saddle-node beside it
  EXPECT_EQ(other.special.front().kind, SpecialKind::pitchfork);
}

TEST(Continuation, TranscriticalByHand) {
  const VectorField field = transcritical_field();
  const ContinuationOptions options = between(-1, 1);
  const Branch trivial = continue_fixed_points(field, vector({-0.5}), 0, vector({0}), options);
  ASSERT_EQ(trivial.special.size(), 1u);
  EXPECT_EQ(trivial.special.front().kind, SpecialKind::transcritical);
  EXPECT_NEAR(trivial.special.front().at.parameter, 0, 1e-12);
  const Branch other = switch_branch(field, vector({0}), 0, trivial.special.front(), options);
  for (const Equilibrium& point : other.points) EXPECT_NEAR(point.parameter, point.state(0), 1e-10);
  EXPECT_NEAR(std::abs(other.points.back().parameter - other.points.front().parameter), 2, 1e-12);
}

TEST(Continuation, StartOnASpecialPoint) {
  const Branch branch = continue_fixed_points(pitchfork_field(), vector({0}), 0, vector({0}), between(-1, 1));
  ASSERT_EQ(branch.special.size(), 1u);
  EXPECT_EQ(branch.special.front().kind, SpecialKind::pitchfork);
  EXPECT_NEAR(branch.special.front().at.parameter, 0, 1e-10);
}

TEST(Continuation, BrusselatorHopf) {
  const VectorField field = brusselator();
  for (const double a : {0.5, 1.0, 2.0}) {
    const Branch branch = continue_fixed_points(field, vector({a, 0.3}), 1, vector({a, 0.3 / a}), between(0.1, 8));
    ASSERT_EQ(branch.special.size(), 1u) << a;
    const SpecialPoint& hopf = branch.special.front();
    EXPECT_EQ(hopf.kind, SpecialKind::hopf);
    EXPECT_TRUE(hopf.polished);
    EXPECT_NEAR(hopf.at.parameter, 1 + a * a, 1e-10);
    EXPECT_NEAR(hopf.frequency, a, 1e-10);
    EXPECT_EQ(branch.points.back().unstable, 2);
  }
}

// Parameters sigma at which s (mu^2 + (sigma - c s)^2) = f^2 has a double root s, by bisection of the discriminant.
std::vector<double> duffing_folds(double mu, double c, double f, double lower, double upper) {
  const auto discriminant = [&](long double sigma) {
    const long double a3 = static_cast<long double>(c) * c, a2 = -2 * sigma * c,
                      a1 = static_cast<long double>(mu) * mu + sigma * sigma, a0 = -static_cast<long double>(f) * f;
    return 18 * a3 * a2 * a1 * a0 - 4 * a2 * a2 * a2 * a0 + a2 * a2 * a1 * a1 - 4 * a3 * a1 * a1 * a1 -
           27 * a3 * a3 * a0 * a0;
  };
  std::vector<double> roots;
  constexpr int cells = 4000;
  for (int i = 0; i < cells; ++i) {
    long double low = lower + (upper - lower) * i / cells, high = lower + (upper - lower) * (i + 1) / cells;
    if ((discriminant(low) > 0) == (discriminant(high) > 0)) continue;
    for (int k = 0; k < 100; ++k) {
      const long double middle = (low + high) / 2;
      ((discriminant(middle) > 0) == (discriminant(low) > 0) ? low : high) = middle;
    }
    roots.push_back(static_cast<double>(low));
  }
  return roots;
}

TEST(Continuation, DuffingFoldsAreRootsOfTheDiscriminant) {
  const double mu = 0.1, c = 0.7, f = 0.2;
  const VectorXd p = vector({mu, -2, c, f});
  const VectorField field = duffing();
  const Branch branch = continue_fixed_points(field, p, 1, vector({-0.09, 0}), between(-2, 6));
  const std::vector<double> expected = duffing_folds(mu, c, f, -2, 6);
  ASSERT_EQ(expected.size(), 2u);
  std::vector<double> found;
  for (const SpecialPoint& special : branch.special) {
    EXPECT_EQ(special.kind, SpecialKind::saddle_node);
    EXPECT_TRUE(special.polished);
    found.push_back(special.at.parameter);
  }
  std::sort(found.begin(), found.end());
  ASSERT_EQ(found.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(found[i], expected[i], 1e-10);
  EXPECT_LT(worst_residual(field, p, branch), 1e-10);
  const auto larger = [](const Equilibrium& a, const Equilibrium& b) { return a.state.norm() < b.state.norm(); };
  const auto peak = std::max_element(branch.points.begin(), branch.points.end(), larger);
  EXPECT_NEAR(peak->state.norm(), f / mu, 2e-2 * f / mu);  // of the response, at a = f/mu
  EXPECT_EQ(std::count_if(branch.points.begin(), branch.points.end(),
                          [](const Equilibrium& point) { return point.unstable > 1; }),
            0);
}

TEST(Continuation, SmallAmplitudesWithTheirTypicalMagnitude) {
  // The same oscillator with amplitudes of a tenth of a millimetre near 100 rad/s: z -> 1e-4 z, sigma -> omega -
  // 100.
  const double mu = 0.1, c = 0.7, f = 0.2, small = 1e-4;
  const VectorField unit = duffing();
  VectorField field(2, {"omega"}, [&](const ConstVector& x, const ConstVector& p, OutVector rate) {
    rate = small * unit.rate(x / small, vector({mu, p(0) - 100, c, f}));
  });
  field.set_typical(vector({small, small}), vector({100}));
  const Branch branch = continue_fixed_points(field, vector({98}), 0, vector({-9e-6, 0}), between(98, 106));
  const std::vector<double> expected = duffing_folds(mu, c, f, -2, 6);
  ASSERT_EQ(branch.special.size(), 2u);
  EXPECT_NEAR(branch.special[0].at.parameter, 100 + expected[1], 1e-9);
  EXPECT_NEAR(branch.special[1].at.parameter, 100 + expected[0], 1e-9);
}

TEST(Continuation, ParametricResonanceByHand) {
  const Parametric model;
  const VectorField field = model.field();
  const double sigma = 1;
  const ContinuationOptions options = between(0, 3);
  const Branch trivial = continue_fixed_points(field, vector({sigma, 0.1}), 1, vector({0, 0}), options);
  ASSERT_EQ(trivial.special.size(), 1u);
  const SpecialPoint& threshold = trivial.special.front();
  EXPECT_EQ(threshold.kind, SpecialKind::pitchfork);
  EXPECT_NEAR(threshold.at.parameter, model.threshold(sigma), 1e-11);

  const Branch response = switch_branch(field, vector({sigma, 0}), 1, threshold, options);
  std::vector<SpecialPoint> folds;
  for (const SpecialPoint& special : response.special)
    if (special.kind == SpecialKind::saddle_node) folds.push_back(special);
  ASSERT_EQ(folds.size(), 2u);  // at z and -z
  const double square = model.fold_square(sigma);
  for (const SpecialPoint& fold : folds) {
    EXPECT_NEAR(fold.at.state.squaredNorm(), square, 1e-10);
    EXPECT_NEAR(fold.at.parameter, model.forcing(square, sigma), 1e-11);
  }
  for (const Equilibrium& point : response.points)
    EXPECT_NEAR(model.forcing(point.state.squaredNorm(), sigma), point.parameter, 1e-9);
}

TEST(Continuation, SaddleNodeOfParametricResonanceWithoutCubicDamping) {
  // mu3 = 0: |eta| F = w mu there.
  Parametric model;
  model.mu3 = 0;
  const ContinuationOptions options = between(0, 3);
  const Branch trivial = continue_fixed_points(model.field(), vector({1, 0.1}), 1, vector({0, 0}), options);
  ASSERT_EQ(trivial.special.size(), 1u);
  const Branch response = switch_branch(model.field(), vector({1, 0}), 1, trivial.special.front(), options);
  const auto fold = std::find_if(response.special.begin(), response.special.end(),
                                 [](const SpecialPoint& s) { return s.kind == SpecialKind::saddle_node; });
  ASSERT_NE(fold, response.special.end());
  EXPECT_NEAR(model.eta * fold->at.parameter, model.w * model.mu, 1e-10);
}

TEST(Continuation, TongueBetweenTwoThresholds) {
  const Parametric model;
  const double f = 0.8;
  const double edge =
      2 / model.w * std::sqrt(model.eta * model.eta * f * f - model.w * model.w * model.mu * model.mu);
  const Branch trivial = continue_fixed_points(model.field(), vector({-3, f}), 0, vector({0, 0}), between(-4, 4));
  ASSERT_EQ(trivial.special.size(), 2u);
  EXPECT_NEAR(trivial.special[0].at.parameter, -edge, 1e-10);
  EXPECT_NEAR(trivial.special[1].at.parameter, edge, 1e-10);
  const Branch response = switch_branch(model.field(), vector({0, f}), 0, trivial.special[0], between(-4, 4));
  EXPECT_TRUE(response.closed);
  EXPECT_EQ(response.last_end.status, TraceStatus::closed_loop);
}

TEST(Continuation, ClosedLoop) {
  // A circle of fixed points x^2 + p^2 = 1 (an isola): saddle-nodes at p = +-1.
  const VectorField field(1, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
    rate(0) = 1 - x(0) * x(0) - p(0) * p(0);
  });
  const Branch branch = continue_fixed_points(field, vector({0.3}), 0, vector({0.9}), between(-2, 2));
  EXPECT_TRUE(branch.closed);
  ASSERT_EQ(branch.special.size(), 2u);
  for (const SpecialPoint& special : branch.special) EXPECT_NEAR(std::abs(special.at.parameter), 1, 1e-12);
  EXPECT_EQ(branch.points.front().state, branch.points.back().state);
}

TEST(Continuation, CombinationResonanceLosesStabilityToAPair) {
  Combination model;
  const Branch trivial =
      continue_fixed_points(model.field(), vector({0.5, 0.01}), 1, VectorXd::Zero(4), between(0, 1));
  ASSERT_EQ(trivial.special.size(), 1u);
  EXPECT_EQ(trivial.special[0].kind, SpecialKind::hopf);
  EXPECT_NEAR(trivial.special[0].at.parameter, model.threshold(0.5), 1e-11);
  EXPECT_NEAR(trivial.special[0].frequency, model.frequency(0.5), 1e-10);

  model.mu2 = model.mu1;
  const Branch equal =
      continue_fixed_points(model.field(), vector({0.5, 0.01}), 1, VectorXd::Zero(4), between(0, 1));
  ASSERT_EQ(equal.special.size(), 1u);
  EXPECT_EQ(equal.special[0].kind, SpecialKind::double_zero);
  EXPECT_NEAR(equal.special[0].at.parameter, model.threshold(0.5), 1e-9);
}

TEST(Continuation, CirclesOfFixedPoints) {
  // Equal dampings, z1 = z2 = z: as the parametric resonance, (c a^2 - sigma/2)^2 + mu^2 = F^2, with a free phase.
  Combination model;
  model.mu2 = model.mu1;
  model.cubic = 0.5;
  const double sigma = 0.2, f = 0.4;
  const double a = std::sqrt((sigma / 2 + std::sqrt(f * f - model.mu1 * model.mu1)) / model.cubic);
  // z' = 0 at z1 = a, z2* = -(mu + i sigma/2 - i c a^2) a / (i F).
  const std::complex<double> i(0, 1);
  const std::complex<double> z2 = std::conj(-(model.mu1 + i * (sigma / 2 - model.cubic * a * a)) * a / (i * f));
  const VectorXd start = vector({a, 0, z2.real(), z2.imag()});
  const Branch branch = continue_fixed_points(model.field(), vector({sigma, f}), 1, start, between(0, 1));
  EXPECT_EQ(branch.first_end.status, TraceStatus::parameter_bound);
  EXPECT_EQ(branch.last_end.status, TraceStatus::parameter_bound);
  int folds = 0;
  for (const SpecialPoint& special : branch.special) {
    if (special.kind != SpecialKind::saddle_node || special.at.state.norm() < 0.1) continue;
    ++folds;
    EXPECT_NEAR(special.at.parameter, model.mu1, 1e-10);
    EXPECT_NEAR(special.at.state.squaredNorm() / 2, sigma / 2 / model.cubic, 1e-8);
  }
  EXPECT_EQ(folds, 2);
}

TEST(Continuation, NeutralSaddlesAreNoHopfPoints) {
  // Eigenvalues p and -1: their sum vanishes at p = 1; only p = 0 is a branch point.
  const VectorField field(2, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
    rate(0) = p(0) * x(0) - x(0) * x(0) * x(0);
    rate(1) = -x(1);
  });
  const Branch branch = continue_fixed_points(field, vector({-0.5}), 0, vector({0, 0}), between(-1, 3));
  ASSERT_EQ(branch.special.size(), 1u);
  EXPECT_EQ(branch.special.front().kind, SpecialKind::pitchfork);
}

TEST(Continuation, FailureIsAStatus) {
  // x' = p + x^2 has no fixed point for p > 0.
  const VectorField field(
      1, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) { rate(0) = p(0) + x(0) * x(0); });
  const Branch none = continue_fixed_points(field, vector({0.5}), 0, vector({1}), between(0.1, 1));
  EXPECT_TRUE(none.points.empty());
  EXPECT_EQ(none.first_end.status, TraceStatus::no_start);
  EXPECT_FALSE(none.first_end.reason.empty());

  // A right side that ends at x = 0.5 with p = x.
  const VectorField ends(1, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
    rate(0) = x(0) < 0.5 ? p(0) - x(0) : std::numeric_limits<double>::quiet_NaN();
  });
  const Branch broken = continue_fixed_points(ends, vector({0.2}), 0, vector({0.2}), between(0, 1));
  EXPECT_EQ(broken.last_end.status, TraceStatus::step_too_small);
  EXPECT_GT(broken.points.back().parameter, 0.49);
}

TEST(Continuation, StateBoundEndsTheBranch) {
  ContinuationOptions options = between(-1, 4);
  options.state_bound = 1.5;
  const Branch branch = continue_fixed_points(saddle_node_field(), vector({0.5}), 0, vector({0.7}), options);
  EXPECT_EQ(branch.first_end.status, TraceStatus::state_bound);
  EXPECT_EQ(branch.last_end.status, TraceStatus::state_bound);
  EXPECT_NEAR(branch.points.back().parameter, 2.25, 1e-10);
  const Branch outside = continue_fixed_points(saddle_node_field(), vector({3}), 0, vector({1.7}), options);
  EXPECT_EQ(outside.first_end.status, TraceStatus::no_start);
}

TEST(Continuation, MisuseIsRefused) {
  const VectorField field = saddle_node_field();
  EXPECT_THROW(continue_fixed_points(field, vector({0.5}), 1, vector({0.7}), between(0, 1)), std::invalid_argument);
  EXPECT_THROW(continue_fixed_points(field, vector({0.5}), 0, vector({0.7}), between(1, 0)), std::invalid_argument);
  EXPECT_THROW(continue_fixed_points(field, vector({2}), 0, vector({1.4}), between(0, 1)), std::invalid_argument);
  EXPECT_THROW(switch_branch(field, vector({0}), 0, SpecialPoint{}, between(0, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace secular
