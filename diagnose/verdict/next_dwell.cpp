#include "diagnose/verdict/next_dwell.hpp"

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
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Shifts of the frequency, in parts of the range that the campaign covers at the resonance.
constexpr double shifts[] = {-0.5, -0.2, 0, 0.2, 0.5};

/// Range of frequencies of a resonance that was measured at one frequency only, relative.
constexpr auto& least_range = diagnose_thresholds().least_range;

// Peak.
double drive(const Condition& c) {
  return 2 * c.excitation_level();
}

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
    const double least = lowest_test_level * drive(conditions[members.front()]),
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
      for (const double level : test_levels)
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

  // `length`: of test_lengths.
  ProposedTest best_of(double length) const {
    std::vector<std::optional<TestOutcome>> outcomes(tests_.size());
    in_parallel(tests_.size(), threads_, [&](std::size_t t) { outcomes[t] = outcome_of(dwells_[t], length); });
    const std::optional<std::size_t> chosen = safest(outcomes);
    return chosen ? with_outcome(proposal(*chosen), outcomes, *chosen, length) : ProposedTest{};
  }

 private:
  std::optional<TestOutcome> outcome_of(std::vector<Condition> dwells, double length) const {
    if (dwells.empty()) return std::nullopt;
    for (Condition& dwell : dwells) {
      dwell.response_sd /= std::sqrt(length);
      dwell.excitation_sd /= std::sqrt(length);
    }
    return expected_outcome(hypotheses_, [&](std::size_t truth, const Refit& judge) {
      Discrepancy discrepancy;
      discrepancy.add(std::make_unique<LineEvidence>(model_, std::vector{dwells[truth]}, judge.unknowns));
      return judged(discrepancy, judge, dispersion_);
    });
  }

  ProposedTest proposal(std::size_t test) const {
    const Condition& likeliest = dwells_[test].front();
    ProposedTest proposed;
    proposed.like = conditions_[tests_[test].condition].record;
    proposed.level = tests_[test].level;
    proposed.channel = model_.sensors().excitation_names.front();
    proposed.excitation = drive(likeliest);
    proposed.frequency = likeliest.excitation_frequency();
    proposed.resonance = resonance_of(likeliest, model_.balance().model());
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

ProposedTest next_dwell(const ConditionModel& model, const std::vector<Condition>& conditions,
                        const std::vector<Hypothesis>& hypotheses, const ProposalOptions& options) {
  if (hypotheses.size() < 2) return {};
  const PossibleDwells possible(model, conditions, hypotheses, options);
  return as_long_as_it_takes(hypotheses, [&](double length) { return possible.best_of(length); });
}

}  // namespace secular
