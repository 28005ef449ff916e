#include "motion/response/bifurcation_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fields.hpp"
#include "motion/response/continuation.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::Index;
using Eigen::VectorXd;

BifurcationCurveOptions ranges(const ParameterRange& first, const ParameterRange& second) {
  BifurcationCurveOptions options;
  options.first = first;
  options.second = second;
  return options;
}

// The first special point of a kind on the branch through `state`.
SpecialPoint special_point(const VectorField& field, const VectorXd& p, const ParameterRange& varied,
                           const VectorXd& state, SpecialKind kind) {
  ContinuationOptions options;
  options.lower = varied.lower;
  options.upper = varied.upper;
  const Branch branch = continue_fixed_points(field, p, varied.parameter, state, options);
  for (const SpecialPoint& special : branch.special)
    if (special.kind == kind) return special;
  ADD_FAILURE() << "no " << name_of(kind);
  return {};
}

TEST(BifurcationCurve, Cusp) {
  const VectorField field = cusp_field();
  const SpecialPoint fold = special_point(field, vector({1, 0}), {1, -2, 2}, vector({1}), SpecialKind::saddle_node);
  EXPECT_NEAR(std::abs(fold.at.parameter), std::sqrt(4.0 / 27), 1e-11);
  const BifurcationCurve curve =
      continue_bifurcation(field, vector({1, fold.at.parameter}), fold, ranges({1, -2, 2}, {0, -1, 3}));
  EXPECT_EQ(curve.kind, BifurcationKind::saddle_node);
  EXPECT_EQ(curve.first_end.status, TraceStatus::parameter_bound);
  EXPECT_EQ(curve.last_end.status, TraceStatus::parameter_bound);
  EXPECT_GT(curve.points.size(), 30u);
  double least = 0, largest = 0;
  for (const BifurcationCurvePoint& point : curve.points) {
    const double q = point.first, p = point.second;
    EXPECT_NEAR(4 * p * p * p, 27 * q * q, 1e-9);
    EXPECT_NEAR(p, 3 * point.state(0) * point.state(0), 1e-9);
    least = std::min(least, q);
    largest = std::max(largest, q);
  }
  EXPECT_NEAR(least, -2, 1e-12);
  EXPECT_NEAR(largest, 2, 1e-12);
  ASSERT_EQ(curve.special.size(), 1u);
  EXPECT_EQ(curve.special[0].kind, CodimensionTwo::cusp);
  EXPECT_NEAR(curve.special[0].at.first, 0, 1e-9);
  EXPECT_NEAR(curve.special[0].at.second, 0, 1e-9);
}

TEST(BifurcationCurve, BrusselatorHopf) {
  const VectorField field = brusselator();
  const SpecialPoint hopf =
      special_point(field, vector({1, 0.5}), {1, 0.1, 4}, vector({1, 0.5}), SpecialKind::hopf);
  const BifurcationCurve curve =
      continue_bifurcation(field, vector({1, hopf.at.parameter}), hopf, ranges({1, 0.1, 8}, {0, 0.2, 3}));
  EXPECT_EQ(curve.kind, BifurcationKind::hopf);
  ASSERT_GT(curve.points.size(), 10u);
  for (const BifurcationCurvePoint& point : curve.points) {
    EXPECT_NEAR(point.first, 1 + point.second * point.second, 1e-9);
    EXPECT_NEAR(point.frequency, point.second, 1e-9);
  }
  const auto [low, high] = std::minmax(curve.points.front().second, curve.points.back().second);
  EXPECT_NEAR(low, 0.2, 1e-12);
  EXPECT_NEAR(high, std::sqrt(7.0), 1e-9);
}

