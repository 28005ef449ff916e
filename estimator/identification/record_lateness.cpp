#include "estimator/identification/record_lateness.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/estimation.hpp"
#include "numerics/distribution.hpp"
#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Probability that records whose phases hold, of a model that holds, are said to be late.
constexpr double false_alarm = 0.001;

/// Probability that phases that say nothing of a sign seem to.
constexpr double sign_alarm = 0.005;

/// Phases of the grid over a period: the force enters as exp(i*psi), its square under hard excitation.
constexpr std::size_t grid = 48;

/// Starts of the search with phases at random, beside the common ones of the grid.
constexpr int random_starts = 48;

/// Each lowers the misfit on a finite set: a limit that is hardly ever reached.
constexpr int most_alternations = 100;

/// Gauss-Newton steps converge quadratically; they end where phases move by less than this share of their error.
constexpr int most_steps = 12;
constexpr double step_share = 0.03;

/// Minima of the grid that are followed. A grid leaves its own misfit at each: that much more than the lowest may
/// be the lowest in the end.
constexpr std::size_t most_minima = 8;
constexpr double grid_misfit = 4;

/// Phases of all records nearer than this (radians) belong to one minimum: on the grid, and at its bottom.
constexpr double same_on_grid = 0.3, same_phase = 0.02;

/// Of a rate of growth, next to the largest rate of the motion: rounding, and the frequency that a resonance leaves
/// free.
constexpr double no_growth = 1e-6;

struct Equations {
  MatrixXd design;
  VectorXd response;
};

/// Observations of one record that have the same equations.
struct RecordMembers {
  std::size_t record = 0;
  std::vector<std::size_t> observations;
};

/// A case's regression as this search needs it.
struct PhaseProblem {
  const ObservationSet& set;
  std::vector<std::size_t> blocks;
  const CaseKnowledge& known;
  std::vector<RecordMembers> records;
  unsigned threads;
};

std::vector<RecordMembers> members_of(const ObservationSet& set, const std::vector<std::size_t>& blocks) {
  const EquationData data(set, blocks, EquationData::Errors::none);
  std::map<std::size_t, RecordMembers> by_record;
  for (std::size_t i = 0; i < set.observations.size(); ++i) {
    const Index rows = data.row_count(i);
    if (rows == 0) continue;
    RecordMembers& record = by_record[set.observations[i].record];
    record.record = set.observations[i].record;
    if (!record.observations.empty() && data.row_count(record.observations.front()) != rows) {
      if (data.row_count(record.observations.front()) > rows) continue;
      record.observations.clear();
    }
    record.observations.push_back(i);
  }
  std::vector<RecordMembers> records;
  for (auto& [number, record] : by_record) records.push_back(std::move(record));
  return records;
}

// The set with the excitation of each record `ahead` by an angle.
ObservationSet turned(const PhaseProblem& problem, const std::vector<double>& ahead) {
  std::map<std::size_t, double> by_record;
  for (std::size_t r = 0; r < problem.records.size(); ++r) by_record[problem.records[r].record] = ahead[r];
  ObservationSet result = problem.set;
  for (Observation& o : result.observations)
    for (std::size_t j = 0; j < o.forcing.size(); ++j) o.forcing[j] *= put_ahead(o, j, by_record[o.record]);
  return result;
}

Equations stacked(const std::vector<const Equations*>& parts) {
  Index rows = 0;
  for (const Equations* part : parts) rows += part->response.size();
  Equations all{MatrixXd(rows, parts.front()->design.cols()), VectorXd(rows)};
  Index begin = 0;
  for (const Equations* part : parts) {
    all.design.middleRows(begin, part->design.rows()) = part->design;
    all.response.segment(begin, part->response.size()) = part->response;
    begin += part->response.size();
  }
  return all;
}

struct Solution {
  VectorXd values;
  double misfit = 0;  // sum of squares
  Index rank = 0;
};

Solution least_squares(const Equations& all) {
  const VectorXd scale = unit_scale(all.design);
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(1e-9);
  solver.compute(all.design * scale.asDiagonal());
  Solution result;
  result.values = scale.cwiseProduct(VectorXd(solver.solve(all.response)));
  result.misfit = (all.response - all.design * result.values).squaredNorm();
  result.rank = solver.rank();
  return result;
}

