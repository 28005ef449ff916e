// The thesis's procedures for two modes on exact steady states of the generated modulation equations.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <map>

#include "generated/registry.hpp"
#include "input/numerical_failure.hpp"
#include "motion/response/response_curve.hpp"
#include "thesis/procedures/added_last_anova.hpp"
#include "thesis/procedures/engine_lumps.hpp"
#include "thesis/procedures/two_mode_regression.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double omega1 = 77.84866595595507, omega2 = 208.41325663914688;

const CompiledModel& two_modes() {
  return *generated::find_compiled_model("two_mass_lumps");
}
const CompiledCase& combination() {
  return two_modes().cases.front();
}

VectorXd table_6_2() {
  const std::map<std::string_view, double> values = {{"omega1", omega1},
                                                     {"omega2", omega2},
                                                     {"mu11", 0.273},
                                                     {"mu22", 0.293},
                                                     {"mu13", 229},
                                                     {"mu23", 1006},
                                                     {"lambda", 5.633038986731538},
                                                     {"alpha1", 1430491217.9820237},
                                                     {"alpha2", -12091836408.165524},
                                                     {"kappa", -0.1491267902109167},
                                                     {"p", -6.604},
                                                     {"q1", -0.002592925271234858},
                                                     {"q2", -0.01757255546002525}};
  VectorXd p(static_cast<Index>(two_modes().symbols.size()));
  for (std::size_t s = 0; s < two_modes().symbols.size(); ++s)
    p(static_cast<Index>(s)) = values.at(two_modes().symbols[s].name);
  return p;
}

// Table 6.2 with the signs that (6.34) should have; what the lumps of the model mean stands in its file.
TEST(EngineLumps, AreThoseOfTable62) {
  const VectorXd lumps = two_mode_lumps(two_modes(), combination(), table_6_2());
  const double expected[] = {0.273, 0.293, 229, 1006, 1.651, -0.1351, -0.342, 587, 111.8e9, -353e9, -7.77};
  for (int l = 0; l < static_cast<int>(TwoModeLump::count); ++l)
    EXPECT_NEAR(lumps(l), expected[l], 1e-9 * std::abs(expected[l])) << name_of(static_cast<TwoModeLump>(l));
}

// Stable responses over the excitation frequency at several levels.
const TwoModeData& steady_states() {
  static const TwoModeData result = [] {
    const ResponseField field(two_modes(), combination());
    const VectorXd base = table_6_2();
    TwoModeData data;
    data.omega1 = omega1;
    data.omega2 = omega2;
    std::vector<std::array<double, 5>> rows;
    for (const double force : {23.3, 28.0}) {
      ResponseRequest request;
      request.parameters.resize(base.size() + 2);
      request.parameters << base, omega1 + omega2, force;
      request.parameter = base.size();
      request.lower = omega1 + omega2 - 0.6;
      request.upper = omega1 + omega2 + 1.4;
      const ResponseDiagram diagram = response_diagram(field, request);
      for (const ResponseBranch& branch : diagram.branches)
        for (const ResponsePoint& point : branch.points) {
          if (point.at_rest || point.unstable > 0 || std::abs(point.modes.amplitude[0]) < 1e-6) continue;
          const Complex b1 = point.modes.amplitude[0], b2 = point.modes.amplitude[1];
          rows.push_back({2 * std::abs(b1), 2 * std::abs(b2), force, std::arg(std::conj(b1) * std::conj(b2)),
                          point.parameter});
        }
    }
    const auto count = static_cast<Index>(rows.size());
    for (VectorXd* v : {&data.first, &data.second, &data.forcing, &data.gamma, &data.excitation_frequency})
      v->resize(count);
    for (Index i = 0; i < count; ++i) {
      const auto& row = rows[static_cast<std::size_t>(i)];
      data.first(i) = row[0];
      data.second(i) = row[1];
      data.forcing(i) = row[2];
      data.gamma(i) = row[3];
      data.excitation_frequency(i) = row[4];
      data.condition.push_back(static_cast<int>(i));
    }
    return data;
  }();
  return result;
}

TEST(SlowTwoModeRegression, CorrectedReturnsTheLumpsOfTheEngine) {
  const TwoModeData& data = steady_states();
  ASSERT_GE(data.first.size(), 14);
  const VectorXd truth = two_mode_lumps(two_modes(), combination(), table_6_2());
  const TwoModeFit fit = two_mode_regression(data, false);
  EXPECT_LT(fit.first.fit.residual.norm(), 1e-9 * fit.first.response.norm());
  EXPECT_LT(fit.second.fit.residual.norm(), 1e-9 * fit.second.response.norm());
  EXPECT_LT(fit.combined.fit.residual.norm(), 1e-7 * fit.combined.response.norm());
  for (int l = 0; l < static_cast<int>(TwoModeLump::count); ++l)
    EXPECT_NEAR(fit.lumps(l), truth(l), 1e-4 * std::abs(truth(l))) << name_of(static_cast<TwoModeLump>(l));
}

TEST(SlowTwoModeRegression, AsPrintedEveryLumpTurnsItsSign) {
  const TwoModeData& data = steady_states();
  const VectorXd right = two_mode_regression(data, false).lumps, printed = two_mode_regression(data, true).lumps;
  for (int l = 0; l < static_cast<int>(TwoModeLump::count); ++l)
    EXPECT_NEAR(printed(l), -right(l), 1e-9 * std::abs(right(l))) << name_of(static_cast<TwoModeLump>(l));
}

