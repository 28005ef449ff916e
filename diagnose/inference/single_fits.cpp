#include "diagnose/inference/single_fits.hpp"

#include <algorithm>
#include <numeric>

#include "diagnose/thresholds.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

/// Nonlinear fits: at most so many candidates, and only those whose gain is this share of the best.
constexpr std::size_t most_fits = 16;
constexpr auto& least_gain_share = diagnose_thresholds().least_share;

}  // namespace

std::vector<std::size_t> promising(const std::vector<Screening>& screened, std::size_t most, double least) {
  std::vector<std::size_t> order(screened.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return screened[a].gain > screened[b].gain; });
  const double best = order.empty() ? 0 : screened[order.front()].gain;
  std::vector<std::size_t> kept;
  for (const std::size_t c : order)
    if (kept.size() < most && screened[c].gain > std::max(least, least_gain_share * best)) kept.push_back(c);
  return kept;
}

// Two standard deviations.
double least_gain_worth_a_fit(const ExplanationSearch& search) {
  return search.fitter.at_true_errors() ? diagnose_thresholds().least_gain : 0;
}

void fit_singles(ExplanationSearch& search) {
  search.singles = search.fitter.screen(search.result.null.fit, search.candidates);
  search.take_gains(search.singles);
  const std::vector<std::size_t> chosen = promising(search.singles, most_fits, least_gain_worth_a_fit(search));
  search.found.resize(chosen.size());
  search.expected = search.fitted + chosen.size();
  in_parallel(chosen.size(), search.options.threads, [&](std::size_t i) {
    search.found[i] = search.explain({chosen[i]}, search.singles[chosen[i]].start);
  });
  keep_best_of_each(search.found, search.candidates);
}

}  // namespace secular
