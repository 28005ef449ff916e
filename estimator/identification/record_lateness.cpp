#include "estimator/identification/record_lateness.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "estimator/identification/case_quality.hpp"
#include "estimator/identification/estimation.hpp"
#include "estimator/identification/lateness_sign.hpp"
#include "estimator/identification/phase_fit.hpp"
#include "estimator/identification/phase_grid.hpp"
#include "estimator/identification/unsupported_values.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Probability that records whose phases hold, of a model that holds, are said to be late.
constexpr auto& false_lateness = estimator_thresholds().false_lateness;

/// Of a rate of growth, next to the largest rate of the motion: rounding, and the frequency that a resonance leaves
/// free.
constexpr double no_growth = 1e-6;

/// Of the error of a phase: less moves no number by what it would be seen by.
constexpr double enough_of_error = 0.1;

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

// A case whose records are late, or look like that.
struct LateCase {
  std::size_t place = 0;  // among the sets
  PhaseProblem problem;
  CaseFit together;                 // with phases as measured
  std::vector<PhaseFit> minima;     // that neither noise nor stability tells apart
  std::optional<std::size_t> told;  // of them
};

// Without the phase, amplitudes alone do not tell a damping from its negative: of the minima that fit alike, those
// count whose measured motions are stable.
void keep_stable(std::vector<PhaseFit>& minima, const std::function<std::size_t(const PhaseFit&)>& stable) {
  std::vector<std::size_t> motions;
  for (const PhaseFit& minimum : minima) motions.push_back(stable(minimum));
  const std::size_t most = *std::max_element(motions.begin(), motions.end());
  std::vector<PhaseFit> kept;
  for (std::size_t m = 0; m < minima.size(); ++m)
    if (motions[m] == most) kept.push_back(std::move(minima[m]));
  minima = std::move(kept);
}

// An excitation that has to be put ahead by an angle is early: its responses are ahead of time.
LatenessOfRecords lateness_by(const PhaseProblem& problem, const PhaseFit& phases) {
  std::vector<double> frequency;
  for (const RecordMembers& record : problem.records)
    frequency.push_back(problem.set.observations[record.observations.front()].excitation_frequency.front());
  return lateness_of_records(phases.ahead, frequency);
}

std::vector<LatenessOfRecords> lateness_by_minimum(const LateCase& late) {
  std::vector<LatenessOfRecords> result;
  for (const PhaseFit& minimum : late.minima) result.push_back(lateness_by(late.problem, minimum));
  return result;
}

// Nor which way the force acts: minima half a period apart. What a case does not tell itself others may, whose
// records the same recorder took.
void tell_signs(std::vector<LateCase>& cases) {
  std::vector<double> known;
  for (LateCase& late : cases) {
    const std::vector<LatenessOfRecords> minima = lateness_by_minimum(late);
    late.told = minima.size() == 1 ? 0 : told_by_own_lateness(minima);
    if (late.told) known.insert(known.end(), minima[*late.told].late_s.begin(), minima[*late.told].late_s.end());
  }
  for (LateCase& late : cases)
    if (!late.told) late.told = told_by_other_lateness(lateness_by_minimum(late), known);
}

// By column: what differs most between the first two minima turns its sign.
Index turning_column(const LateCase& late) {
  const VectorXd difference = late.minima[0].contribution - late.minima[1].contribution;
  Index turns = 0;
  difference.cwiseAbs().maxCoeff(&turns);
  return turns;
}

// The one that is determined, or that in which the coefficient that turns its sign is positive.
std::size_t chosen(const LateCase& late) {
  if (late.told) return *late.told;
  const Index turns = turning_column(late);
  const auto positive = std::max_element(
      late.minima.begin(), late.minima.end(),
      [&](const PhaseFit& a, const PhaseFit& b) { return a.coefficient(turns) < b.coefficient(turns); });
  return static_cast<std::size_t>(positive - late.minima.begin());
}

bool is_judged(const Estimate& estimate, std::string_view resonance) {
  return std::any_of(estimate.lack_of_fit.begin(), estimate.lack_of_fit.end(),
                     [&](const CaseLackOfFit& tests) { return tests.resonance == resonance; });
}

// Squares of what phases differ by from those of one delay of all records.
double squares_of_one_delay(const PhaseProblem& problem, const PhaseFit& phases) {
  const LatenessOfRecords late = lateness_by(problem, phases);
  const auto records = static_cast<Index>(late.late_s.size());
  VectorXd frequency(records), angle(records);
  for (Index r = 0; r < records; ++r) {
    const auto at = static_cast<std::size_t>(r);
    const Observation& o = problem.set.observations[problem.records[at].observations.front()];
    frequency(r) = o.excitation_frequency.front();
    angle(r) = frequency(r) * late.late_s[at];
  }
  return least_squares({MatrixXd(frequency), angle}).sum_of_squares;
}

