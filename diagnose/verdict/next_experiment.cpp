#include "diagnose/verdict/next_experiment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "diagnose/evidence/line_evidence.hpp"
#include "diagnose/evidence/virtual_dwell.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Variance, in scaled unknowns, of a direction that the campaign says nothing about.
constexpr double unknown_variance = 1e6;

constexpr double level_factors[] = {0.5, 0.7, 1.0, 1.5, 2.0};

/// Shifts of the frequency, in parts of the range that the campaign covers at the resonance.
constexpr double shifts[] = {-0.5, -0.2, 0, 0.2, 0.5};

/// Range of frequencies of a resonance that was measured at one frequency only, relative.
constexpr auto& least_range = diagnose_thresholds().least_range;

constexpr double lowest_level = 0.5;

// Peak.
double drive(const Condition& c) {
  return 2 * c.excitation_level();
}

/// A dwell with this chance of leaving one hypothesis need not be longer.
constexpr auto& as_good_as_certain = diagnose_thresholds().as_good_as_certain;

struct Test {
  std::size_t condition = 0;
  double level = 1, frequency = 1;
};

// Dwells at one resonance: the same line of the same mode, counted from the excitation's.
using Resonance = std::tuple<std::size_t, Index, Index>;

std::vector<Test> tests_around(const std::vector<Condition>& conditions, double highest_level) {
  std::map<Resonance, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Condition& c = conditions[i];
    if (c.torus->dimensions() != 1 || c.masters.empty() || c.fundamental == 0 || !(drive(c) > 0)) continue;
    groups[{c.masters[0].mode, c.masters[0].line, c.fundamental}].push_back(i);
  }
  std::vector<Test> tests;
  for (auto& [resonance, members] : groups) {
    std::sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(drive(conditions[a]), a) < std::pair(drive(conditions[b]), b);
    });
    const double least = lowest_level * drive(conditions[members.front()]),
                 most = highest_level * drive(conditions[members.back()]);
    double low = INFINITY, high = 0;
    for (const std::size_t i : members) {
      low = std::min(low, conditions[i].excitation_frequency());
      high = std::max(high, conditions[i].excitation_frequency());
    }
    const double range = std::max(least_range, high / low - 1);
    std::vector<std::size_t> from = {members.front(), members[members.size() / 2], members.back()};
    from.erase(std::unique(from.begin(), from.end()), from.end());
    for (const std::size_t i : from)
      for (const double level : level_factors)
        for (const double shift : shifts) {
          const double excitation = level * drive(conditions[i]);
          if (excitation < least * (1 - 1e-9) || excitation > most * (1 + 1e-9)) continue;
          tests.push_back({i, level, 1 + shift * range});
        }
  }
  return tests;
}

std::string resonance_of(const Condition& c, const CompiledModel& model) {
  const int excitation = c.torus->phase(c.fundamental)[0], line = c.torus->phase(c.masters[0].line)[0];
  const int common = std::gcd(excitation, line), top = excitation / common, bottom = line / common;
  const std::string drive(model.excitation_frequencies.empty() ? "Omega" : model.excitation_frequencies[0]);
  return drive + " near " + (top == 1 ? "" : std::to_string(top) + " ") +
         std::string(model.symbols[c.masters[0].mode].name) + (bottom == 1 ? "" : "/" + std::to_string(bottom));
}

struct Judgement {
  double separation = 0;  ///< squared, in standard deviations
  std::string watch;
};