TEST(BifurcationCurve, BogdanovTakens) {
  const VectorField field = bogdanov_takens();
  // Hopf at b1 = 0 in b1 for b2 = -1, on the branch through x = 0 (the focus side x < -b2/2).
  const SpecialPoint hopf =
      special_point(field, vector({-0.2, -1}), {0, -1, 0.2}, vector({-0.17, 0}), SpecialKind::hopf);
  EXPECT_NEAR(hopf.at.parameter, 0, 1e-11);
  EXPECT_NEAR(hopf.frequency, 1, 1e-11);
  const BifurcationCurve hopf_curve =
      continue_bifurcation(field, vector({hopf.at.parameter, -1}), hopf, ranges({0, -1, 1}, {1, -2, 1}));
  ASSERT_EQ(hopf_curve.special.size(), 1u);
  EXPECT_EQ(hopf_curve.special[0].kind, CodimensionTwo::bogdanov_takens);
  EXPECT_NEAR(hopf_curve.special[0].at.second, 0, 1e-9);
  EXPECT_TRUE(hopf_curve.first_end.status == TraceStatus::special_end ||
              hopf_curve.last_end.status == TraceStatus::special_end);
  for (const BifurcationCurvePoint& point : hopf_curve.points) {
    EXPECT_NEAR(point.first, 0, 1e-9);
    EXPECT_NEAR(point.frequency * point.frequency, -point.second, 1e-9);
  }

  const SpecialPoint fold =
      special_point(field, vector({-0.2, -1}), {0, -1, 0.5}, vector({-0.17, 0}), SpecialKind::saddle_node);
  EXPECT_NEAR(fold.at.parameter, 0.25, 1e-11);
  const BifurcationCurve fold_curve =
      continue_bifurcation(field, vector({fold.at.parameter, -1}), fold, ranges({0, -1, 1}, {1, -2, 2}));
  for (const BifurcationCurvePoint& point : fold_curve.points)
    EXPECT_NEAR(4 * point.first, point.second * point.second, 1e-9);
  ASSERT_EQ(fold_curve.special.size(), 1u);
  EXPECT_EQ(fold_curve.special[0].kind, CodimensionTwo::bogdanov_takens);
  EXPECT_NEAR(fold_curve.special[0].at.second, 0, 1e-9);
}

TEST(BifurcationCurve, ThresholdOfParametricResonance) {
  const Parametric model;
  const SpecialPoint threshold =
      special_point(model.field(), vector({1, 0.1}), {1, 0, 3}, vector({0, 0}), SpecialKind::pitchfork);
  const BifurcationCurve curve = continue_bifurcation(model.field(), vector({1, threshold.at.parameter}), threshold,
                                                      ranges({1, 0, 3}, {0, -2, 2}));
  EXPECT_EQ(curve.kind, BifurcationKind::branch_point);
  ASSERT_GT(curve.points.size(), 20u);
  for (const BifurcationCurvePoint& point : curve.points)
    EXPECT_NEAR(point.first, model.threshold(point.second), 1e-10);
  EXPECT_NEAR(std::abs(curve.points.front().second - curve.points.back().second), 4, 1e-12);
}

TEST(BifurcationCurve, SaddleNodesOfParametricResonance) {
  const Parametric model;
  const VectorField field = model.field();
  const double sigma = 1;
  const SpecialPoint threshold =
      special_point(field, vector({sigma, 0.1}), {1, 0, 3}, vector({0, 0}), SpecialKind::pitchfork);
  ContinuationOptions options;
  options.upper = 3;
  const Branch response = switch_branch(field, vector({sigma, 0}), 1, threshold, options);
  const auto fold = std::find_if(response.special.begin(), response.special.end(),
                                 [](const SpecialPoint& s) { return s.kind == SpecialKind::saddle_node; });
  ASSERT_NE(fold, response.special.end());
  const BifurcationCurve curve =
      continue_bifurcation(field, vector({sigma, fold->at.parameter}), *fold, ranges({1, 0, 3}, {0, 0, 3}));
  ASSERT_GT(curve.points.size(), 20u);
  // The exact saddle-node: |eta| F = (w mu + kappa a^2) sqrt(1 + (kappa/ae)^2).
  const double factor = std::hypot(1, model.kappa() / model.ae);
  for (const BifurcationCurvePoint& point : curve.points) {
    const double square = point.state.squaredNorm();
    EXPECT_NEAR(model.eta * point.first, (model.w * model.mu + model.kappa() * square) * factor, 1e-9);
    EXPECT_NEAR(square, model.fold_square(point.second), 1e-9);
  }
}