// A law that the model lacks turns phases, too: with D_r what a phase does to the modulation equation, a law
// z(b) = sum_k z_k b^k of the amplitude b makes psi_r = -Re(conj(D_r) z(b_r) b_r)/|D_r|^2. A delay, or the angle
// that it makes, is the same in all records or comes at random. Whether the first leaves less than the second, in
// variances (F; 0.1 %).
bool follow_the_amplitude(const PhaseProblem& problem, const PhaseFit& phases) {
  const auto records = static_cast<Index>(phases.ahead.size());
  const ModeFrequencies modes = mode_frequencies(*problem.set.model, *problem.set.resonance);
  VectorXd amplitude = VectorXd::Zero(records), phase(records);
  for (Index r = 0; r < records; ++r) {
    const auto at = static_cast<std::size_t>(r);
    const Observation& o = problem.set.observations[problem.records[at].observations.front()];
    for (std::size_t k = 0; k < o.amplitude.size(); ++k)
      if (modes.oscillates[k]) amplitude(r) = std::max(amplitude(r), std::abs(o.amplitude[k]));
    phase(r) = std::remainder(phases.ahead[at], 2 * std::numbers::pi);
  }
  if (!(amplitude.maxCoeff() > 0)) return false;
  amplitude /= amplitude.maxCoeff();
  constexpr int powers[] = {0, 2, 4};
  MatrixXd law = MatrixXd::Zero(records, 2 * std::ssize(powers));
  for (Index r = 0; r < records; ++r) {
    const std::complex<double> effect = phases.effect[static_cast<std::size_t>(r)];
    if (!(std::norm(effect) > 0)) continue;
    for (Index k = 0; k < std::ssize(powers); ++k) {
      const double size = std::pow(amplitude(r), powers[k] + 1) / std::norm(effect);
      law(r, 2 * k) = size * effect.real();
      law(r, 2 * k + 1) = size * effect.imag();
    }
  }
  const Solution by_law = least_squares({law, phase}), same = least_squares({MatrixXd::Ones(records, 1), phase});
  const auto left = static_cast<double>(records - by_law.rank), of_same = static_cast<double>(records - 1);
  if (left < 1 || !(by_law.sum_of_squares > 0)) return false;
  const double without_law = std::min(same.sum_of_squares, squares_of_one_delay(problem, phases));
  return f_upper_tail(without_law / of_same / (by_law.sum_of_squares / left), of_same, left) < false_lateness;
}

CaseLateness lateness_of(const PhaseProblem& problem, const PhaseFit& phases, std::string assumed_positive) {
  CaseLateness result{std::string(problem.set.resonance->name),
                      PhaseFinding::late,
                      {},
                      phases.f,
                      phases.p_value,
                      std::move(assumed_positive)};
  const LatenessOfRecords late = lateness_by(problem, phases);
  for (std::size_t r = 0; r < problem.records.size(); ++r) {
    const Observation& o = problem.set.observations[problem.records[r].observations.front()];
    result.records.push_back(
        {problem.records[r].record, late.late_s[r], 2 * std::numbers::pi / o.excitation_frequency.front()});
  }
  return result;
}

}  // namespace

std::string_view name_of(PhaseFinding finding) {
  switch (finding) {
    case PhaseFinding::late:
      return "shifted";  // the word of estimate.json
    case PhaseFinding::in_part:
      return "in_part";
    case PhaseFinding::nothing_told:
      return "nothing_told";
    case PhaseFinding::like_a_law:
      return "like_a_law";
  }
  return "";
}

std::string text_of(const CaseLateness& lateness) {
  const char* const better =
      "the equations hold far better if the phase between excitation and responses is a free number in each record";
  if (lateness.finding == PhaseFinding::like_a_law)
    return fmt::format(
        "case {}: {}, and these phases follow the amplitude: the model lacks a stiffness or a damping, or records "
        "are "
        "out of step; numbers that free phases move are doubtful",
        lateness.resonance, better);
  if (lateness.finding == PhaseFinding::in_part)
    return fmt::format(
        "case {}: {}, though not well: records are out of step, or the model lacks something; numbers that free "
        "phases "
        "move are doubtful",
        lateness.resonance, better);
  if (lateness.finding == PhaseFinding::nothing_told)
    return fmt::format(
        "case {}: {}, but without that phase these conditions do not determine the parameters: no numbers are "
        "given. "
        "Check that excitation and responses are recorded by one clock, with one trigger and filters alike, and "
        "that the model lacks no stiffness; dwells further from phase resonance would determine them",
        lateness.resonance, better);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const RecordLateness& record : lateness.records) {
    least = std::min(least, record.late_s);
    most = std::max(most, record.late_s);
  }
  const std::string sign = lateness.assumed_positive.empty()
                               ? ""
                               : fmt::format(
                                     "; the sign of the excitation's effect is not determined: {} is taken as "
                                     "positive, and numbers that this "
                                     "turns are doubtful",
                                     lateness.assumed_positive);
  const std::string from = fmt::format("{:.3g}", 1e3 * least), to = fmt::format("{:.3g}", 1e3 * most);
  return fmt::format(
      "case {}: excitation and responses are not in step. In {} records the responses are {} ms later "
      "than the excitation (negative: earlier; a period is {:.3g} ms). The phase of each record is therefore "
      "estimated with the parameters, which rest on amplitudes and frequencies alone{}. Check that both are "
      "recorded "
      "by one clock, with one trigger and filters alike",
      lateness.resonance, lateness.records.size(), from == to ? from : from + " to " + to,
      1e3 * lateness.records.front().period_s, sign);
}

