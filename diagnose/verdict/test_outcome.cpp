#include "diagnose/verdict/test_outcome.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// A test with this chance of leaving one hypothesis need not be longer.
constexpr auto& as_good_as_certain = diagnose_thresholds().as_good_as_certain;

// How a test that goes as one hypothesis predicts is judged by another one.
struct Judgement {
  double separation = 0;  ///< squared, in standard deviations
  std::string watch;
};

// What a test is expected to tell.
struct Outcome {
  double probability = 0;  ///< of the right hypothesis
  double chance = 0;       ///< of leaving it alone
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

Judgement judged(Discrepancy& test, const Refit& fit, double dispersion) {
  test.freeze(fit.unknowns);
  const VectorXd rows = test(fit.unknowns);
  const MatrixXd jacobian = test.slopes(fit.unknowns, fit.free, fit.scale, 1);
  MatrixXd freedom = fit.covariance * dispersion;
  for (Index f = 0; f < freedom.rows(); ++f) {
    const double scale = fit.scale(f) > 0 ? fit.scale(f) : 1;
    freedom.row(f) /= scale;
    freedom.col(f) /= scale;
    if (!fit.identifiable[static_cast<std::size_t>(f)]) freedom(f, f) = unknown_variance;
  }
  Judgement result;
  if (!rows.allFinite() || !jacobian.allFinite() || rows.size() == 0) return result;
  // (s + J P J')^-1 = (1 - J (s + P J'J)^-1 P J')/s: as many equations as unknowns, not as rows.
  VectorXd explained = rows / dispersion;
  if (freedom.rows() > 0) {
    MatrixXd inner = freedom * (jacobian.transpose() * jacobian);
    inner.diagonal().array() += dispersion;
    explained -= jacobian *
                 VectorXd(inner.partialPivLu().solve(VectorXd(freedom * (jacobian.transpose() * rows)))) /
                 dispersion;
  }
  result.separation = std::max(0.0, rows.dot(explained));
  Index strongest = 0;
  rows.cwiseProduct(explained).maxCoeff(&strongest);
  const RowLabel label = test.labels()[static_cast<std::size_t>(strongest)];
  result.watch = (label.balance ? "balance of " : "channel ") + label.place + ", " + label.harmonic;
  return result;
}

Outcome outcome_of(const PossibleTest& test, const std::vector<Hypothesis>& hypotheses, double length,
                   double dispersion) {
  const std::size_t count = hypotheses.size();
  MatrixXd separation = MatrixXd::Zero(static_cast<Index>(count), static_cast<Index>(count));
  Outcome outcome;
  double closest = INFINITY;
  for (std::size_t h = 0; h < count; ++h)
    for (std::size_t g = 0; g < count; ++g) {
      if (g == h) continue;
      const Refit& judge = hypotheses[g].explanation->fit;
      Discrepancy rows = test.rows(h, judge.unknowns, length);
      const Judgement judgement = judged(rows, judge, dispersion);
      separation(static_cast<Index>(h), static_cast<Index>(g)) = judgement.separation;
      if (!(judgement.separation < closest)) continue;
      closest = judgement.separation;
      outcome.watch = judgement.watch;
    }
  outcome.separation = std::sqrt(closest);
  outcome.probability = expected_probability(hypotheses, separation);
  outcome.chance = expected_chance(hypotheses, separation);
  return outcome;
}

std::pair<double, double> safety(const Outcome& outcome) {
  return {std::min(outcome.probability, 0.999), outcome.separation};
}

ProposedTest best_of_length(const std::vector<PossibleTest>& tests, const std::vector<Hypothesis>& hypotheses,
                            double length, const ProposalOptions& options) {
  std::vector<std::optional<Outcome>> outcomes(tests.size());
  in_parallel(tests.size(), options.threads, [&](std::size_t t) {
    if (tests[t].rows) outcomes[t] = outcome_of(tests[t], hypotheses, length, options.dispersion);
  });
  std::optional<std::size_t> chosen;
  std::size_t compared = 0;
  double sum = 0;
  for (std::size_t t = 0; t < tests.size(); ++t) {
    if (!outcomes[t]) continue;
    ++compared;
    sum += outcomes[t]->probability;
    if (!chosen || safety(*outcomes[t]) > safety(*outcomes[*chosen])) chosen = t;
  }
  if (!chosen) return {};
  ProposedTest best = tests[*chosen].proposed;
  const Outcome& own = *outcomes[*chosen];
  best.separation = own.separation;
  best.watch = own.watch;
  best.probability = own.probability;
  best.chance = own.chance;
  best.length = length;
  best.compared = compared;
  best.typical = sum / static_cast<double>(compared);
  return best;
}

}  // namespace

ProposedTest best_test(const std::vector<PossibleTest>& tests, const std::vector<Hypothesis>& hypotheses,
                       const ProposalOptions& options) {
  ProposedTest best;
  for (const double length : test_lengths) {
    best = best_of_length(tests, hypotheses, length, options);
    if (best.compared == 0 || best.chance > as_good_as_certain) break;
  }
  const auto count = static_cast<Index>(hypotheses.size());
  best.before = expected_probability(hypotheses, MatrixXd::Zero(count, count));
  return best;
}

}  // namespace secular
