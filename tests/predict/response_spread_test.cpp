// Error bars of responses from those of parameters, against closed forms and against solutions that are found anew.
#include "motion/response/response_spread.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "combination_case.hpp"
#include "estimator/model/by_name.hpp"
#include "motion/response/response_peaks.hpp"
#include "parametric_case.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Two directions of one standard deviation each: all but mu3 together, and mu3.
Parametric moved(Parametric known, int direction, double share) {
  if (direction == 0) {
    known.omega0 += share * 2e-3;
    known.mu1 -= share * 1e-3;
    known.alpha_e += share * 3e4;
    known.eta_e += share * 5e-3;
  } else {
    known.mu3 += share * 0.2;
  }
  return known;
}

MatrixXd directions_of(const Parametric& known) {
  MatrixXd directions(known.parameters().size(), 2);
  for (int d = 0; d < 2; ++d)
    directions.col(d) = (moved(known, d, 1).parameters() - moved(known, d, -1).parameters()) / 2;
  // The excitation is what is set.
  directions.row(place(two_mass(), "Omega")).setZero();
  return directions;
}

// By first order, of what a closed form says.
double sd_of(const Parametric& known, const std::function<double(const Parametric&)>& value) {
  constexpr double h = 1e-3;
  double sum = 0;
  for (int d = 0; d < 2; ++d)
    sum += std::pow((value(moved(known, d, h)) - value(moved(known, d, -h))) / (2 * h), 2);
  return std::sqrt(sum);
}

// (eta_e F)^2 = D^2 (1 + kappa^2/alpha_e^2) at the fold.
double fold_frequency(const Parametric& known) {
  const double d = known.eta_e * known.F / std::hypot(1, known.kappa() / known.alpha_e);
  const double square = (d - known.omega0 * known.mu1) / known.kappa(), r = -d * known.kappa() / known.alpha_e;
  return 2 * known.omega0 + 2 * (known.alpha_e * square - r) / known.omega0;
}

class ParametricSpread : public testing::Test {
 protected:
  ParametricSpread()
      : field_(two_mass(), case_named(two_mass(), "principal_parametric")),
        request_(known_.request()),
        diagram_(response_diagram(field_, request_)),
        spread_(field_, {request_.parameters, directions_of(known_)}, request_.parameter,
                request_.upper - request_.lower, diagram_.scale) {}

  Parametric known_;
  ResponseField field_;
  ResponseRequest request_;
  ResponseDiagram diagram_;
  ResponseSpread spread_;
};

TEST_F(ParametricSpread, IsThatOfTheFrequencyResponseRelation) {
  std::size_t compared = 0;
  for (const ResponseBranch& branch : diagram_.branches)
    for (const ResponsePoint& point : branch.points) {
      const double a = 2 * std::abs(point.modes.amplitude[0]);
      if (point.at_rest || a < 1e-4) continue;
      const std::vector<CurveSpread> spread = spread_.of(point);
      ASSERT_EQ(spread.size(), 1U);
      const auto relation = [&](double amplitude, double frequency) {
        return known_.relation(amplitude, frequency, known_.F);
      };
      const double by_parameters =
          sd_of(known_, [&](const Parametric& p) { return p.relation(a, point.parameter, p.F); });
      const double ha = 1e-5 * a, ho = 1e-5;
      const double by_amplitude =
          (relation(a + ha, point.parameter) - relation(a - ha, point.parameter)) / (2 * ha);
      const double by_frequency =
          (relation(a, point.parameter + ho) - relation(a, point.parameter - ho)) / (2 * ho);
      EXPECT_NEAR(2 * spread[0].amplitude / std::abs(by_parameters / by_amplitude), 1, 1e-3) << point.parameter;
      EXPECT_NEAR(spread[0].parameter / std::abs(by_parameters / by_frequency), 1, 1e-3) << point.parameter;
      // Along the normal that goes both ways: relation(across) = what one standard deviation makes of it.
      EXPECT_NEAR(
          std::abs(2 * spread[0].across_amplitude * by_amplitude + spread[0].across_parameter * by_frequency) /
              by_parameters,
          1, 1e-3)
          << point.parameter;
      ++compared;
    }
  EXPECT_GT(compared, 50U);
}

