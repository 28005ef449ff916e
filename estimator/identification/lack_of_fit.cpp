#include "estimator/identification/lack_of_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <utility>

#include "estimator/identification/record_scatter.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/third_differences.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Probability that a case whose equations hold shows a significant lack of fit.
constexpr auto& false_lack_of_fit = estimator_thresholds().false_lack_of_fit;

/// Of a window's length, by which its neighbour may seem to overlap it.
constexpr double rounding = 1e-3;

/// A column has no part in an equation of a record, or others have all of it, where no more than this share of its
/// length is left.
constexpr double dependent = 1e-6;

/// Where no condition of dwells was repeated, the measured noise stands for the scatter of repeats. What repeats in
/// a decay is not the noise alone (other modes ring, too): there, so many times that noise does (tuned:
/// right models leave 1.2 to 3.4 times it in draws of three short decays, one that lacks friction 21 times; alarm
/// from 2.3 times this on).
constexpr auto& fewest_freedom = estimator_thresholds().fewest_freedom;
constexpr auto& repeats_of_short_decays = estimator_thresholds().repeats_of_short_decays;

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

// By observation: whether it shares no samples with those before it that count as repeats of its condition.
std::vector<bool> repeats_of(const ObservationSet& set) {
  std::vector<bool> repeats(set.observations.size(), true);
  const Observation* last = nullptr;
  for (std::size_t i = 0; i < set.observations.size(); ++i) {
    const Observation& here = set.observations[i];
    const bool overlaps = last && last->condition == here.condition && last->record == here.record &&
                          here.centre_s - last->centre_s < (1 - rounding) * here.length_s;
    repeats[i] = !overlaps;
    if (!overlaps) last = &here;
  }
  return repeats;
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

// What a natural frequency one standard deviation off does to a balance of frequency, over the equation's noise.
double by_own_frequency(const CaseFit& fit, Index row) {
  const ObservationSet& set = *fit.set;
  const auto at = static_cast<std::size_t>(row);
  const RegressorBlock& block = set.resonance->blocks[fit.system.block[at]];
  if (set.frequency_scatter.empty() || block.kind != BlockKind::modulation ||
      fit.system.part[at] != EquationPart::in_quadrature)
    return 0;
  const auto mode = static_cast<std::size_t>(block.mode);
  return set.frequency_scatter[mode] * std::abs(set.observations[fit.system.observation[at]].amplitude[mode]) /
         fit.system.noise_sd[at];
}

// Whitened rows back to equations in units of their own noise.
MatrixXd over_own_noise(const CaseFit& fit, const MatrixXd& whitened) {
  MatrixXd rows(whitened.rows(), whitened.cols());
  Index begin = 0;
  for (const MatrixXd& factor : fit.system.colouring) {
    rows.middleRows(begin, factor.rows()) =
        factor.triangularView<Eigen::Lower>() * whitened.middleRows(begin, factor.rows());
    begin += factor.rows();
  }
  return rows;
}

// Residuals over their measured noise. Where there are several decays, without what coefficients of each record's
// own would make of them: how records differ is scatter of the structure (record_scatter), and no law that the
// model lacks.
struct Residuals {
  VectorXd values;
  std::map<Equation, double> unknowns;  // that this takes; none: those of the fit alone
};

Residuals residuals_of(const CaseFit& fit) {
  Residuals result{fit.residual, {}};
  if (fit.set->resonance->excited || count_of_records(*fit.set) < 2) return result;
  const MatrixXd design = over_own_noise(fit, fit.system.design);
  VectorXd root_weight(design.rows());
  const Eigen::RowVectorXd lengths = design.colwise().norm();
  std::map<std::pair<Equation, std::size_t>, std::vector<Index>> rows;  // by record
  for (Index r = 0; r < design.rows(); ++r) {
    const std::size_t observation = fit.system.observation[static_cast<std::size_t>(r)];
    rows[{equation_of(fit, r), fit.set->observations[observation].record}].push_back(r);
    root_weight(r) = std::sqrt(fit.weight[observation]);
  }
  for (const auto& [key, here] : rows) {
    MatrixXd columns = root_weight(here).asDiagonal() * design(here, Eigen::all);
    for (Index c = 0; c < columns.cols(); ++c)
      if (lengths(c) > 0) columns.col(c) /= lengths(c);
    Eigen::ColPivHouseholderQR<MatrixXd> own(columns);
    own.setThreshold(dependent);
    const VectorXd fitted =
        columns * VectorXd(own.solve(VectorXd(root_weight(here).cwiseProduct(result.values(here)))));
    for (std::size_t r = 0; r < here.size(); ++r)
      if (const double root = root_weight(here[r]); root > 0)
        result.values(here[r]) -= fitted(static_cast<Index>(r)) / root;
    result.unknowns[key.first] += static_cast<double>(own.rank());
  }
  return result;
}

// Residuals of one equation at one condition, over their measured noise.
struct Group {
  double weights = 0, sum = 0, squares = 0, count = 0;  // of repeats
  double all_weights = 0, all_count = 0;                // with windows that overlap them
  double by_phase = 0;                                  // variances that unknown phases take up
  VectorXd truncation;                                  // what is not known of it, weighted
  double own_frequency = 0;                             // what a record's natural frequency may be off, weighted

  double between() const { return sum * sum / weights; }
  double phase_share() const { return by_phase / all_count; }
};

struct Conditions {
  std::map<int, Group> groups;
  std::map<std::size_t, std::vector<double>> in_time;  // residuals of repeats that are no outliers, by record
};

std::map<Equation, Conditions> gathered(const CaseFit& fit, const VectorXd& residuals, const MatrixXd& unknown) {
  const std::vector<bool> repeats = repeats_of(*fit.set);
  std::map<Equation, Conditions> equations;
  for (Index r = 0; r < residuals.size(); ++r) {
    const auto at = static_cast<std::size_t>(r);
    const std::size_t observation = fit.system.observation[at];
    const double weight = fit.weight[observation], z = residuals(r);
    Conditions& conditions = equations[equation_of(fit, r)];
    Group& group = conditions.groups[fit.system.condition[at]];
    group.all_weights += weight;
    group.all_count += 1;
    if (!repeats[observation]) continue;
    if (weight == 1) conditions.in_time[fit.set->observations[observation].record].push_back(z);
    group.weights += weight;
    group.sum += weight * z;
    group.squares += weight * z * z;
    group.count += 1;
    group.own_frequency += weight * by_own_frequency(fit, r);
    const VectorXd left = weight * unknown_truncation(fit, unknown, r);
    group.truncation = group.truncation.size() == 0 ? left : VectorXd(group.truncation + left);
  }
  Index begin = 0;
  for (std::size_t n = 0; n < fit.system.by_phase.size(); ++n) {
    const auto colouring = fit.system.colouring[n].triangularView<Eigen::Lower>();
    const VectorXd by_phase = colouring * fit.system.by_phase[n];
    for (Index r = 0; r < by_phase.size(); ++r) {
      const auto at = static_cast<std::size_t>(begin + r);
      const Equation equation = equation_of(fit, begin + r);
      const double scale = std::max(1.0, fit.block_residual.at(equation.first));
      equations[equation].groups[fit.system.condition[at]].by_phase +=
          fit.weight[fit.system.observation[at]] * by_phase(r) * by_phase(r) / (scale * scale);
    }
    begin += by_phase.size();
  }
  return equations;
}

// What the fit takes of the variance of a condition's mean: n m'Cm for its mean design row m in units of the
// equation's own noise and the covariance C of the coefficients (the weights of a block with larger residuals are
// lower).
std::map<Equation, double> unknowns_of(const CaseFit& fit, const std::map<Equation, Conditions>& equations) {
  std::map<Equation, std::map<int, VectorXd>> rows;
  const MatrixXd own = over_own_noise(fit, fit.fit.orthonormal);
  for (Index r = 0; r < own.rows(); ++r) {
    const auto at = static_cast<std::size_t>(r);
    VectorXd& sum = rows[equation_of(fit, r)][fit.system.condition[at]];
    if (sum.size() == 0) sum = VectorXd::Zero(own.cols());
    sum += fit.weight[fit.system.observation[at]] * own.row(r).transpose();
  }
  std::map<Equation, double> unknowns;
  for (const auto& [equation, conditions] : equations) {
    const double scale = std::max(1.0, fit.block_residual.at(equation.first));
    for (const auto& [label, group] : conditions.groups)
      unknowns[equation] +=
          rows[equation][label].squaredNorm() / group.all_weights / (scale * scale) + group.phase_share();
  }
  return unknowns;
}

// How repeats scatter, in variances of the measured noise.
struct Scatter {
  double variance = 1, freedom = std::numeric_limits<double>::infinity();
};

// Ensembles of dwells about their condition's mean. What follows one another in a decay without overlap: about any
// smooth law of the time, since a law that the model lacks changes from window to window by more than noise does.
Scatter scatter_of(const Conditions& conditions, bool of_dwells) {
  double squares = 0, freedom = 0;
  if (of_dwells) {
    for (const auto& [label, group] : conditions.groups) {
      squares += std::max(0.0, group.squares - group.between());
      freedom += (group.count - 1) * (1 - group.phase_share());
    }
    return freedom > 0 ? Scatter{squares / freedom, freedom} : Scatter{};
  }
  double count = 0;
  for (const auto& [record, values] : conditions.in_time)
    for (const double third : third_differences(values)) {
      squares += third * third / third_difference_variance;
      count += 1;
    }
  freedom = third_difference_freedom * count;
  if (freedom < fewest_freedom) return Scatter{repeats_of_short_decays * repeats_of_short_decays};
  return Scatter{squares / count, freedom};
}

}  // namespace

