#include "diagnose/inference/fits_afresh.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "diagnose/inference/pair_fits.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// Where every explanation misses, so many effects are fitted again from the start.
constexpr std::size_t most_afresh = 8;

/// Of the first single effects, so many are.
constexpr std::size_t most_first_afresh = 2;

// One effect on its own way from the start, its strength and shape as in `like`; nothing where it leaves more
// than `most` on the way.
std::optional<Explanation> afresh(ExplanationSearch& search, std::size_t member, const VectorXd& start,
                                  const VectorXd& like, double most) {
  VectorXd begin = start;
  take_over(begin, like, search.candidates[member]);
  std::vector<LevelFit> fits = search.fitter.from_coarse_to_fine(begin, search.free_of({member}), most);
  if (fits.size() < std::size(coarse_levels)) return std::nullopt;
  return explanation_by({member}, std::move(fits.back().fit), search.candidates);
}

// All that were found beside the model's numbers as this one has them, which stands in place of its like.
void judge_beside(ExplanationSearch& search, Explanation best, std::size_t place) {
  const std::vector<Candidate>& candidates = search.candidates;
  const VectorXd without = switched_off(best.fit.unknowns, best.members, candidates);
  for (Explanation& e : search.found) {
    VectorXd begin = without;
    take_over(begin, e.fit.unknowns, candidates[e.members.front()]);
    e.fit.unknowns = std::move(begin);
    e.fit.free = search.free_of(e.members);
  }
  search.found[place] = std::move(best);
  search.refit_found();
}

}  // namespace

bool begin_afresh(ExplanationSearch& search, const VectorXd& start) {
  std::vector<Explanation>& found = search.found;
  if (found.empty() || !search.leaves_more_than_noise(found.front())) return false;
  Fitter& fitter = search.fitter;
  const Fitter::Place here = fitter.place();
  const std::vector<std::size_t> own = std::exchange(search.own, search.all_own);
  for (std::size_t f = 0; f < std::min(most_first_afresh, found.size()); ++f) {
    if (has_open_law(found[f], search.candidates)) continue;
    std::optional<Explanation> again = afresh(search, found[f].members.front(), start, found[f].fit.unknowns,
                                              most_of_noise(search.result.degrees_of_freedom));
    if (!again || search.leaves_more_than_noise(*again) || !is_possible(*again, search.candidates)) continue;
    fitter.freeze(again->fit.unknowns);
    const double left = fitter.left_by(found.front().fit.unknowns);
    if (left <= fitter.left_by(again->fit.unknowns)) continue;  // it has run away with its own errors
    search.level = finest_level;
    judge_beside(search, std::move(*again), f);
    return true;
  }
  fitter.return_to(here);
  search.own = own;
  return false;
}

bool start_afresh(ExplanationSearch& search, const VectorXd& start) {
  std::vector<Explanation>& found = search.found;
  if (found.empty() || !search.leaves_more_than_noise(found.front())) return false;
  const std::size_t most = search.misses(found.front().fit) ? most_afresh : most_firsts;
  double most_left = found.front().fit.chi_squared;
  std::set<std::pair<std::string, std::string>> taken;
  std::vector<Explanation> fresh;
  for (const Explanation& e : found)
    for (const std::size_t m : e.members) {
      const Candidate& c = search.candidates[m];
      if (taken.size() == most || !taken.emplace(c.effect, c.subject).second) continue;
      std::optional<Explanation> again = afresh(search, m, start, e.fit.unknowns, most_left);
      if (!again) continue;
      most_left = std::min(most_left, again->fit.chi_squared);
      fresh.push_back(std::move(*again));
    }
  // Every one among its own errors; the better one must be better among those of its own as well.
  Fitter& fitter = search.fitter;
  const Explanation* best = &found.front();
  fitter.freeze(best->fit.unknowns);
  double least = fitter.left_by(best->fit.unknowns);
  for (const Explanation& e : fresh) {
    fitter.freeze(e.fit.unknowns);
    const double left = fitter.left_by(e.fit.unknowns);
    if (!(left < least) || !(left < fitter.left_by(best->fit.unknowns)) || !is_possible(e, search.candidates))
      continue;
    best = &e;
    least = left;
  }
  fitter.freeze(best->fit.unknowns);
  if (best == &found.front()) return false;
  found.insert(found.end(), std::make_move_iterator(fresh.begin()), std::make_move_iterator(fresh.end()));
  search.refit_found();
  return true;
}

}  // namespace secular
