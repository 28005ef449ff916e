#include "diagnose/inference/weighing.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// All of log evidence but what the rows say.
double before_rows(const Explanation& e, const std::vector<Candidate>& candidates, const Weights& weights) {
  double evidence = -weights.price * static_cast<double>(e.unknowns);
  if (e.members.size() > 1) evidence += std::log(weights.prior_second);
  if (has_open_law(e, candidates)) evidence += std::log(weights.prior_open_law);
  return evidence;
}

}  // namespace

double dependence_of_rows(const VectorXd& best, const VectorXd& rival, const std::vector<int>& folds,
                          double dispersion) {
  if (best.size() != rival.size() || best.size() != static_cast<Index>(folds.size())) return 1;
  const VectorXd difference = rival - best;
  std::map<int, double> of_fold;
  for (std::size_t r = 0; r < folds.size(); ++r)
    of_fold[folds[r]] += best(static_cast<Index>(r)) * difference(static_cast<Index>(r));
  const double independent = dispersion * difference.squaredNorm();
  const auto count = static_cast<double>(of_fold.size());
  if (count < 2 || !(independent > 0)) return 1;
  double square = 0;
  for (const auto& [fold, sum] : of_fold) square += sum * sum;
  const double beside_noise = 1 - 1 / dispersion;
  return 1 + beside_noise * std::max(0.0, count / (count - 1) * square / independent - 1);
}

double log_evidence(const Explanation& e, const std::vector<Candidate>& candidates, const Weights& weights) {
  return before_rows(e, candidates, weights) - 0.5 * e.fit.chi_squared / weights.dispersion;
}

void weigh(Explanation& null, std::vector<Explanation>& found, const std::vector<Candidate>& candidates,
           const Weights& weights, const std::vector<int>& folds) {
  null.log_evidence = log_evidence(null, candidates, weights);
  for (Explanation& e : found) e.log_evidence = log_evidence(e, candidates, weights);
  const auto less_likely = [](const Explanation& a, const Explanation& b) {
    return a.log_evidence < b.log_evidence;
  };
  const auto first = std::max_element(found.begin(), found.end(), less_likely);
  const Explanation best = first == found.end() || less_likely(*first, null) ? null : *first;
  const auto weigh_one = [&](Explanation& e) {
    e.dependence = dependence_of_rows(best.fit.rows, e.fit.rows, folds, weights.dispersion);
    const double more = 0.5 * (e.fit.chi_squared - best.fit.chi_squared) / weights.dispersion;
    e.log_evidence =
        before_rows(e, candidates, weights) - 0.5 * best.fit.chi_squared / weights.dispersion - more / e.dependence;
  };
  weigh_one(null);
  for (Explanation& e : found) weigh_one(e);
  std::stable_sort(found.begin(), found.end(),
                   [&](const Explanation& a, const Explanation& b) { return less_likely(b, a); });
}

}  // namespace secular