// How a dwell is judged by an explanation that is not its own.
Judgement judged(const ConditionModel& model, const Condition& dwell, const Refit& fit, double dispersion) {
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<LineEvidence>(model, std::vector{dwell}, fit.unknowns));
  discrepancy.freeze(fit.unknowns);
  const VectorXd rows = discrepancy(fit.unknowns);
  const MatrixXd jacobian = discrepancy.slopes(fit.unknowns, fit.free, fit.scale, 1);
  MatrixXd freedom = fit.covariance * dispersion;
  for (Index f = 0; f < freedom.rows(); ++f) {
    const double scale = fit.scale(f) > 0 ? fit.scale(f) : 1;
    freedom.row(f) /= scale;
    freedom.col(f) /= scale;
    if (!fit.identifiable[static_cast<std::size_t>(f)]) freedom(f, f) = unknown_variance;
  }
  MatrixXd spread = dispersion * MatrixXd::Identity(rows.size(), rows.size());
  if (freedom.rows() > 0) spread += jacobian * freedom * jacobian.transpose();
  Judgement result;
  if (!rows.allFinite() || !spread.allFinite() || rows.size() == 0) return result;
  const VectorXd explained = spread.ldlt().solve(rows);
  result.separation = std::max(0.0, rows.dot(explained));
  Index strongest = 0;
  rows.cwiseProduct(explained).maxCoeff(&strongest);
  const RowLabel label = discrepancy.labels()[static_cast<std::size_t>(strongest)];
  result.watch = (label.balance ? "balance of " : "channel ") + label.place + ", " + label.harmonic;
  return result;
}

struct Outcome {
  bool possible = false;
  double probability = 0;  ///< expected of the right hypothesis
  double chance = 0;       ///< expected, of leaving it alone
  double separation = 0;   ///< of the closest two
  std::string watch;
};

double expected_probability(const std::vector<Hypothesis>& hypotheses, const MatrixXd& separation) {
  double total = 0, expected = 0;
  for (std::size_t h = 0; h < hypotheses.size(); ++h) {
    double rest = 0;
    for (std::size_t g = 0; g < hypotheses.size(); ++g)
      rest += hypotheses[g].probability * std::exp(-0.5 * separation(static_cast<Index>(h), static_cast<Index>(g)));
    const double p = hypotheses[h].probability;
    expected += p * (p / rest);
    total += p;
  }
  return expected / total;
}

// That no other hypothesis keeps told_apart of the right one's odds.
double expected_chance(const std::vector<Hypothesis>& hypotheses, const MatrixXd& separation) {
  double total = 0, expected = 0;
  for (std::size_t h = 0; h < hypotheses.size(); ++h) {
    double chance = 1;
    for (std::size_t g = 0; g < hypotheses.size(); ++g) {
      if (g == h) continue;
      const double square = separation(static_cast<Index>(h), static_cast<Index>(g));
      const double missing =
          -std::log(diagnose_thresholds().told_apart * hypotheses[h].probability / hypotheses[g].probability);
      const double surely = 0.5 * square - missing;
      chance = std::min(chance, square > 0   ? normal_upper_tail(-surely / std::sqrt(square))
                                : surely > 0 ? 1.0
                                             : 0.0);
    }
    expected += hypotheses[h].probability * chance;
    total += hypotheses[h].probability;
  }
  return expected / total;
}

// A test's dwell under each hypothesis; empty where one of them has no steady motion there.
std::vector<Condition> predicted(const ConditionModel& model, const Condition& measured, const Test& test,
                                 const std::vector<Hypothesis>& hypotheses) {
  std::vector<Condition> dwells;
  for (const Hypothesis& truth : hypotheses) {
    std::optional<Condition> dwell =
        virtual_dwell(model, measured, truth.explanation->fit.unknowns, test.level, test.frequency);
    if (!dwell) return {};
    dwells.push_back(std::move(*dwell));
  }
  return dwells;
}

// Dwells that may be run next, under every hypothesis.
class PossibleDwells {
 public:
  PossibleDwells(const ConditionModel& model, const std::vector<Condition>& conditions,
                 const std::vector<Hypothesis>& hypotheses, const ProposalOptions& options)
      : model_(model),
        conditions_(conditions),
        hypotheses_(hypotheses),
        dispersion_(options.dispersion),
        threads_(options.threads),
        tests_(tests_around(conditions, options.highest_level)),
        dwells_(tests_.size()) {
    in_parallel(tests_.size(), threads_, [&](std::size_t t) {
      dwells_[t] = predicted(model_, conditions_[tests_[t].condition], tests_[t], hypotheses_);
    });
  }

