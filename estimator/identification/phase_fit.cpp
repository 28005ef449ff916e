#include "estimator/identification/phase_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/row_noise.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Phases move at the present coefficients and coefficients at the present phases: steps shrink by a factor that is
/// small where conditions part both. They end where phases move by less than this share of their error. A start
/// from which they do not come to rest in so many leads to no minimum that conditions tell; from half a turn of a
/// minimum they are followed as long as they shrink by a fifth each, over six decades.
constexpr int most_phase_steps = 12, most_steps_of_mate = 60;
constexpr double step_share = 0.03;

/// Probability that noise makes a minimum higher than it is by what tells it apart.
constexpr auto& phase_alarm = estimator_thresholds().phase_alarm;

std::complex<double> effect_on_modulation(const PhaseProblem& problem, const EquationData& data, const CaseFit& fit,
                                          std::size_t observation) {
  const EquationData::Rows rows =
      data.rows(observation, fit.columns, fit.state.at, problem.known.natural_frequency);
  std::complex<double> effect = 0;
  for (std::size_t r = 0; r < rows.block.size(); ++r) {
    if (rows.block[r] != rows.block.front()) break;
    const double part = rows.phase(static_cast<Index>(r));
    effect += rows.part[r] == EquationPart::in_phase ? std::complex<double>(part) : std::complex<double>(0, part);
  }
  return effect;
}

// One Gauss-Newton step of every record's phase; by how much of its error the largest moves.
double step_phases(const PhaseProblem& problem, const CaseFit& fit, const EquationData& data, PhaseFit& phases) {
  const VectorXd values = fit.fit.coefficients - fit.reference;
  double largest = 0;
  phases.sd.assign(problem.records.size(), INFINITY);
  for (std::size_t r = 0; r < problem.records.size(); ++r) {
    double gradient = 0, curvature = 0;
    for (const std::size_t i : problem.records[r].observations) {
      const EquationData::Rows rows = data.rows(i, fit.columns, fit.state.at, problem.known.natural_frequency);
      const RowNoise noise(rows);
      const VectorXd phase = noise.whitened(rows.phase);
      gradient += phase.dot(noise.whitened(rows.response - rows.design * values).col(0));
      curvature += phase.squaredNorm();
    }
    if (!(curvature > 0)) continue;
    phases.sd[r] = 1 / std::sqrt(curvature);
    const double step = -gradient / curvature;
    phases.ahead[r] += std::clamp(step, -1.0, 1.0);
    largest = std::max(largest, std::abs(step) / phases.sd[r]);
  }
  return largest;
}

// F of the records' means: what phases explain, each a degree of freedom, against what they leave.
void test_phases(const PhaseProblem& problem, const CaseFit& fit, const EquationData& data, PhaseFit& phases) {
  EquationData as_measured(problem.set, problem.blocks);
  as_measured.evaluate(fit.state.at.natural_frequency);
  std::vector<Equations> held, freed;
  double rows = 0, unknown = 0;
  for (const RecordMembers& record : problem.records) {
    Equations with, without;
    bool moves = false;
    for (const std::size_t i : record.observations) {
      const auto rows_of = [&](const EquationData& equations) {
        return equations.rows(i, fit.columns, fit.state.at, problem.known.natural_frequency);
      };
      const EquationData::Rows turned = rows_of(data), measured = rows_of(as_measured);
      const RowNoise noise(turned);
      Equations free{noise.whitened(turned.design), noise.whitened(turned.response)};
      const VectorXd direction = noise.whitened(turned.phase).col(0).stableNormalized();
      moves = moves || direction.squaredNorm() > 0;
      take_out_direction(direction, free.design);
      take_out_direction(direction, free.response);
      const double share = 1 / std::sqrt(static_cast<double>(record.observations.size()));
      add_to(with, share, {noise.whitened(measured.design), noise.whitened(measured.response)});
      add_to(without, share, free);
    }
    rows += static_cast<double>(with.response.size());
    unknown += moves ? 1 : 0;
    held.push_back(std::move(with));
    freed.push_back(std::move(without));
  }
  const auto solve = [](const std::vector<Equations>& parts) {
    std::vector<const Equations*> pointers;
    for (const Equations& part : parts) pointers.push_back(&part);
    return least_squares(stacked(pointers));
  };
  const Solution in_step = solve(held), late = solve(freed);
  const double left = rows - unknown - static_cast<double>(late.rank);
  if (left < 1 || unknown < 1 || !(late.sum_of_squares > 0)) return;
  phases.sum_of_squares = late.sum_of_squares;
  phases.left = left;
  phases.f = (in_step.sum_of_squares - late.sum_of_squares) / unknown / (late.sum_of_squares / left);
  phases.p_value = f_upper_tail(std::max(0.0, phases.f), unknown, left);
}