bool near(const std::vector<double>& a, const std::vector<double>& b, double enough) {
  for (std::size_t r = 0; r < a.size(); ++r)
    if (std::abs(std::remainder(a[r] - b[r], 2 * std::numbers::pi)) > enough) return false;
  return true;
}

/// Mean equations of each record at each phase of the grid, over the size of the motion: nothing of the
/// coefficients is needed to weigh them.
class PhaseGrid {
 public:
  PhaseGrid(const PhaseProblem& problem, const CaseFit& together) : rows_(problem.records.size()) {
    for (std::size_t k = 0; k < grid; ++k) {
      const ObservationSet set = turned(problem, std::vector<double>(rows_.size(), angle(k)));
      EquationData data(set, problem.blocks, EquationData::Errors::none);
      data.evaluate(problem.known.natural_frequency);
      for (std::size_t r = 0; r < rows_.size(); ++r)
        rows_[r].push_back(mean_equations(data, problem, problem.records[r], together));
    }
  }

  static double angle(std::size_t k) { return 2 * std::numbers::pi * static_cast<double>(k) / grid; }
  static std::vector<double> angles(const std::vector<std::size_t>& phase) {
    std::vector<double> result;
    for (const std::size_t k : phase) result.push_back(angle(k));
    return result;
  }

  struct Minimum {
    std::vector<std::size_t> phase;  // by record
    Solution solution;
  };

  // Coefficients by phases and phases by coefficients, in turn.
  Minimum from(std::vector<std::size_t> phase) const {
    Minimum result{std::move(phase), {}};
    for (int round = 0; round < most_alternations; ++round) {
      result.solution = at(result.phase);
      std::vector<std::size_t> next;
      for (const std::vector<Equations>& record : rows_) next.push_back(nearest(record, result.solution.values));
      if (next == result.phase) break;
      result.phase = std::move(next);
    }
    return result;
  }

  Solution at(const std::vector<std::size_t>& phase) const {
    std::vector<const Equations*> parts;
    for (std::size_t r = 0; r < rows_.size(); ++r) parts.push_back(&rows_[r][phase[r]]);
    return least_squares(stacked(parts));
  }

  // The lowest minima first.
  std::vector<Minimum> minima() const {
    std::map<std::vector<std::size_t>, Solution> found;
    const auto consider = [&](std::vector<std::size_t> start) {
      Minimum minimum = from(std::move(start));
      found.emplace(std::move(minimum.phase), std::move(minimum.solution));
    };
    for (std::size_t k = 0; k < grid; ++k) consider(std::vector<std::size_t>(rows_.size(), k));
    std::mt19937_64 random(1);
    for (int s = 0; s < random_starts; ++s) {
      std::vector<std::size_t> start;
      for (std::size_t r = 0; r < rows_.size(); ++r) start.push_back(random() % grid);
      consider(std::move(start));
    }
    std::vector<Minimum> all, result;
    for (auto& [phase, solution] : found) all.push_back({phase, std::move(solution)});
    std::stable_sort(all.begin(), all.end(),
                     [](const Minimum& a, const Minimum& b) { return a.solution.misfit < b.solution.misfit; });
    for (const Minimum& minimum : all) {
      if (result.size() == most_minima || minimum.solution.misfit > grid_misfit * all.front().solution.misfit)
        break;
      const bool known = std::any_of(result.begin(), result.end(), [&](const Minimum& other) {
        return near(angles(other.phase), angles(minimum.phase), same_on_grid);
      });
      if (!known) result.push_back(minimum);
    }
    return result;
  }

 private:
  static Equations mean_equations(const EquationData& data, const PhaseProblem& problem,
                                  const RecordMembers& record, const CaseFit& together) {
    Equations mean;
    for (const std::size_t i : record.observations) {
      const EquationData::Rows rows =
          data.rows(i, together.columns, together.state.at, problem.known.natural_frequency);
      VectorXd weight(rows.response.size());
      for (Index r = 0; r < weight.size(); ++r)
        weight(r) = 1 / (data.first_scale(i, rows.block[static_cast<std::size_t>(r)]) *
                         std::sqrt(static_cast<double>(record.observations.size())));
      const MatrixXd design = weight.asDiagonal() * rows.design;
      const VectorXd response = weight.cwiseProduct(rows.response);
      mean.design = mean.response.size() == 0 ? design : MatrixXd(mean.design + design);
      mean.response = mean.response.size() == 0 ? response : VectorXd(mean.response + response);
    }
    return mean;
  }

