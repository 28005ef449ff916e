#include "motion/response/response_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "combination_case.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "parametric_case.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::Index;
using Eigen::VectorXd;

template <class Wanted>
std::vector<ResponseSpecial> special_points(const ResponseDiagram& diagram, const Wanted& wanted) {
  std::vector<ResponseSpecial> found;
  for (const ResponseBranch& branch : diagram.branches)
    for (const ResponseSpecial& special : branch.special)
      if (wanted(special)) found.push_back(special);
  return found;
}

double peak(const ResponsePoint& point, std::size_t mode = 0) {
  return 2 * std::abs(point.modes.amplitude[mode]);
}

TEST(PrincipalParametric, ResponsesFulfilTheFrequencyResponseRelation) {
  const Parametric known;
  const ResponseField field(two_mass(), case_named(two_mass(), "principal_parametric"));
  EXPECT_FALSE(field.is_reduced());
  const ResponseDiagram diagram = response_diagram(field, known.request());
  EXPECT_EQ(diagram.status, DiagramStatus::complete) << diagram.reason;
  std::size_t moving = 0;
  for (const ResponseBranch& branch : diagram.branches)
    for (const ResponsePoint& point : branch.points) {
      if (point.at_rest) {
        const double inside = known.threshold_detuning(known.F) - std::abs(point.parameter - 2 * known.omega0);
        if (std::abs(inside) > 1e-6) {
          EXPECT_EQ(point.unstable > 0, inside > 0) << point.parameter;
        }
        continue;
      }
      if (peak(point) < 1e-6) continue;
      ++moving;
      EXPECT_NEAR(known.relation(peak(point), point.parameter, known.F), 1, 1e-9);
    }
  EXPECT_GT(moving, 50u);
}

TEST(PrincipalParametric, ThresholdsAndSaddleNodes) {
  const Parametric known;
  const ResponseField field(two_mass(), case_named(two_mass(), "principal_parametric"));
  const ResponseDiagram diagram = response_diagram(field, known.request());
  auto thresholds = special_points(
      diagram, [](const ResponseSpecial& s) { return s.at.at_rest && s.kind == SpecialKind::pitchfork; });
  std::sort(thresholds.begin(), thresholds.end(),
            [](const auto& a, const auto& b) { return a.at.parameter < b.at.parameter; });
  ASSERT_GE(thresholds.size(), 2u);
  EXPECT_NEAR(thresholds.front().at.parameter, 2 * known.omega0 - known.threshold_detuning(known.F), 1e-8);
  EXPECT_NEAR(thresholds.back().at.parameter, 2 * known.omega0 + known.threshold_detuning(known.F), 1e-8);
  // In the frequency: alpha_e a^2 - omega0 sigma/2 = R; the fold in sigma at fixed F has D kappa + alpha_e R = 0.
  const auto folds = special_points(
      diagram, [](const ResponseSpecial& s) { return s.kind == SpecialKind::saddle_node && !s.at.at_rest; });
  ASSERT_FALSE(folds.empty());
  for (const ResponseSpecial& fold : folds) {
    const double a2 = std::pow(peak(fold.at), 2), sigma = fold.at.parameter - 2 * known.omega0;
    const double d = known.omega0 * known.mu1 + known.kappa() * a2,
                 r = known.alpha_e * a2 - known.omega0 * sigma / 2;
    EXPECT_NEAR((d * known.kappa() + known.alpha_e * r) / (d * known.kappa()), 0, 1e-7);
    EXPECT_NEAR(known.relation(peak(fold.at), fold.at.parameter, known.F), 1, 1e-10);
    // D at the fold: (eta F)^2 = D^2 (1 + kappa^2/alpha_e^2).
    EXPECT_NEAR(d * std::hypot(1, known.kappa() / known.alpha_e), known.eta_e * known.F,
                1e-7 * known.eta_e * known.F);
  }
}