TEST_F(ParametricSpread, OfSpecialPointsIsThatOfTheirFormulas) {
  const double fold = sd_of(known_, fold_frequency);
  std::size_t folds = 0, thresholds = 0;
  for (const ResponseBranch& branch : diagram_.branches)
    for (const ResponseSpecial& special : branch.special) {
      const std::optional<double> sd = spread_.of(special);
      const double a = 2 * std::abs(special.at.modes.amplitude[0]);
      if (special.kind == SpecialKind::saddle_node && a > 1e-4) {
        ASSERT_TRUE(sd);
        EXPECT_NEAR(*sd / fold, 1, 1e-3);
        ++folds;
      }
      if (!branch.at_rest || special.kind != SpecialKind::pitchfork) continue;
      const double side = special.at.parameter > 2 * known_.omega0 ? 1 : -1;
      ASSERT_TRUE(sd);
      EXPECT_NEAR(
          *sd / sd_of(known_, [&](const Parametric& p) { return 2 * p.omega0 + side * p.threshold_detuning(p.F); }),
          1, 1e-3);
      ++thresholds;
    }
  EXPECT_GE(folds, 1U);
  EXPECT_EQ(thresholds, 2U);
}

// At the peak the two frequencies of an amplitude merge: eta_e F = omega0 mu1 + kappa a^2, where sigma is twice
// alpha_e a^2/omega0. It lies next to a fold, and between points of the branch.
TEST_F(ParametricSpread, OfThePeakIsThatOfItsFormula) {
  const auto amplitude = [](const Parametric& p) {
    return std::sqrt((p.eta_e * p.F - p.omega0 * p.mu1) / p.kappa());
  };
  const auto frequency = [&](const Parametric& p) {
    return 2 * p.omega0 + 2 * p.alpha_e * std::pow(amplitude(p), 2) / p.omega0;
  };
  const auto largest = [](const ResponseDiagram& diagram) {
    double most = 0;
    for (const ResponseBranch& branch : diagram.branches)
      for (const ResponsePoint& point : branch.points)
        most = std::max(most, 2 * std::abs(point.modes.amplitude[0]));
    return most;
  };
  EXPECT_LT(largest(diagram_), amplitude(known_) * (1 - 1e-9));  // the grid passes beside it
  add_peaks(field_, request_, diagram_);
  EXPECT_NEAR(largest(diagram_) / amplitude(known_), 1, 1e-12);
  std::size_t peaks = 0;
  for (const ResponseBranch& branch : diagram_.branches)
    for (const ResponsePoint& point : branch.points) {
      if (point.peaks.empty()) continue;
      EXPECT_EQ(point.peaks.size(), 1U);
      EXPECT_EQ(point.peaks[0].mode, 0U);
      EXPECT_EQ(point.unstable, 0);
      EXPECT_NEAR(point.parameter, frequency(known_), 1e-9 * known_.omega0);
      EXPECT_NEAR(2 * spread_.of(point)[0].amplitude / sd_of(known_, amplitude), 1, 1e-5);
      const std::optional<double> place_sd = spread_.of_peak(point, 0);
      ASSERT_TRUE(place_sd);
      EXPECT_NEAR(*place_sd / sd_of(known_, frequency), 1, 1e-5);
      ++peaks;
    }
  EXPECT_GE(peaks, 1U);
}