TEST(BifurcationCurve, DuffingFoldsMeetInACusp) {
  // s = a^2 with d f^2/ds = d^2 f^2/ds^2 = 0: sigma = sqrt(3) mu, f^2 = 8 mu^3 / (3 sqrt(3) c) at the cusp.
  const double mu = 0.1, c = 0.7;
  const VectorField field = duffing();
  const SpecialPoint fold =
      special_point(field, vector({mu, -2, c, 0.2}), {1, -2, 6}, vector({-0.09, 0}), SpecialKind::saddle_node);
  const BifurcationCurve curve =
      continue_bifurcation(field, vector({mu, fold.at.parameter, c, 0.2}), fold, ranges({1, -2, 4}, {3, 0, 0.4}));
  ASSERT_EQ(curve.special.size(), 1u);
  EXPECT_EQ(curve.special[0].kind, CodimensionTwo::cusp);
  EXPECT_NEAR(curve.special[0].at.first, std::sqrt(3.0) * mu, 1e-9);
  EXPECT_NEAR(curve.special[0].at.second, std::sqrt(8 * mu * mu * mu / (3 * std::sqrt(3.0) * c)), 1e-9);
  for (const BifurcationCurvePoint& point : curve.points) {
    const double s = point.state.squaredNorm();
    EXPECT_NEAR(3 * c * c * s * s - 4 * point.first * c * s + mu * mu + point.first * point.first, 0, 1e-9);
  }
}

TEST(BifurcationCurve, TongueOfCombinationResonance) {
  const Combination model;
  const SpecialPoint hopf =
      special_point(model.field(), vector({0.5, 0.01}), {1, 0, 1}, VectorXd::Zero(4), SpecialKind::hopf);
  const BifurcationCurve curve =
      continue_bifurcation(model.field(), vector({0.5, hopf.at.parameter}), hopf, ranges({1, 0, 1}, {0, -1, 1}));
  ASSERT_GT(curve.points.size(), 20u);
  EXPECT_NEAR(std::abs(curve.points.front().second - curve.points.back().second), 2, 1e-12);
  for (const BifurcationCurvePoint& point : curve.points) {
    const double frequency = model.frequency(point.second);
    EXPECT_NEAR(point.first, model.threshold(point.second), 1e-9);
    EXPECT_NEAR(point.frequency * point.frequency, frequency * frequency, 1e-10);
  }
}

TEST(BifurcationCurve, UnfoldedBranchPointsEnd) {
  // x' = p x - x^2 + q: a transcritical point only at q = 0.
  const VectorField field(1, {"p", "q"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
    rate(0) = p(0) * x(0) - x(0) * x(0) + p(1);
  });
  const SpecialPoint crossing =
      special_point(field, vector({-0.5, 0}), {0, -1, 1}, vector({0}), SpecialKind::transcritical);
  const BifurcationCurve curve =
      continue_bifurcation(field, vector({crossing.at.parameter, 0}), crossing, ranges({0, -1, 1}, {1, -1, 1}));
  EXPECT_EQ(curve.first_end.status, TraceStatus::not_persistent);
  EXPECT_EQ(curve.last_end.status, TraceStatus::not_persistent);
  EXPECT_EQ(curve.points.size(), 1u);
}

TEST(BifurcationCurve, MisuseIsRefused) {
  const VectorField field = cusp_field();
  SpecialPoint fold;
  fold.kind = SpecialKind::saddle_node;
  fold.at.state = vector({0});
  EXPECT_THROW(continue_bifurcation(field, vector({0, 0}), fold, ranges({0, -1, 1}, {0, -1, 1})),
               std::invalid_argument);
  EXPECT_THROW(continue_bifurcation(field, vector({0, 2}), fold, ranges({0, -1, 1}, {1, -1, 1})),
               std::invalid_argument);
  fold.kind = SpecialKind::double_zero;
  EXPECT_THROW(continue_bifurcation(field, vector({0, 0}), fold, ranges({0, -1, 1}, {1, -1, 1})),
               std::invalid_argument);
}

}  // namespace
}  // namespace secular
