#include "diagnose/inference/near_fits.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "diagnose/inference/single_fits.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

/// Explanations that are followed.
constexpr std::size_t most_near = 8;

/// Errors are taken at the best explanation, which may be another one at them.
constexpr int most_changes_of_best = 4;

// The best of all that were found, among errors of its own, and the others at these.
void judge_at_best(ExplanationSearch& search) {
  for (int change = 0; change < most_changes_of_best; ++change) {
    Explanation& best = search.found.front();
    const std::vector<std::size_t> members = best.members;
    best.fit = search.fitter.at_level(best.fit.unknowns, best.fit.free, 0).fit;
    search.refit_found();
    if (search.found.empty() || search.found.front().members == members) return;
  }
}

// In place of a screening: no gain, and every candidate from where it was fitted alone.
void take_singles(ExplanationSearch& search, const Inference& near) {
  search.singles.assign(search.candidates.size(), {});
  search.take_gains(search.singles);
  for (const Explanation& e : near.explanations)
    if (e.members.size() == 1) search.singles[e.members.front()].start = e.fit.unknowns;
}

}  // namespace

void fit_near(ExplanationSearch& search, const Inference& near) {
  search.level = finest_level;
  search.result.null.fit = search.fitter.at_level(near.null.fit.unknowns, search.own, 0).fit;
  search.result.degrees_of_freedom = search.freedom_about_null();
  search.null_holds = !search.fitter.admits_own() && !search.leaves_more_than_noise(search.result.null);
  // Where the other rows saw the gap, what explains it there is known; else it shows here alone.
  if (is_within_noise(near.null.fit.chi_squared, near.degrees_of_freedom))
    fit_singles(search);
  else
    take_singles(search, near);
  const std::size_t count = std::min(most_near, near.explanations.size()), first = search.found.size();
  search.found.resize(first + count);
  search.expected = search.fitted + count;
  in_parallel(count, search.options.threads, [&](std::size_t i) {
    const Explanation& e = near.explanations[i];
    search.found[first + i] = search.explain(e.members, e.fit.unknowns);
  });
  keep_best_of_each(search.found, search.candidates);
  if (!search.found.empty()) judge_at_best(search);
}

}  // namespace secular