std::optional<PhaseFit> refined(const PhaseProblem& problem, std::vector<double> start, int steps) {
  PhaseFit phases;
  phases.ahead = std::move(start);
  for (int step = 0; step < steps; ++step) {
    const ObservationSet set = with_phases(problem, phases.ahead);
    const CaseFit fit = fit_case(set, problem.blocks, problem.known, {.threads = problem.threads});
    if (fit.fit.coefficients.size() == 0) return std::nullopt;
    EquationData data(set, problem.blocks);
    data.evaluate(fit.state.at.natural_frequency);
    if (!(step_phases(problem, fit, data, phases) < step_share)) continue;
    test_phases(problem, fit, data, phases);
    phases.coefficient = fit.fit.coefficients - fit.reference;
    phases.contribution = fit.system.design.colwise().norm().transpose().cwiseProduct(phases.coefficient);
    for (const RecordMembers& record : problem.records)
      phases.effect.push_back(effect_on_modulation(problem, data, fit, record.observations.front()));
    return phases;
  }
  return std::nullopt;
}

}  // namespace

std::vector<PhaseFit> equal_minima(const PhaseProblem& problem, const std::vector<std::vector<double>>& starts) {
  std::vector<PhaseFit> found;
  // Phases that differ by less than they are known are one minimum.
  const auto is_known = [&](const std::vector<double>& ahead) {
    return std::any_of(found.begin(), found.end(),
                       [&](const PhaseFit& other) { return agree(other.ahead, ahead, other.sd); });
  };
  const auto search = [&](const std::vector<double>& start, int steps) {
    std::optional<PhaseFit> phases = refined(problem, start, steps);
    if (!phases || !(phases->left >= 1)) return;
    if (!is_known(phases->ahead)) found.push_back(std::move(*phases));
  };
  for (const std::vector<double>& start : starts) search(start, most_phase_steps);
  // Half a turn of every phase fits as well with the other sign, whether or not a start has led there.
  for (std::size_t m = 0, reached = found.size(); m < reached; ++m) {
    std::vector<double> start = found[m].ahead;
    for (double& angle : start) angle += std::numbers::pi;
    if (!is_known(start)) search(start, most_steps_of_mate);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const PhaseFit& a, const PhaseFit& b) { return a.sum_of_squares < b.sum_of_squares; });
  while (!found.empty() && (found.back().sum_of_squares - found.front().sum_of_squares) * found.front().left >
                               chi_squared_upper_quantile(phase_alarm, 1) * found.front().sum_of_squares)
    found.pop_back();
  return found;
}

std::optional<PhaseFit> nearest_minimum(const PhaseProblem& problem) {
  return refined(problem, std::vector<double>(problem.records.size(), 0), most_steps_of_mate);
}

ObservationSet with_phases(const PhaseProblem& problem, const std::vector<double>& ahead) {
  ObservationSet set = turned(problem, ahead);
  set.phase_unknown = true;
  return set;
}

}  // namespace secular
