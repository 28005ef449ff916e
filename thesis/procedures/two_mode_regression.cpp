#include "thesis/procedures/two_mode_regression.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "input/numerical_failure.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr auto lump_count = static_cast<Index>(TwoModeLump::count);

// Plain least squares in columns of unit norm.
VectorXd solve(const MatrixXd& design, const VectorXd& response) {
  const VectorXd norm = design.colwise().norm().transpose().cwiseMax(1e-300);
  const MatrixXd unit = design * norm.cwiseInverse().asDiagonal();
  return norm.cwiseInverse().asDiagonal() * VectorXd(unit.colPivHouseholderQr().solve(response));
}

struct Systems {
  RealRegression first, second, combined;
  VectorXd lumps;
};

MatrixXd damping_columns(const VectorXd& own, const VectorXd& other, const TwoModeData& d) {
  MatrixXd columns(own.size(), 3);
  columns.col(0) = -own.array().cube();
  columns.col(1) = -d.forcing.array() * other.array() * d.gamma.array().sin();
  columns.col(2) = -d.forcing.array() * other.array() * d.gamma.array().cos();
  return columns;
}

// Designs for the rows `rows`; coefficients by plain least squares.
Systems assemble(const TwoModeData& all, const std::vector<Index>& rows, bool printed) {
  TwoModeData d;
  d.first = all.first(rows);
  d.second = all.second(rows);
  d.forcing = all.forcing(rows);
  d.gamma = all.gamma(rows);
  d.excitation_frequency = all.excitation_frequency(rows);
  const double w1 = all.omega1, w2 = all.omega2;
  Systems s;
  s.first.design = damping_columns(d.first, d.second, d);
  s.first.response = d.first;
  s.second.design = damping_columns(d.second, d.first, d);
  s.second.response = d.second;
  const VectorXd c1 = solve(s.first.design, s.first.response), c2 = solve(s.second.design, s.second.response);
  const double ratio6 = c1(2) / c1(1), ratio12 = c2(2) / c2(1);  // Gamma_6/Gamma_5, Gamma_12/Gamma_11
  const auto a1 = d.first.array(), a2 = d.second.array(), f = d.forcing.array();
  const Eigen::ArrayXd sine = d.gamma.array().sin(), cosine = d.gamma.array().cos();
  s.combined.design.resize(a1.size(), 5);
  s.combined.design.col(0) = a1 * a2;
  s.combined.design.col(1) = a1.cube() * a2;
  s.combined.design.col(2) = a1 * a2.cube();
  s.combined.design.col(3) = a1 * a2 * f.square();
  s.combined.design.col(4) =
      w2 * f * a2.square() * (cosine - ratio6 * sine) + w1 * f * a1.square() * (cosine - ratio12 * sine);
  if (printed) s.combined.design *= -1;
  s.combined.response = w1 * w2 * a1 * a2 * (d.excitation_frequency.array() - w1 - w2);
  const VectorXd c = solve(s.combined.design, s.combined.response);
  const double gamma5 = c(4), mu11 = gamma5 / (w1 * c1(1)), mu22 = gamma5 / (w2 * c2(1));
  s.lumps.resize(lump_count);
  s.lumps << mu11, mu22, c1(0) * 8 * mu11 / (3 * w1 * w1), c2(0) * 8 * mu22 / (3 * w2 * w2), gamma5,
      ratio6 * gamma5, ratio12 * gamma5, c(0), c(1), c(2), c(3);
  return s;
}

}  // namespace

std::string_view name_of(TwoModeLump lump) {
  static constexpr std::string_view names[] = {"mu11",
                                               "mu22",
                                               "mu13",
                                               "mu23",
                                               "Gamma_5",
                                               "Gamma_6",
                                               "Gamma_12",
                                               "w2 Gamma_1 + w1 Gamma_7",
                                               "w2 Gamma_2 + w1 Gamma_9",
                                               "w2 Gamma_3 + w1 Gamma_8",
                                               "w2 Gamma_4 + w1 Gamma_10"};
  return names[static_cast<std::size_t>(lump)];
}

TwoModeFit two_mode_regression(const TwoModeData& data, bool printed) {
  const Index count = data.first.size();
  const std::set<int> conditions(data.condition.begin(), data.condition.end());
  if (data.second.size() != count || data.forcing.size() != count || data.gamma.size() != count ||
      data.excitation_frequency.size() != count || data.condition.size() != static_cast<std::size_t>(count))
    throw std::invalid_argument("the data of two modes have different lengths");
  if (conditions.size() < 3 || count < 8)
    throw NumericalFailure(Ending::out_of_range, "it needs eight ensembles of three or more dwells; there are " +
                                                     std::to_string(count) + " of " +
                                                     std::to_string(conditions.size()));
  std::vector<Index> rows(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) rows[static_cast<std::size_t>(i)] = i;
  const Systems whole = assemble(data, rows, printed);
  TwoModeFit result;
  result.first = whole.first;
  result.second = whole.second;
  result.combined = whole.combined;
  for (RealRegression* regression : {&result.first, &result.second, &result.combined})
    regression->fit = linear_fit(regression->design, regression->response, data.condition);
  result.lumps = whole.lumps;
  // Delete one condition at a time through all three steps: the third uses the ratios that the first two found.
  VectorXd sum = VectorXd::Zero(lump_count), square = VectorXd::Zero(lump_count);
  for (const int left_out : conditions) {
    std::vector<Index> kept;
    for (Index i = 0; i < count; ++i)
      if (data.condition[static_cast<std::size_t>(i)] != left_out) kept.push_back(i);
    const VectorXd change = assemble(data, kept, printed).lumps - whole.lumps;
    sum += change;
    square += change.cwiseAbs2();
  }
  const auto groups = static_cast<double>(conditions.size());
  result.sd = ((groups - 1) / groups * (square - sum.cwiseAbs2() / groups)).cwiseMax(0.0).cwiseSqrt();
  return result;
}

}  // namespace secular
