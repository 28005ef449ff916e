#include "diagnose/inference/weighing.hpp"

#include <algorithm>
#include <cmath>

namespace secular {

double log_evidence(const Explanation& e, const std::vector<Candidate>& candidates, const Weights& weights) {
  double evidence = -0.5 * e.fit.chi_squared / weights.dispersion - weights.price * static_cast<double>(e.unknowns);
  if (e.members.size() > 1) evidence += std::log(weights.prior_second);
  if (has_open_law(e, candidates)) evidence += std::log(weights.prior_open_law);
  return evidence;
}

void weigh(Explanation& null, std::vector<Explanation>& found, const std::vector<Candidate>& candidates,
           const Weights& weights) {
  null.log_evidence = log_evidence(null, candidates, weights);
  for (Explanation& e : found) e.log_evidence = log_evidence(e, candidates, weights);
  std::stable_sort(found.begin(), found.end(),
                   [](const Explanation& a, const Explanation& b) { return a.log_evidence > b.log_evidence; });
}

}  // namespace secular