TEST(PrincipalParametric, CurvesInFrequencyAndForce) {
  const Parametric known;
  const ResponseField field(two_mass(), case_named(two_mass(), "principal_parametric"));
  CurveRequest request;
  request.response = known.request();
  request.second = place(two_mass(), "F");
  request.second_lower = 5;
  request.second_upper = 40;
  request.diagrams = 2;
  request.kind = CurveKind::threshold;
  const std::vector<ResponseCurve> thresholds = response_curves(field, request);
  ASSERT_EQ(thresholds.size(), 1u);
  double least = 1e9;
  for (const ResponseCurvePoint& at : thresholds[0].points) {
    EXPECT_NEAR(
        std::pow(known.omega0 * (at.first - 2 * known.omega0) / 2, 2) + std::pow(known.omega0 * known.mu1, 2),
        std::pow(known.eta_e * at.second, 2), 1e-8 * std::pow(known.eta_e * at.second, 2));
    least = std::min(least, at.second);
  }
  EXPECT_NEAR(least, known.omega0 * known.mu1 / known.eta_e, 0.01);  // Eq. (5.26)
  request.kind = CurveKind::saddle_node;
  const std::vector<ResponseCurve> folds = response_curves(field, request);
  ASSERT_FALSE(folds.empty());
  for (const ResponseCurve& curve : folds) {
    EXPECT_GT(curve.points.size(), 10u);
    for (const ResponseCurvePoint& at : curve.points) {
      const double d = known.omega0 * known.mu1 + known.kappa() * std::pow(2 * std::abs(at.modes.amplitude[0]), 2);
      EXPECT_NEAR(d * std::hypot(1, known.kappa() / known.alpha_e) / (known.eta_e * at.second), 1, 1e-6);
    }
  }
}

// The thesis calls the peaks of the response saddle-nodes: (5.31), eta_e F = omega0 mu1 + kappa a^2.
TEST(PrincipalParametric, Peaks) {
  const Parametric known;
  const ResponseField field(two_mass(), case_named(two_mass(), "principal_parametric"));
  CurveRequest request;
  request.response = known.request();
  request.response.lower -= 6;
  request.second = place(two_mass(), "F");
  request.second_lower = 10;
  request.second_upper = 40;
  request.kind = CurveKind::peak;
  request.diagrams = 2;
  const std::vector<ResponseCurve> peaks = response_curves(field, request);
  ASSERT_FALSE(peaks.empty());
  std::size_t points = 0;
  for (const ResponseCurve& curve : peaks)
    for (const ResponseCurvePoint& at : curve.points) {
      const double square = std::pow(2 * std::abs(at.modes.amplitude[0]), 2);
      EXPECT_NEAR((known.omega0 * known.mu1 + known.kappa() * square) / (known.eta_e * at.second), 1, 1e-5);
      ++points;
    }
  EXPECT_GT(points, 20u);
}

