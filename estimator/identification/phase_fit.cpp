#include "estimator/identification/phase_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "estimator/identification/equation_data.hpp"
#include "numerics/distribution.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Gauss-Newton steps converge quadratically; they end where phases move by less than this share of their error.
constexpr int most_steps = 12;
constexpr double step_share = 0.03;

/// Phases of all records nearer than this (radians) are one minimum.
constexpr double same_phase = 0.02;

/// Probability that noise makes a minimum higher than it is by what tells it apart.
constexpr double told_apart = 0.001;

/// Rows of one observation in units of the noise that an EquationData gives them.
struct Weighted {
  Equations rows;
  VectorXd phase;
};

// `noise`: of equations with the phase unknown; `of`: those that are weighed, the same or others.
Weighted weighted(const EquationData::Rows& noise, const EquationData::Rows& of) {
  MatrixXd covariance = noise.variants * noise.variants.transpose();
  covariance.diagonal() += noise.own_variance;
  const VectorXd inverse_sd = covariance.diagonal().cwiseSqrt().cwiseInverse();
  MatrixXd correlation = inverse_sd.asDiagonal() * covariance * inverse_sd.asDiagonal();
  // As in the regression: equations that share all their noise stay a little apart.
  correlation.diagonal().array() += 1e-9;
  const Eigen::LLT<MatrixXd> cholesky(correlation);
  const auto whiten = [&](const MatrixXd& m) -> MatrixXd {
    return cholesky.matrixL().solve(MatrixXd(inverse_sd.asDiagonal() * m));
  };
  return {{whiten(of.design), whiten(of.response)}, whiten(noise.phase)};
}

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
  for (std::size_t r = 0; r < problem.records.size(); ++r) {
    double gradient = 0, curvature = 0;
    for (const std::size_t i : problem.records[r].observations) {
      const EquationData::Rows rows = data.rows(i, fit.columns, fit.state.at, problem.known.natural_frequency);
      const Weighted w = weighted(rows, rows);
      gradient += w.phase.dot(w.rows.response - w.rows.design * values);
      curvature += w.phase.squaredNorm();
    }
    if (!(curvature > 0)) continue;
    const double step = -gradient / curvature;
    phases.ahead[r] += std::clamp(step, -1.0, 1.0);
    phases.effect[r] = effect_on_modulation(problem, data, fit, problem.records[r].observations.front());
    largest = std::max(largest, std::abs(step) * std::sqrt(curvature));
  }
  return largest;
}

// F of the records' means: what phases explain, each a degree of freedom, against what they leave.
void test_phases(const PhaseProblem& problem, const CaseFit& fit, const EquationData& data, PhaseFit& phases) {
  EquationData as_measured(problem.set, problem.blocks);
  as_measured.evaluate(fit.state.at.natural_frequency);
  std::vector<Equations> held, free;
  double rows = 0, unknown = 0;
  for (const RecordMembers& record : problem.records) {
    Equations with, without;
    bool moves = false;
    for (const std::size_t i : record.observations) {
      const auto rows_of = [&](const EquationData& equations) {
        return equations.rows(i, fit.columns, fit.state.at, problem.known.natural_frequency);
      };
      const EquationData::Rows noise = rows_of(data);
      Equations measured = weighted(noise, rows_of(as_measured)).rows;
      Weighted own = weighted(noise, noise);
      const VectorXd direction = own.phase.stableNormalized();
      moves = moves || direction.squaredNorm() > 0;
      own.rows.design -= (direction * (direction.transpose() * own.rows.design)).eval();
      own.rows.response -= direction * direction.dot(own.rows.response);
      const bool first = with.response.size() == 0;
      const auto add = [&](Equations& sum, const Equations& part) {
        const double share = 1 / std::sqrt(static_cast<double>(record.observations.size()));
        sum.design = first ? MatrixXd(share * part.design) : MatrixXd(sum.design + share * part.design);
        sum.response = first ? VectorXd(share * part.response) : VectorXd(sum.response + share * part.response);
      };
      add(with, measured);
      add(without, own.rows);
    }
    rows += static_cast<double>(with.response.size());
    unknown += moves ? 1 : 0;
    held.push_back(std::move(with));
    free.push_back(std::move(without));
  }
  const auto solve = [](const std::vector<Equations>& parts) {
    std::vector<const Equations*> pointers;
    for (const Equations& part : parts) pointers.push_back(&part);
    return least_squares(stacked(pointers));
  };
  const Solution in_step = solve(held), late = solve(free);
  const double left = rows - unknown - static_cast<double>(late.rank);
  if (left < 1 || unknown < 1 || !(late.misfit > 0)) return;
  phases.misfit = late.misfit;
  phases.left = left;
  phases.f = (in_step.misfit - late.misfit) / unknown / (late.misfit / left);
  phases.p_value = f_upper_tail(std::max(0.0, phases.f), unknown, left);
}

std::optional<PhaseFit> refined(const PhaseProblem& problem, std::vector<double> start) {
  PhaseFit phases;
  phases.ahead = std::move(start);
  phases.effect.assign(phases.ahead.size(), 0);
  for (int step = 0; step < most_steps; ++step) {
    const ObservationSet set = with_phases(problem, phases.ahead);
    const CaseFit fit = fit_case(set, problem.blocks, problem.known, {.threads = problem.threads});
    if (fit.fit.coefficients.size() == 0) return std::nullopt;
    EquationData data(set, problem.blocks);
    data.evaluate(fit.state.at.natural_frequency);
    test_phases(problem, fit, data, phases);
    phases.coefficient = fit.fit.coefficients - fit.reference;
    phases.contribution = fit.system.design.colwise().norm().transpose().cwiseProduct(phases.coefficient);
    if (step_phases(problem, fit, data, phases) < step_share) return phases;
  }
  return std::nullopt;
}

}  // namespace

std::vector<PhaseFit> equal_minima(const PhaseProblem& problem, const std::vector<std::vector<double>>& starts) {
  std::vector<PhaseFit> found;
  for (const std::vector<double>& start : starts) {
    std::optional<PhaseFit> phases = refined(problem, start);
    if (!phases || !(phases->left >= 1)) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const PhaseFit& other) {
      return agree(other.ahead, phases->ahead, same_phase);
    });
    if (!known) found.push_back(std::move(*phases));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const PhaseFit& a, const PhaseFit& b) { return a.misfit < b.misfit; });
  while (!found.empty() && (found.back().misfit - found.front().misfit) * found.front().left >
                               chi_squared_upper_quantile(told_apart, 1) * found.front().misfit)
    found.pop_back();
  return found;
}

ObservationSet with_phases(const PhaseProblem& problem, const std::vector<double>& ahead) {
  ObservationSet set = turned(problem, ahead);
  set.phase_unknown = true;
  return set;
}

}  // namespace secular