UnknownPhases find_unknown_phases(std::span<const ObservationSet> sets, const MeasuredUnits& units,
                                  const EstimateOptions& options, const Estimate& estimate) {
  UnknownPhases result{{sets.begin(), sets.end()}, {}, {}};
  const Estimation e(sets, units, options);
  const std::set<std::string> not_fitting = cases_with_lack_of_fit(estimate);
  std::vector<LateCase> cases;
  for (std::size_t s = 0; s < e.sets.size(); ++s) {
    const ObservationSet& set = *e.sets[s];
    // The delay of several excitations has no period that a grid of phases covers.
    if (!set.resonance->excited || set.model->excitations.size() != 1 || set.phase_unknown) continue;
    const std::string name(set.resonance->name);
    if (is_judged(estimate, name) && !not_fitting.contains(name)) continue;
    const std::vector<std::size_t>& blocks = estimate.state->blocks[s];
    LateCase late{static_cast<std::size_t>(&set - sets.data()),
                  PhaseProblem(set, blocks, e.knowledge, options.threads),
                  fit_case(set, blocks, e.knowledge, {.rough = true, .threads = options.threads}),
                  {},
                  {}};
    if (late.together.columns.empty() || late.problem.records.empty()) continue;
    const GridMinima on_grid = minima_on_grid(late.problem, late.together);
    late.minima = equal_minima(late.problem, on_grid.low);
    if (late.minima.empty()) {
      if (on_grid.p_value < false_lateness)
        result.cases.push_back({name, PhaseFinding::nothing_told, {}, 0, on_grid.p_value, ""});
      continue;
    }
    if (late.minima.front().p_value >= false_lateness) continue;
    const auto freed = [&](const PhaseFit& phases) { return with_phases(late.problem, phases.ahead); };
    keep_stable(late.minima, [&](const PhaseFit& phases) {
      result.sets[late.place] = freed(phases);
      return stable_motions(result.sets[late.place],
                            secular::estimate(result.sets, units, options, pass_between()).parameter_values);
    });
    result.sets[late.place] = freed(late.minima.front());
    cases.push_back(std::move(late));
  }
  tell_signs(cases);
  for (const LateCase& late : cases) {
    const std::size_t choice = chosen(late);
    for (std::size_t m = 0; m < late.minima.size(); ++m) {
      ObservationSet freed = with_phases(late.problem, late.minima[m].ahead);
      if (m == choice)
        result.sets[late.place] = std::move(freed);
      else if (!late.told)
        result.rivals.push_back({late.place, std::move(freed)});
    }
    const PhaseFit& phases = late.minima[choice];
    result.cases.push_back(
        lateness_of(late.problem, phases,
                    late.told ? "" : column_name(late.together, static_cast<std::size_t>(turning_column(late)))));
    if (follow_the_amplitude(late.problem, phases)) result.cases.back().finding = PhaseFinding::like_a_law;
  }
  return result;
}

bool refine_phases(UnknownPhases& unknown, std::span<const ObservationSet> corrected, const MeasuredUnits& units,
                   const EstimateOptions& options, const Estimate& estimate) {
  if (corrected.empty()) return false;
  const Estimation e(corrected, units, options);
  bool moved = false;
  for (std::size_t s = 0; s < e.sets.size(); ++s) {
    const ObservationSet& set = *e.sets[s];
    const auto place = static_cast<std::size_t>(&set - corrected.data());
    const auto found = std::find_if(unknown.cases.begin(), unknown.cases.end(), [&](const CaseLateness& lateness) {
      return lateness.resonance == set.resonance->name && lateness.finding == PhaseFinding::late;
    });
    if (!set.phase_unknown || found == unknown.cases.end()) continue;
    const PhaseProblem problem(set, estimate.state->blocks[s], e.knowledge, options.threads);
    const std::optional<PhaseFit> phases = nearest_minimum(problem);
    if (!phases) continue;
    for (std::size_t r = 0; r < phases->ahead.size(); ++r)
      moved = moved || std::abs(phases->ahead[r]) > enough_of_error * phases->sd[r];
    turn(unknown.sets[place], problem.records, phases->ahead);
    for (UnknownPhases::Rival& rival : unknown.rivals)  // half a turn away the equations are the same
      if (rival.place == place) turn(rival.set, problem.records, phases->ahead);
    for (std::size_t r = 0; r < phases->ahead.size(); ++r)
      for (RecordLateness& record : found->records)
        if (record.record == problem.records[r].record)
          record.late_s -= phases->ahead[r] / (2 * std::numbers::pi) * record.period_s;
  }
  return moved;
}

}  // namespace secular