// The thesis's own arithmetic: sums of squares of Table D.1 give the F of Table D.3 with 310 - 3 degrees of
// freedom.
// How many dwells respond hangs on what was measured; lengths that differ do not.
TEST(TwoModeRegression, HasNoResultForFewDwells) {
  TwoModeData data;
  for (VectorXd* v : {&data.first, &data.second, &data.forcing, &data.gamma, &data.excitation_frequency})
    *v = VectorXd::LinSpaced(8, 1, 2);
  data.condition = {0, 0, 0, 0, 1, 1, 1, 1};
  EXPECT_THROW(two_mode_regression(data, false), NumericalFailure);
  data.condition.pop_back();
  EXPECT_THROW(two_mode_regression(data, false), std::invalid_argument);
}

TEST(AddedLastAnova, PartialFOfATextbookCase) {
  // y = 2 x1 + noise; x2 orthogonal to x1 by construction, so that its sum of squares is (x2.y)^2/|x2|^2.
  constexpr int n = 12;
  Eigen::MatrixXd design(n, 2);
  VectorXd y(n);
  std::vector<int> cluster;
  for (int i = 0; i < n; ++i) {
    design(i, 0) = std::cos(0.5 * i);
    design(i, 1) = std::sin(0.9 * i) + 0.1;
    cluster.push_back(i / 2);
    y(i) = 2 * design(i, 0) + 0.1 * std::sin(37.0 * i);
  }
  design.col(1) -= design.col(0) * design.col(0).dot(design.col(1)) / design.col(0).squaredNorm();
  const AnovaTable table = added_last_anova(design, y, cluster, {{"x1", {0}}, {"x2", {1}}, {"both", {0, 1}}});
  const double residual = table.residual;
  const double ss2 = std::pow(design.col(1).dot(y), 2) / design.col(1).squaredNorm();
  EXPECT_NEAR(table.rows[1].sum_of_squares, ss2, 1e-12);
  EXPECT_NEAR(table.rows[1].f, ss2 / (residual / (n - 2)), 1e-9);
  EXPECT_EQ(table.residual_degrees_of_freedom, n - 2);
  EXPECT_NEAR(table.rows[2].sum_of_squares, y.squaredNorm() - residual, 1e-12);
  EXPECT_LT(table.rows[0].p, 1e-9);
  EXPECT_EQ(table.clusters, 6);
  // A single column's clustered F is the square of Student's t.
  EXPECT_GT(table.rows[0].clustered_f, 100);
  EXPECT_GT(table.rows[0].clustered_p, table.rows[0].p) << "six conditions say less than twelve rows";
}

TEST(AddedLastAnova, TwoColumnsThatNeedEachOther) {
  // Nearly parallel columns: neither is significant when added last, both together are (Table D.5's a1 a2^3, a1^3
  // a2).
  constexpr int n = 60;
  Eigen::MatrixXd design(n, 2);
  VectorXd y(n);
  std::vector<int> cluster;
  for (int i = 0; i < n; ++i) {
    const double x = 1 + 0.01 * i, noise = std::sin(12.9898 * i * i);
    design(i, 0) = x;
    design(i, 1) = x + 1e-4 * std::cos(3.0 * i);
    y(i) = 0.5 * design(i, 0) + 0.5 * design(i, 1) + 0.05 * noise;
    cluster.push_back(i / 4);
  }
  const AnovaTable table = added_last_anova(design, y, cluster, {{"a", {0}}, {"b", {1}}, {"a, b", {0, 1}}});
  EXPECT_GT(table.rows[0].p, 0.01);
  EXPECT_GT(table.rows[1].p, 0.01);
  EXPECT_LT(table.rows[2].p, 1e-20);
  EXPECT_LT(table.rows[2].clustered_p, 1e-6);
}

// A column that another one holds takes nothing away, alone; together they are one term of one degree of freedom.
TEST(AddedLastAnova, AColumnThatTheOthersHoldIsNotTested) {
  constexpr int n = 24;
  Eigen::MatrixXd design(n, 3);
  VectorXd y(n);
  std::vector<int> cluster;
  for (int i = 0; i < n; ++i) {
    design.row(i) << std::cos(0.7 * i), std::sin(0.4 * i), -2.5 * std::cos(0.7 * i);
    y(i) = design(i, 0) + 0.1 * std::sin(37.0 * i);
    cluster.push_back(i / 4);
  }
  const AnovaTable table =
      added_last_anova(design, y, cluster, {{"a", {0}}, {"b", {1}}, {"c", {2}}, {"a, c", {0, 2}}});
  const AnovaTable without = added_last_anova(design.leftCols(2), y, cluster, {{"a", {0}}, {"b", {1}}});
  for (const int held : {0, 2}) {
    const AnovaRow& row = table.rows[static_cast<std::size_t>(held)];
    EXPECT_EQ(row.degrees_of_freedom, 0);
    EXPECT_EQ(row.sum_of_squares, 0);
    EXPECT_TRUE(std::isnan(row.f));
    EXPECT_TRUE(std::isnan(row.p));
    EXPECT_TRUE(std::isnan(row.clustered_p));
  }
  EXPECT_EQ(table.residual_degrees_of_freedom, n - 2);
  EXPECT_NEAR(table.rows[1].f, without.rows[1].f, 1e-9 * without.rows[1].f);
  EXPECT_EQ(table.rows[3].degrees_of_freedom, 1);
  EXPECT_NEAR(table.rows[3].f, without.rows[0].f, 1e-9 * without.rows[0].f);
}

}  // namespace
}  // namespace secular