  static std::size_t nearest(const std::vector<Equations>& record, const VectorXd& values) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < record.size(); ++k) {
      const double misfit = (record[k].response - record[k].design * values).squaredNorm();
      if (misfit >= least) continue;
      least = misfit;
      best = k;
    }
    return best;
  }

  std::vector<std::vector<Equations>> rows_;  // [record][phase]
};

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

/// The minimum at the measured noise, from a start near it.
struct PhaseFit {
  std::vector<double> ahead;  // by record
  double f = 0, p_value = 1;
  double misfit = 0, left = 0;  // what phases leave, squared, and its degrees of freedom
  VectorXd coefficient,
      contribution;  // by column; the second: its root mean square in the rows, in units of their noise
};

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
  for (int step = 0; step < most_steps; ++step) {
    ObservationSet set = turned(problem, phases.ahead);
    set.phase_unknown = true;
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

// Minima that the measured noise does not tell apart, the lowest first.
std::vector<PhaseFit> equal_minima(const PhaseProblem& problem, const PhaseGrid& table) {
  std::vector<PhaseFit> found;
  for (const PhaseGrid::Minimum& minimum : table.minima()) {
    std::optional<PhaseFit> phases = refined(problem, PhaseGrid::angles(minimum.phase));
    if (!phases || !(phases->left >= 1)) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const PhaseFit& other) {
      return near(other.ahead, phases->ahead, same_phase);
    });
    if (!known) found.push_back(std::move(*phases));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const PhaseFit& a, const PhaseFit& b) { return a.misfit < b.misfit; });
  while (!found.empty() && (found.back().misfit - found.front().misfit) * found.front().left >
                               chi_squared_upper_quantile(false_alarm, 1) * found.front().misfit)
    found.pop_back();
  return found;
}

// How many observations of a case are stable motions of the modulation equations: one that stood still for
// seconds is.
std::size_t stable_motions(const ObservationSet& set, const VectorXd& parameters) {
  const ModeFrequencies modes = mode_frequencies(*set.model, *set.resonance);
  std::vector<Index> moving;
  for (std::size_t k = 0; k < set.model->modes(); ++k)
    if (modes.oscillates[k])
      moving.insert(moving.end(), {static_cast<Index>(2 * k), static_cast<Index>(2 * k + 1)});
  const auto size = static_cast<Index>(2 * set.model->modes());
  std::size_t stable = 0;
  for (const Observation& o : set.observations) {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(size, size);
    set.resonance->modulation_jacobian(parameters.data(), o.excitation_frequency.data(), o.amplitude.data(),
                                       o.forcing.data(), jacobian.data());
    const MatrixXd own = jacobian(moving, moving);
    if (!own.allFinite()) continue;
    const Eigen::VectorXcd growth = own.eigenvalues();
    if (growth.real().maxCoeff() <= no_growth * growth.cwiseAbs().maxCoeff()) ++stable;
  }
  return stable;
}

// Without the phase, amplitudes alone do not tell a damping from its negative, nor which way the force acts. Of the
// minima that fit alike, those count whose measured motions are stable; of these the one with phases nearest to the
// measured ones, if those tell it (with phases at random, twice the squared sum of their cosines over their number
// is chi-squared with one degree of freedom), else that in which the excitation acts in its positive direction.
struct Choice {
  PhaseFit phases;
  bool sign_told = true;
};

ObservationSet with_phases(const PhaseProblem& problem, const PhaseFit& phases) {
  ObservationSet set = turned(problem, phases.ahead);
  set.phase_unknown = true;
  return set;
}

double resultant(const std::vector<double>& ahead) {
  double sum = 0;
  for (const double angle : ahead) sum += std::cos(angle);
  return sum;
}

