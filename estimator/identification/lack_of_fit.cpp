#include "estimator/identification/lack_of_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <utility>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Probability that a case whose equations hold shows a significant lack of fit.
constexpr double false_alarm = 0.001;

/// Fewer degrees of freedom among repeats say too little of the noise.
constexpr double fewest_repeats = 10;

using Equation = std::pair<std::size_t, EquationPart>;

Equation equation_of(const CaseFit& fit, Index row) {
  const auto at = static_cast<std::size_t>(row);
  return {fit.system.block[at], fit.system.part[at]};
}

std::string name_of(const CaseFit& fit, const Equation& equation) {
  const RegressorBlock& block = fit.set->resonance->blocks[equation.first];
  const bool in_phase = equation.second == EquationPart::in_phase;
  return std::string(block.name) + (block.kind == BlockKind::modulation
                                        ? (in_phase ? ", balance of energy" : ", balance of frequency")
                                        : (in_phase ? ", in phase" : ", in quadrature"));
}

// What is not known of the truncation that was subtracted from an equation, over the equation's noise: what each of
// the `unknown` ways in which parameters may move changes of it; half of all of it where that is not known.
VectorXd unknown_truncation(const CaseFit& fit, const MatrixXd& unknown, Index row) {
  const ObservationSet& set = *fit.set;
  const auto at = static_cast<std::size_t>(row);
  if (set.truncation.size() == 0 || !(fit.system.noise_sd[at] > 0)) return VectorXd::Zero(1);
  const auto of = [&](const Eigen::MatrixXcd& all) {
    return part_of(all(static_cast<Index>(fit.system.observation[at]), static_cast<Index>(fit.system.block[at])),
                   fit.system.part[at]) /
           fit.system.noise_sd[at];
  };
  const std::size_t moves = set.truncation_of_moves.size(), directions = set.truncation_change.size();
  if (moves == 0) return VectorXd::Constant(1, 0.5 * of(set.truncation));
  VectorXd change(static_cast<Index>(moves + directions));
  for (std::size_t m = 0; m < moves; ++m) change(static_cast<Index>(m)) = of(set.truncation_of_moves[m]);
  for (std::size_t m = 0; m < directions; ++m) change(static_cast<Index>(moves + m)) = of(set.truncation_change[m]);
  return unknown.rows() == change.size() ? VectorXd(unknown.transpose() * change) : change;
}

}  // namespace