// The state of rest loses its stability at F^2 = mu1 mu2 (1 + s^2/(mu1 + mu2)^2), s = Omega - omega1 - omega2;
// moving solutions: with z_k = alpha |B_k|^2 and d = s/2, nu = their drift, mu1 |B1|^2 = mu2 |B2|^2 and (mu1 + i
// (nu + d - z1)) (mu2 - i (-nu + d - z2)) = F^2.
TEST(CombinationResonance, DriftsAlongItsCirclesAreComputed) {
  const CompiledModel& model = combination_model();
  const ResponseField field(model, model.cases[0]);
  ASSERT_TRUE(field.is_reduced());
  ASSERT_EQ(field.symmetries().rows(), 1);
  EXPECT_DOUBLE_EQ(field.symmetries()(0, 0), -field.symmetries()(0, 1));
  VectorXd p(combination_parameters + 2);
  p << 10, 27, 0.1, 0.3, 2e5, 37, 0.4;
  ResponseRequest request;
  request.parameters = p;
  request.parameter = combination_parameters;
  request.lower = 35.5;
  request.upper = 39.5;
  const ResponseDiagram diagram = response_diagram(field, request);
  const double edge = 0.4 * std::sqrt(0.4 * 0.4 / 0.03 - 1);
  const ResponseBranch& rest = diagram.branches[0];
  ASSERT_TRUE(rest.at_rest);
  const std::vector<ResponseSpecial>& thresholds = rest.special;
  ASSERT_EQ(thresholds.size(), 2u);
  EXPECT_NEAR(thresholds[0].at.parameter, 37 - edge, 1e-7);
  EXPECT_NEAR(thresholds[1].at.parameter, 37 + edge, 1e-7);
  // nu = s/2 (mu1 - mu2)/(mu1 + mu2) up to sign
  EXPECT_NEAR(std::abs(thresholds[0].at.modes.frequency_shift[0]), edge / 2 * 0.2 / 0.4, 1e-6);
  std::size_t moving = 0;
  bool stable = false;
  for (const ResponseBranch& branch : diagram.branches)
    for (const ResponsePoint& point : branch.points) {
      if (point.at_rest) {
        const double inside = edge - std::abs(point.parameter - 37);
        if (std::abs(inside) > 1e-6) {
          EXPECT_EQ(point.unstable > 0, inside > 0) << point.parameter;
        }
        continue;
      }
      const double s1 = std::norm(point.modes.amplitude[0]), s2 = std::norm(point.modes.amplitude[1]);
      const double nu = point.modes.frequency_shift[0], d = (point.parameter - 37) / 2;
      EXPECT_NEAR(point.modes.frequency_shift[1], -nu, 1e-12);
      EXPECT_NEAR(0.1 * s1, 0.3 * s2, 1e-8 * s1);
      const std::complex<double> product =
          std::complex<double>(0.1, nu + d - 2e5 * s1) * std::complex<double>(0.3, -(-nu + d - 2e5 * s2));
      EXPECT_NEAR(product.real(), 0.16, 1e-7);
      EXPECT_NEAR(product.imag(), 0, 1e-7);
      ++moving;
      stable = stable || point.unstable == 0;
      EXPECT_EQ(point.eigenvalues.size(), 3);
    }
  EXPECT_GT(moving, 30u);
  EXPECT_TRUE(stable);
  // The halves that mirror them are left out without a chord across.
  for (const ResponseBranch& branch : diagram.branches)
    for (std::size_t i = 1; i < branch.points.size(); ++i)
      EXPECT_LT(std::abs(branch.points[i].parameter - branch.points[i - 1].parameter), 0.1);
}

// a' = -mu a + f sin g, a g' = ...: folds of the Duffing oscillator at primary resonance where
// d f^2 / d a^2 = 0: mu^2 + (s - c a^2)(s - 3 c a^2) = 0, c = 3 alpha3/(8 omega0), s = Omega - omega0.
TEST(PrimaryResonance, DuffingFolds) {
  const CompiledModel& model = two_mass();
  const ResponseField field(model, case_named(model, "primary"));
  VectorXd p = VectorXd::Zero(static_cast<Index>(ResponseField::parameter_names(model).size()));
  p(place(model, "omega0")) = 10;
  p(place(model, "mu1")) = 0.05;
  p(place(model, "alpha3")) = 4e6;
  p(place(model, "eta1")) = 1;
  p(place(model, "Omega")) = 10;
  p(place(model, "F")) = 4e-3;
  ResponseRequest request;
  request.parameters = p;
  request.parameter = place(model, "Omega");
  request.lower = 9;
  request.upper = 13;
  const ResponseDiagram diagram = response_diagram(field, request);
  const auto folds =
      special_points(diagram, [](const ResponseSpecial& s) { return s.kind == SpecialKind::saddle_node; });
  ASSERT_EQ(folds.size(), 2u);
  const double c = 3 * 4e6 / 80;
  for (const ResponseSpecial& fold : folds) {
    const double a2 = std::pow(peak(fold.at), 2), s = fold.at.parameter - 10;
    EXPECT_NEAR(0.05 * 0.05 + (s - c * a2) * (s - 3 * c * a2), 0, 1e-7);
    EXPECT_NEAR(a2 * (0.05 * 0.05 + std::pow(s - c * a2, 2)), std::pow(4e-3 / 20, 2), 1e-12);
  }
}

TEST(Backbone, FrequencyAndDecayOfAFreeMode) {
  const Parametric known;
  const ResponseField field(two_mass(), case_named(two_mass(), "free"));
  EXPECT_TRUE(field.is_reduced());
  for (const BackbonePoint& at : backbone(field, known.parameters(), 0, 1e-3, 10)) {
    const double a2 = 4 * at.amplitude * at.amplitude;
    EXPECT_NEAR(at.frequency, known.omega0 + known.alpha_e * a2 / known.omega0, 1e-9);
    EXPECT_NEAR(at.growth, -known.mu1 - known.kappa() * a2 / known.omega0, 1e-9);
  }
}

}  // namespace
}  // namespace secular