// Responses that drift along circles: their solutions found anew with other parameters, at the same frequency.
TEST(CombinationSpread, IsThatOfSolutionsFoundAnew) {
  const CompiledModel& model = combination_model();
  const ResponseField field(model, model.cases[0]);
  ResponseRequest request;
  request.parameters.resize(combination_parameters + 2);
  request.parameters << 10, 27, 0.1, 0.3, 2e5, 37, 0.4;
  request.parameter = combination_parameters;
  request.lower = 35.5;
  request.upper = 38.5;
  MatrixXd directions = MatrixXd::Zero(request.parameters.size(), 2);
  directions.col(0).head(4) << 0.01, -0.003, 0.002, 0.004;
  directions(4, 1) = 3e3;
  const ResponseDiagram diagram = response_diagram(field, request);
  const ResponseSpread spread(field, {request.parameters, directions}, request.parameter, 3, diagram.scale);
  std::size_t points = 0, thresholds = 0;
  for (const ResponseBranch& branch : diagram.branches) {
    for (const ResponseSpecial& special : branch.special) {
      if (!branch.at_rest) continue;
      const auto place_of = [&](const VectorXd& p) {  // F^2 = mu1 mu2 (1 + s^2/(mu1 + mu2)^2)
        const double s = (p(2) + p(3)) * std::sqrt(p(6) * p(6) / (p(2) * p(3)) - 1);
        return p(0) + p(1) + (special.at.parameter > 37 ? s : -s);
      };
      ASSERT_NEAR(place_of(request.parameters), special.at.parameter, 1e-6);
      const VectorXd move = 1e-3 * directions.col(0);
      const double expected = (place_of(request.parameters + move) - place_of(request.parameters - move)) / 2e-3;
      const std::optional<double> sd = spread.of(special);
      ASSERT_TRUE(sd);
      EXPECT_NEAR(*sd / std::abs(expected), 1, 1e-3);
      ++thresholds;
    }
    for (std::size_t i = 5; i + 5 < branch.points.size(); i += 20) {
      const ResponsePoint& point = branch.points[i];
      const std::vector<CurveSpread> found = spread.of(point);
      if (point.at_rest || std::abs(point.modes.amplitude[0]) < 0.1 * diagram.scale) continue;
      ASSERT_EQ(found.size(), 2U);
      const VectorField reduced = field.reduced(diagram.scale, request.parameters);
      const auto solved = [&](VectorXd p) {
        p(request.parameter) = point.parameter;
        VectorXd x = point.state;
        for (int step = 0; step < 6; ++step) x -= reduced.jacobian(x, p).fullPivLu().solve(reduced.rate(x, p));
        return field.amplitudes(p, x);
      };
      for (std::size_t k = 0; k < 2; ++k) {
        double sum = 0;
        for (Index d = 0; d < 2; ++d) {
          const VectorXd move = 1e-3 * directions.col(d);
          sum += std::pow((std::abs(solved(request.parameters + move).amplitude[k]) -
                           std::abs(solved(request.parameters - move).amplitude[k])) /
                              2e-3,
                          2);
        }
        EXPECT_NEAR(found[k].amplitude / std::sqrt(sum), 1, 1e-3) << point.parameter;
      }
      ++points;
    }
  }
  EXPECT_GE(thresholds, 2U);
  EXPECT_GT(points, 3U);
}

// Frequency w0 + 3 alpha3 a^2/(8 w0) of a free decay, its rate mu1 and mu3.
TEST(BackboneSpread, IsThatOfTheTextbook) {
  const CompiledModel& model = two_mass();
  const ResponseField field(model, case_named(model, "free"));
  const Parametric known;
  VectorXd p = known.parameters();
  p.tail(2).setZero();
  MatrixXd directions = MatrixXd::Zero(p.size(), 2);
  directions(place(model, "alpha3"), 0) = 2e5;
  directions(place(model, "mu1"), 1) = 1e-3;
  constexpr double largest = 1e-3;
  const std::vector<BackboneSpread> spread = backbone_spread(field, {p, directions}, 0, largest, 4);
  ASSERT_EQ(spread.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const double b = largest * static_cast<double>(i + 1) / 4;
    EXPECT_NEAR(spread[i].frequency, 3 * 2e5 * b * b / (2 * known.omega0), 0.01 * spread[i].frequency);
    EXPECT_NEAR(spread[i].growth, 1e-3, 1e-6);
  }
}

}  // namespace
}  // namespace secular