Choice choose(const std::vector<PhaseFit>& minima, const std::function<std::size_t(const PhaseFit&)>& stable) {
  std::vector<std::pair<std::size_t, const PhaseFit*>> by_stability;
  for (const PhaseFit& minimum : minima) by_stability.emplace_back(stable(minimum), &minimum);
  const std::size_t most = std::max_element(by_stability.begin(), by_stability.end())->first;
  std::erase_if(by_stability, [&](const auto& one) { return one.first < most; });
  const auto nearest = std::max_element(by_stability.begin(), by_stability.end(), [](const auto& a, const auto& b) {
    return resultant(a.second->ahead) < resultant(b.second->ahead);
  });
  if (by_stability.size() == 1) return {*nearest->second, true};
  const double sum = resultant(nearest->second->ahead);
  if (2 * sum * sum / static_cast<double>(nearest->second->ahead.size()) >
      chi_squared_upper_quantile(sign_alarm, 1))
    return {*nearest->second, true};
  const VectorXd difference = by_stability[0].second->contribution - by_stability[1].second->contribution;
  Index turns = 0;
  difference.cwiseAbs().maxCoeff(&turns);
  const auto positive = std::max_element(
      by_stability.begin(), by_stability.end(),
      [&](const auto& a, const auto& b) { return a.second->coefficient(turns) < b.second->coefficient(turns); });
  return {*positive->second, false};
}

// Whether an equation of a case did not hold, or could not be judged.
bool misfits(const Estimate& estimate, std::string_view resonance) {
  for (const CaseLackOfFit& tests : estimate.lack_of_fit)
    if (tests.resonance == resonance)
      return std::any_of(tests.equations.begin(), tests.equations.end(),
                         [](const LackOfFit& test) { return test.significant; });
  return true;
}

CaseLateness lateness_of(const PhaseProblem& problem, const PhaseFit& phases, bool sign_told) {
  CaseLateness result{std::string(problem.set.resonance->name), {}, phases.f, phases.p_value, sign_told};
  for (std::size_t r = 0; r < problem.records.size(); ++r) {
    const Observation& o = problem.set.observations[problem.records[r].observations.front()];
    const double frequency = o.excitation_frequency.front(), period = 2 * std::numbers::pi / frequency;
    // An excitation that has to be put ahead by an angle is early: its responses are ahead of time.
    const double late = std::remainder(-phases.ahead[r] / frequency, period);
    result.records.push_back({problem.records[r].record, late, period});
  }
  return result;
}

}  // namespace

std::string text_of(const CaseLateness& lateness) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const RecordLateness& record : lateness.records) {
    least = std::min(least, record.late_s);
    most = std::max(most, record.late_s);
  }
  return fmt::format(
      "case {}: excitation and responses of {} records are not in step: the responses look {:.3g} to {:.3g} ms "
      "late "
      "(of a period of {:.3g} ms). The phase of each record is estimated with the parameters, and no number rests "
      "on "
      "what was measured of it{}. Check that both are recorded by one clock, with one trigger and filters alike",
      lateness.resonance, lateness.records.size(), 1e3 * least, 1e3 * most, 1e3 * lateness.records.front().period_s,
      lateness.sign_told
          ? ""
          : "; whether the excitation acts with or against its sign is not told, and with it is assumed");
}

UnknownPhases find_unknown_phases(std::span<const ObservationSet> sets, const MeasuredUnits& units,
                                  const EstimateOptions& options, const Estimate& estimate) {
  UnknownPhases result{{sets.begin(), sets.end()}, {}};
  const Estimation e(sets, units, options);
  for (std::size_t s = 0; s < e.sets.size(); ++s) {
    const ObservationSet& set = *e.sets[s];
    if (!set.resonance->excited || set.phase_unknown || !misfits(estimate, set.resonance->name)) continue;
    const std::vector<std::size_t>& blocks = estimate.state->blocks[s];
    const PhaseProblem problem{set, blocks, e.knowledge, members_of(set, blocks), options.threads};
    const CaseFit together = fit_case(set, blocks, e.knowledge, {.rough = true, .threads = options.threads});
    if (together.columns.empty() || problem.records.empty()) continue;
    const PhaseGrid table(problem, together);
    const std::vector<PhaseFit> minima = equal_minima(problem, table);
    if (minima.empty() || minima.front().p_value >= false_alarm) continue;
    const std::size_t place = static_cast<std::size_t>(&set - sets.data());
    EstimateOptions quick = options;
    quick.judge_fit = quick.damping_laws = false;
    quick.rough_errors = true;
    quick.bootstrap = 0;
    const Choice choice = choose(minima, [&](const PhaseFit& phases) {
      result.sets[place] = with_phases(problem, phases);
      return stable_motions(result.sets[place], secular::estimate(result.sets, units, quick).parameter_values);
    });
    result.sets[place] = with_phases(problem, choice.phases);
    result.cases.push_back(lateness_of(problem, choice.phases, choice.sign_told));
  }
  return result;
}

}  // namespace secular
