#include "diagnose/inference/inference.hpp"

#include <algorithm>
#include <utility>

#include "diagnose/inference/explanation_search.hpp"
#include "diagnose/inference/fits_afresh.hpp"
#include "diagnose/inference/near_fits.hpp"
#include "diagnose/inference/null_fit.hpp"
#include "diagnose/inference/pair_fits.hpp"
#include "diagnose/inference/parts_of_rows.hpp"
#include "diagnose/inference/single_fits.hpp"
#include "diagnose/inference/weighing.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// A fit along a curved valley takes so many times the steps of others (tuned: of three steps there, two are
/// refused and only set the length of the third).
constexpr int longer_in_valleys = 4;

void release_anchors(ExplanationSearch& search) {
  search.own = search.all_own;
  for (Explanation& e : search.found) e.fit.free = search.free_of(e.members);
  search.freeze_at_level(search.found.front().fit.unknowns);
  search.refit_found();
}

// Down to the errors of the measurement with the explanations; with two effects as soon as one is not enough.
void descend(ExplanationSearch& search) {
  std::vector<Explanation>& found = search.found;
  bool paired = false;
  if (search.own.size() < search.all_own.size()) {
    paired = !found.empty() && search.misses(found.front().fit);
    if (paired) add_pairs(search);
    if (!found.empty()) release_anchors(search);
  }
  for (; search.level < finest_level && !found.empty(); ++search.level) {
    Explanation& best = found.front();
    const double finer = coarse_levels[search.level + 1];
    search.fitter.freeze(best.fit.unknowns, finer);
    Refit fit = search.fitter.fit_alone(best.fit.unknowns, best.fit.free);
    if (search.misses(fit) && !paired) {
      search.freeze_at_level(best.fit.unknowns);
      add_pairs(search);
      paired = true;
      if (found.empty()) return;
      search.fitter.freeze(found.front().fit.unknowns, finer);
    } else {
      best.fit = std::move(fit);
    }
    search.refit_found();
  }
}

// Fits that have not come to an end, though nothing of the catalogue that has is better by what an unknown costs:
// a law whose shape trades with its strength and the model's own numbers ends in a curved valley. (A power of any
// exponent comes near to it before, and would be called a law that the catalogue lacks.)
void end_stalled(ExplanationSearch& search) {
  std::vector<Explanation>& found = search.found;
  const auto has_ended = [](const Explanation& e) { return e.fit.ending == SolverEnding::converged; };
  double least = search.result.null.fit.chi_squared;
  for (const Explanation& e : found)
    if (has_ended(e) && !has_open_law(e, search.candidates)) least = std::min(least, e.fit.chi_squared);
  const double dispersion = dispersion_of(least, search.result.degrees_of_freedom);
  RefitOptions options = search.fitter.options();
  options.bends = true;
  options.iterations *= longer_in_valleys;
  in_parallel(found.size(), search.options.threads, [&](std::size_t i) {
    Refit& fit = found[i].fit;
    if (!has_ended(found[i]) && fit.chi_squared < least + 2 * search.price * dispersion)
      fit = search.fitter.fit_beside(fit.unknowns, fit.free, options);
  });
  keep_best_of_each(found, search.candidates);
}

// Coarse errors are a way to walk; what a verdict is read from holds among the true ones.
void settle(ExplanationSearch& search) {
  // A model that leaves no more than noise among its own errors needs none of an explanation: by numbers that
  // others make up for it may be far from there. (Not where what records have of their own makes up for it.)
  settle_null(search, search.found.empty() || search.null_holds ? search.result.null : search.found.front());
  search.refit_found();
  end_stalled(search);
  // Where all rows together show no gap, one candidate may still: beside this null.
  if (!search.leaves_more_than_noise(search.result.null))
    search.take_gains(search.fitter.screen(search.result.null.fit, search.candidates));
}

// Of what parts of the best explanation's rows tell over what independent rows make of it: what a motion of many
// turns is missed by goes on from row to row, and all of it together tells no more than a few rows would.
double dispersion_of_parts(const ExplanationSearch& search) {
  const Explanation* best = &search.result.null;
  for (const Explanation& e : search.found)
    if (e.fit.rank > 0 && e.fit.chi_squared < best->fit.chi_squared) best = &e;
  return agreement_of_parts(best->fit, parts_by_fold(search.fitter.labels())).dispersion();
}

Inference weighed(ExplanationSearch& search) {
  double dispersion = search.dispersion_of(search.result.null);
  for (const Explanation& e : search.found) dispersion = std::min(dispersion, search.dispersion_of(e));
  if (search.options.near != nullptr) dispersion = std::max(dispersion, dispersion_of_parts(search));
  Inference result = std::move(search.result);
  result.dispersion = std::max(1.0, dispersion);
  result.price = search.price;
  result.explanations = std::move(search.found);
  const Weights weights{result.dispersion, result.price, search.options.prior_second,
                        search.options.prior_open_law};
  weigh(result.null, result.explanations, search.candidates, weights);
  return result;
}

void search_from(ExplanationSearch& search, const VectorXd& start) {
  fit_null(search, start);
  fit_singles(search);
  if (search.found.empty() && search.level != finest_level) {
    settle_null(search, search.result.null);
    fit_singles(search);
  }
  if (!begin_afresh(search, start)) descend(search);
  add_pairs(search);
  if (start_afresh(search, start)) add_pairs(search);
}

}  // namespace

Inference infer(Discrepancy& discrepancy, const std::vector<Candidate>& candidates, const VectorXd& start,
                const std::vector<std::size_t>& own, const InferenceOptions& options) {
  ExplanationSearch search(discrepancy, candidates, own, options, start.size());
  if (options.near != nullptr) {
    fit_near(search, *options.near);
    add_pairs(search);
  } else {
    search_from(search, start);
  }
  settle(search);
  if (options.progress) options.progress(search.fitted, search.fitted);
  return weighed(search);
}

}  // namespace secular