  // `length`: of dwell_lengths.
  ProposedDwell best_of(double length) const {
    std::vector<Outcome> outcomes(tests_.size());
    in_parallel(tests_.size(), threads_, [&](std::size_t t) { outcomes[t] = outcome_of(dwells_[t], length); });
    std::optional<std::size_t> chosen;
    std::size_t compared = 0;
    double sum = 0;
    for (std::size_t t = 0; t < tests_.size(); ++t) {
      if (!outcomes[t].possible) continue;
      ++compared;
      sum += outcomes[t].probability;
      if (!chosen || safety(outcomes[t]) > safety(outcomes[*chosen])) chosen = t;
    }
    if (!chosen) return {};
    ProposedDwell best = proposal(*chosen, outcomes[*chosen]);
    best.length = length;
    best.compared = compared;
    best.typical = sum / static_cast<double>(compared);
    return best;
  }

 private:
  // Expected probabilities saturate; between certain ones the larger separation is the safer test.
  static std::pair<double, double> safety(const Outcome& outcome) {
    return {std::min(outcome.probability, 0.999), outcome.separation};
  }

  Outcome outcome_of(std::vector<Condition> dwells, double length) const {
    const auto count = static_cast<Index>(hypotheses_.size());
    Outcome outcome;
    if (dwells.empty()) return outcome;
    MatrixXd separation = MatrixXd::Zero(count, count);
    double closest = INFINITY;
    for (Index h = 0; h < count; ++h) {
      Condition& dwell = dwells[static_cast<std::size_t>(h)];
      dwell.response_sd /= std::sqrt(length);
      dwell.excitation_sd /= std::sqrt(length);
      for (Index g = 0; g < count; ++g) {
        if (g == h) continue;
        const Judgement judgement =
            judged(model_, dwell, hypotheses_[static_cast<std::size_t>(g)].explanation->fit, dispersion_);
        separation(h, g) = judgement.separation;
        if (judgement.separation < closest) {
          closest = judgement.separation;
          outcome.watch = judgement.watch;
        }
      }
    }
    outcome.possible = true;
    outcome.separation = std::sqrt(closest);
    outcome.probability = expected_probability(hypotheses_, separation);
    outcome.chance = expected_chance(hypotheses_, separation);
    return outcome;
  }

  ProposedDwell proposal(std::size_t test, const Outcome& outcome) const {
    const Condition& likeliest = dwells_[test].front();
    ProposedDwell proposed;
    proposed.like = conditions_[tests_[test].condition].record;
    proposed.level = tests_[test].level;
    proposed.channel = model_.sensors().excitation_names.front();
    proposed.excitation = drive(likeliest);
    proposed.frequency = likeliest.excitation_frequency();
    proposed.resonance = resonance_of(likeliest, model_.balance().model());
    proposed.separation = outcome.separation;
    proposed.watch = outcome.watch;
    proposed.probability = outcome.probability;
    proposed.chance = outcome.chance;
    return proposed;
  }

  const ConditionModel& model_;
  const std::vector<Condition>& conditions_;
  const std::vector<Hypothesis>& hypotheses_;
  double dispersion_;
  unsigned threads_;
  std::vector<Test> tests_;
  std::vector<std::vector<Condition>> dwells_;  // [test][hypothesis]; empty where one has no steady motion
};

}  // namespace

ProposedDwell next_experiment(const ConditionModel& model, const std::vector<Condition>& conditions,
                              const std::vector<Hypothesis>& hypotheses, const ProposalOptions& options) {
  if (hypotheses.size() < 2) return {};
  const PossibleDwells possible(model, conditions, hypotheses, options);
  ProposedDwell best;
  for (const double length : dwell_lengths) {
    best = possible.best_of(length);
    if (best.compared == 0 || best.chance > as_good_as_certain) break;
  }
  const auto count = static_cast<Index>(hypotheses.size());
  best.before = expected_probability(hypotheses, MatrixXd::Zero(count, count));
  return best;
}

}  // namespace secular
