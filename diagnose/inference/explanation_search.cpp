#include "diagnose/inference/explanation_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

ExplanationSearch::ExplanationSearch(Discrepancy& discrepancy, const std::vector<Candidate>& all_candidates,
                                     const std::vector<std::size_t>& all_of_own,
                                     const InferenceOptions& all_options, Index unknowns)
    : candidates(all_candidates),
      all_own(all_of_own),
      options(all_options),
      fitter(discrepancy, unknowns, all_options.threads, all_options.after_own_fit),
      price(0.5 * std::log(std::max(2.0, fitter.rows()))),
      own(all_of_own) {}

double ExplanationSearch::dispersion_of(const Explanation& e) const {
  return e.fit.chi_squared / std::max(1.0, fitter.rows() - static_cast<double>(e.fit.rank));
}

Explanation ExplanationSearch::explain(const std::vector<std::size_t>& members, const VectorXd& start) {
  Explanation e = explanation_by(members, fitter.fit_beside(start, free_of(members)), candidates);
  const std::size_t done = ++fitted;
  if (options.progress) options.progress(done, std::max(done + 1, expected));
  return e;
}

void ExplanationSearch::refit_found() {
  in_parallel(found.size(), options.threads,
              [&](std::size_t i) { found[i].fit = fitter.fit_beside(found[i].fit.unknowns, found[i].fit.free); });
  keep_best_of_each(found, candidates);
}

void ExplanationSearch::take_gains(const std::vector<Screening>& screened) {
  result.linear_gain.clear();
  result.gain_of_records.clear();
  for (const Screening& s : screened) {
    result.linear_gain.push_back(s.gain);
    result.gain_of_records.push_back(s.of_records);
  }
}

}  // namespace secular