std::vector<LackOfFit> lack_of_fit(const CaseFit& fit, const MatrixXd& unknown) {
  std::vector<LackOfFit> result;
  if (!fit.set->resonance->excited || fit.fit.coefficients.size() == 0) return result;
  struct Group {
    double weights = 0, sum = 0, squares = 0, count = 0;
    double by_phase = 0;  // variances of repeats that unknown phases take up
    VectorXd truncation;
  };
  std::map<Equation, std::map<int, Group>> groups;
  std::map<Equation, double> unknowns;
  for (Index r = 0; r < fit.residual.size(); ++r) {
    const auto at = static_cast<std::size_t>(r);
    const double weight = fit.weight[fit.system.observation[at]], z = fit.residual(r);
    Group& group = groups[equation_of(fit, r)][fit.system.condition[at]];
    group.weights += weight;
    group.sum += weight * z;
    group.squares += weight * z * z;
    group.count += 1;
    const VectorXd left = weight * unknown_truncation(fit, unknown, r);
    group.truncation = group.truncation.size() == 0 ? left : VectorXd(group.truncation + left);
  }
  // What the fit takes of the variance of a condition's mean: n m'Cm for its mean design row m in units of the
  // equation's own noise and the covariance C of the coefficients (the weights of a block that misfits are lower).
  std::map<Equation, std::map<int, VectorXd>> rows;
  Index begin = 0;
  for (std::size_t n = 0; n < fit.system.colouring.size(); ++n) {
    const auto colouring = fit.system.colouring[n].triangularView<Eigen::Lower>();
    const MatrixXd own = colouring * fit.fit.orthonormal.middleRows(begin, colouring.rows());
    const VectorXd by_phase =
        fit.system.by_phase.empty() ? VectorXd::Zero(own.rows()) : VectorXd(colouring * fit.system.by_phase[n]);
    for (Index r = 0; r < own.rows(); ++r) {
      const auto at = static_cast<std::size_t>(begin + r);
      const Equation equation = equation_of(fit, begin + r);
      const double weight = fit.weight[fit.system.observation[at]];
      VectorXd& sum = rows[equation][fit.system.condition[at]];
      if (sum.size() == 0) sum = VectorXd::Zero(own.cols());
      sum += weight * own.row(r).transpose();
      const double scale = std::max(1.0, fit.block_misfit.at(equation.first));
      groups[equation][fit.system.condition[at]].by_phase += weight * by_phase(r) * by_phase(r) / (scale * scale);
    }
    begin += own.rows();
  }
  for (const auto& [equation, conditions] : groups) {
    const double scale = std::max(1.0, fit.block_misfit.at(equation.first));
    for (const auto& [label, group] : conditions)
      unknowns[equation] += rows[equation][label].squaredNorm() / group.weights / (scale * scale);
  }
  for (const auto& [equation, conditions] : groups) {
    LackOfFit test;
    test.block = equation.first;
    test.part = equation.second;
    test.name = name_of(fit, equation);
    test.conditions = conditions.size();
    double means = 0, repeats = 0, repeat_df = 0, truncation = 0;
    for (const auto& [label, group] : conditions) {
      const double between = group.sum * group.sum / group.weights;
      means += between;
      repeats += std::max(0.0, group.squares - between);
      const double phase_share = group.by_phase / group.count;
      unknowns[equation] += phase_share;
      repeat_df += (group.count - 1) * (1 - phase_share);
      truncation += group.truncation.squaredNorm() / group.weights;
    }
    test.numerator_df = static_cast<double>(conditions.size()) - unknowns[equation];
    if (test.numerator_df < 1) continue;
    const bool enough = repeat_df >= fewest_repeats;
    test.denominator_df = enough ? repeat_df : std::numeric_limits<double>::infinity();
    const double variance = enough ? repeats / repeat_df : 1;
    test.repeatability = std::sqrt(variance);
    test.f = means / (test.numerator_df * variance + truncation);
    test.misfit = std::sqrt(test.f);
    test.p_value = f_upper_tail(test.f, test.numerator_df, test.denominator_df);
    result.push_back(std::move(test));
  }
  for (LackOfFit& test : result) test.significant = test.p_value < false_alarm / static_cast<double>(result.size());
  return result;
}

MatrixXd hidden_misfit(const CaseFit& fit, const std::vector<LackOfFit>& tests) {
  std::map<Equation, double> seen;  // norm of the misfit beyond what repeatability gives
  for (const LackOfFit& test : tests)
    if (test.significant)
      seen[{test.block, test.part}] =
          test.repeatability * std::sqrt(std::max(0.0, (test.f - 1) * test.numerator_df));
  const Index columns = fit.fit.coefficients.size();
  if (seen.empty()) return MatrixXd::Zero(columns, 0);
  // Coefficients, in the basis, by the equations' misfit in units of their own noise, summed over the repeats of a
  // condition.
  std::map<std::pair<Equation, int>, std::pair<VectorXd, double>> sums;
  Index begin = 0;
  for (const MatrixXd& colouring : fit.system.colouring) {
    const MatrixXd part = colouring.triangularView<Eigen::Lower>().transpose().solve(
        MatrixXd(fit.fit.orthonormal.middleRows(begin, colouring.rows())));
    for (Index r = 0; r < part.rows(); ++r) {
      const Equation equation = equation_of(fit, begin + r);
      if (seen.count(equation) == 0) continue;
      const auto key = std::pair{equation, fit.system.condition[static_cast<std::size_t>(begin + r)]};
      const auto sum = sums.try_emplace(key, VectorXd::Zero(part.cols()), 0.0).first;
      sum->second.first += part.row(r).transpose();
      sum->second.second += fit.weight[fit.system.observation[static_cast<std::size_t>(begin + r)]];
    }
    begin += part.rows();
  }
  MatrixXd result(columns, static_cast<Index>(sums.size()));
  Index at = 0;
  for (const auto& [key, sum] : sums)
    result.col(at++) = fit.fit.basis * sum.first * (seen.at(key.first) / std::sqrt(sum.second));
  return result;
}

}  // namespace secular
