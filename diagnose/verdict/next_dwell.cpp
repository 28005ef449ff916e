#include "diagnose/verdict/next_dwell.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "diagnose/evidence/line_evidence.hpp"
#include "diagnose/evidence/virtual_dwell.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
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

// `dwells`: a test's, under every hypothesis; empty: it is not possible.
PossibleTest possible(const ConditionModel& model, const Condition& measured, const Test& test,
                      std::vector<Condition> dwells) {
  if (dwells.empty()) return {};
  PossibleTest result;
  const Condition& likeliest = dwells.front();
  result.proposed.like = measured.record;
  result.proposed.level = test.level;
  result.proposed.channel = model.sensors().excitation_names.front();
  result.proposed.excitation = drive(likeliest);
  result.proposed.frequency = likeliest.excitation_frequency();
  result.proposed.resonance = resonance_of(likeliest, model.balance().model());
  result.rows = [&model, dwells = std::move(dwells)](std::size_t truth, const VectorXd& unknowns, double length) {
    Condition dwell = dwells[truth];
    dwell.response_sd /= std::sqrt(length);
    dwell.excitation_sd /= std::sqrt(length);
    Discrepancy rows;
    rows.add(std::make_unique<LineEvidence>(model, std::vector{std::move(dwell)}, unknowns));
    return rows;
  };
  return result;
}

}  // namespace

ProposedTest next_dwell(const ConditionModel& model, const std::vector<Condition>& conditions,
                        const std::vector<Hypothesis>& hypotheses, const ProposalOptions& options) {
  if (hypotheses.size() < 2) return {};
  const std::vector<Test> tests = tests_around(conditions, options.highest_level);
  std::vector<PossibleTest> all(tests.size());
  in_parallel(tests.size(), options.threads, [&](std::size_t t) {
    const Condition& measured = conditions[tests[t].condition];
    all[t] = possible(model, measured, tests[t], predicted(model, measured, tests[t], hypotheses));
  });
  return best_test(all, hypotheses, options);
}

}  // namespace secular