std::vector<LackOfFit> lack_of_fit(const CaseFit& fit, const MatrixXd& unknown) {
  std::vector<LackOfFit> result;
  if (fit.fit.coefficients.size() == 0) return result;
  // Noise that is what the fit left tells nothing of the fit.
  const std::vector<Observation>& all = fit.set->observations;
  if (std::any_of(all.begin(), all.end(), [](const Observation& o) { return !o.noise_known; })) return result;
  const Residuals residuals = residuals_of(fit);
  const std::map<Equation, Conditions> equations = gathered(fit, residuals.values, unknown);
  const std::map<Equation, double> unknowns =
      residuals.unknowns.empty() ? unknowns_of(fit, equations) : residuals.unknowns;
  for (const auto& [equation, conditions] : equations) {
    LackOfFit test;
    test.block = equation.first;
    test.part = equation.second;
    test.name = name_of(fit, equation);
    test.conditions = conditions.groups.size();
    const Scatter scatter = scatter_of(conditions, fit.set->resonance->excited);
    double means = 0, truncation = 0, own_frequency = 0;
    for (const auto& [label, group] : conditions.groups) {
      means += group.between();
      truncation += group.truncation.squaredNorm() / group.weights;
      own_frequency += group.own_frequency * group.own_frequency / group.weights;
    }
    test.numerator_df = static_cast<double>(test.conditions) - unknowns.at(equation);
    if (test.numerator_df < 1) continue;
    test.denominator_df = scatter.freedom;
    test.scatter_ratio = std::sqrt(scatter.variance);
    const double usual =
        test.numerator_df * (scatter.variance + own_frequency / static_cast<double>(test.conditions)) + truncation;
    test.f = means / usual;
    test.beyond = std::max(0.0, means - usual);
    test.misfit_ratio = std::sqrt(test.f);
    test.p_value = f_upper_tail(test.f, test.numerator_df, test.denominator_df);
    result.push_back(std::move(test));
  }
  for (LackOfFit& test : result)
    test.significant = test.p_value < false_lack_of_fit / static_cast<double>(result.size());
  return result;
}

MatrixXd hidden_misfit(const CaseFit& fit, const std::vector<LackOfFit>& tests) {
  std::map<Equation, double> seen;  // norm of the lack of fit, over the measured noise
  for (const LackOfFit& test : tests)
    if (test.significant) seen[{test.block, test.part}] = std::sqrt(test.beyond);
  const Index columns = fit.fit.coefficients.size();
  if (seen.empty()) return MatrixXd::Zero(columns, 0);
  const std::vector<bool> repeats_at = repeats_of(*fit.set);
  // Coefficients, in the basis, by the equations' lack of fit in units of their own noise, summed over the repeats
  // of a condition.
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
      const std::size_t observation = fit.system.observation[static_cast<std::size_t>(begin + r)];
      if (repeats_at[observation]) sum->second.second += fit.weight[observation];
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
