#include "diagnose/inference/null_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// Of fits with numbers that may be far off, relative to the squared length of a column.
constexpr auto& first_damping = diagnose_thresholds().first_damping;

// A model that misses even coarse equations fits best with natural frequencies that nobody would believe, and
// nothing that is added there leads back: it stays near its start, and the rest of its numbers, which enter the
// equations linearly, are all that moves.
Refit anchored_null(ExplanationSearch& search, const VectorXd& start) {
  std::erase_if(search.own, [&](std::size_t u) {
    const std::vector<std::size_t>& anchors = search.options.anchors;
    return std::find(anchors.begin(), anchors.end(), u) != anchors.end();
  });
  search.freeze_at_level(start);
  const Refit first = search.fitter.fit_own(start, search.own, first_damping);
  search.freeze_at_level(first.unknowns);
  return search.fitter.fit_own(first.unknowns, search.own, first_damping);
}

/// Errors taken at a fit move the next one by less and less; where what it leaves is large, by a share of that each
/// time.
constexpr int most_returns = 20;

/// Standard deviations: what moves a number by less is rounding.
constexpr double at_rest = 0.01;

// Of what the rows tell, in standard deviations of rows of unit variance.
double largest_move(const Refit& from, const Refit& to) {
  double largest = 0;
  for (std::size_t f = 0; f < to.free.size(); ++f) {
    const auto place = static_cast<Eigen::Index>(f), unknown = static_cast<Eigen::Index>(to.free[f]);
    const double variance = to.covariance(place, place);
    if (to.identifiable[f] && variance > 0)
      largest = std::max(largest, std::abs(to.unknowns(unknown) - from.unknowns(unknown)) / std::sqrt(variance));
  }
  return largest;
}

}  // namespace

Refit bring_to_rest(Discrepancy& discrepancy, Refit fit, const InferenceOptions& options) {
  Fitter fitter(discrepancy, fit.unknowns.size(), options.threads, options.after_own_fit);
  for (int round = 0; round < most_returns; ++round) {
    fitter.freeze(fit.unknowns, 0, Lookout::close_by);
    Refit next = fitter.fit_own(fit.unknowns, fit.free);
    const double move = largest_move(fit, next);
    fit = std::move(next);
    if (move < at_rest) return fit;
  }
  fit.ending = SolverEnding::stalled;
  return fit;
}

void fit_null(ExplanationSearch& search, const VectorXd& start) {
  Fitter& fitter = search.fitter;
  std::vector<LevelFit> nulls = fitter.from_coarse_to_fine(start, search.own);
  std::size_t& level = search.level;
  level = nulls.size() - 1;
  // Coarse equations help where they take away more of what the model leaves than stays. What the equations of
  // motion have no part in (a harmonic of the excitation that the model leaves out) is missed at every level alike.
  const bool in_equations =
      nulls.front().fit.chi_squared < (1 - diagnose_thresholds().least_closing) * nulls.back().fit.chi_squared;
  if (nulls[level].misses() && in_equations) {
    while (level > 0 && nulls[level].misses()) --level;
    Refit& fit = nulls[level].fit;
    if (nulls[level].misses()) {
      fit = anchored_null(search, start);
    } else {
      search.freeze_at_level(fit.unknowns);
      fit = fitter.fit_own(fit.unknowns, search.own);
    }
  }
  search.result.null.fit = std::move(nulls[level].fit);
  search.result.degrees_of_freedom = search.freedom_about_null();
  search.null_holds =
      level == finest_level && !fitter.admits_own() && !search.leaves_more_than_noise(search.result.null);
}

void settle_null(ExplanationSearch& search, const Explanation& best) {
  Fitter& fitter = search.fitter;
  search.own = search.all_own;
  search.level = finest_level;
  const VectorXd without = switched_off(best.fit.unknowns, best.members, search.candidates);
  fitter.freeze(best.fit.unknowns);
  Refit& null = search.result.null.fit;
  const bool is_itself = best.members.empty();
  null = fitter.fit_own(null.unknowns, search.own);
  if (!is_itself) {
    Refit from_best = fitter.fit_own(without, search.own);
    if (from_best.chi_squared < null.chi_squared) null = std::move(from_best);
  }
  search.result.degrees_of_freedom = search.freedom_about_null();
}

}  // namespace secular
