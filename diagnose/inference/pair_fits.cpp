#include "diagnose/inference/pair_fits.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "diagnose/inference/single_fits.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// Partners of each of the best single explanations, and how often members are exchanged.
constexpr std::size_t most_partners = 6;
constexpr int most_exchanges = 3;

// Pairs that are being looked for, and what was tried already.
class Pairs {
 public:
  explicit Pairs(ExplanationSearch& search) : search_(search) {}

  // Beside another effect, open laws are none.
  static std::vector<Screening> partners_of(ExplanationSearch& search, const Refit& base) {
    std::vector<Screening> found = search.fitter.screen(base, search.candidates);
    for (std::size_t c = 0; c < search.candidates.size(); ++c)
      if (search.candidates[c].open_law) found[c].gain = 0;
    return found;
  }

  bool is_expanded(std::size_t member) const { return expanded_.count(member) > 0; }

  // Partners of one single explanation; `seconds`: how candidates screen beside it.
  void expand(const Explanation& single, std::vector<Screening> seconds) {
    const std::vector<Candidate>& candidates = search_.candidates;
    const std::size_t first = single.members.front();
    expanded_.insert(first);
    // One effect at one place in two shapes is still that effect.
    for (std::size_t c = 0; c < candidates.size(); ++c)
      if (candidates[c].effect == candidates[first].effect && candidates[c].subject == candidates[first].subject)
        seconds[c].gain = 0;
    std::vector<std::size_t> partners;
    for (const std::size_t second : promising(seconds, most_partners, least_gain_worth_a_fit(search_)))
      if (tried_.insert(std::minmax(first, second)).second) partners.push_back(second);
    std::vector<Explanation> fresh(partners.size());
    in_parallel(partners.size(), search_.options.threads, [&](std::size_t i) {
      VectorXd begin = single.fit.unknowns;
      take_over(begin, seconds[partners[i]].start, candidates[partners[i]]);
      fresh[i] = search_.explain({first, partners[i]}, begin);
    });
    for (Explanation& e : fresh) found_.push_back(std::move(e));
  }

  // The two that act together need not be the best alone: partners of both members of the best pair, until it
  // stays.
  void exchange_members() {
    for (int round = 0; round < most_exchanges; ++round) {
      keep_best_of_each(found_, search_.candidates);
      if (found_.empty()) return;
      const std::vector<std::size_t> best = found_.front().members;
      bool moved = false;
      for (const std::size_t member : best) {
        if (is_expanded(member)) continue;
        moved = true;
        const VectorXd& start = search_.singles[member].start;
        const Explanation single =
            search_.explain({member}, start.size() > 0 ? start : search_.result.null.fit.unknowns);
        expand(single, partners_of(search_, single.fit));
      }
      if (!moved) break;
    }
  }

  std::vector<Explanation> best_of_each() && {
    keep_best_of_each(found_, search_.candidates);
    return std::move(found_);
  }

 private:
  ExplanationSearch& search_;
  std::vector<Explanation> found_;
  std::set<std::pair<std::size_t, std::size_t>> tried_;
  std::set<std::size_t> expanded_;
};

// Members of the best pairs alone, from the pair's numbers: on its own way from the null one may have stopped
// short.
void try_members_alone(ExplanationSearch& search, const std::vector<Explanation>& pairs) {
  std::set<std::size_t> again;
  for (std::size_t d = 0; d < std::min(most_firsts, pairs.size()); ++d)
    for (std::size_t m = 0; m < 2; ++m) {
      const std::size_t member = pairs[d].members[m], other = pairs[d].members[1 - m];
      if (!again.insert(member).second) continue;
      search.found.push_back(
          search.explain({member}, switched_off(pairs[d].fit.unknowns, {other}, search.candidates)));
    }
}

}  // namespace

void add_pairs(ExplanationSearch& search) {
  std::vector<Explanation> alone;
  for (const Explanation& e : search.found)
    if (e.members.size() == 1 && !has_open_law(e, search.candidates)) alone.push_back(e);
  if (alone.empty()) return;
  const Explanation& best = alone.front();
  std::vector<Screening> beside_best = Pairs::partners_of(search, best.fit);
  beside_best[best.members.front()].gain = 0;
  const auto most = std::max_element(beside_best.begin(), beside_best.end(),
                                     [](const Screening& a, const Screening& b) { return a.gain < b.gain; });
  const double worth =
      2 * (search.price - std::log(search.options.prior_second)) * std::max(1.0, search.dispersion_of(best));
  if (search.fitter.at_true_errors() && !search.leaves_more_than_noise(best) && !(most->gain > worth)) return;
  search.expected = search.fitted + most_firsts * most_partners;
  Pairs pairs(search);
  pairs.expand(best, std::move(beside_best));
  for (std::size_t f = 1; f < std::min(most_firsts, alone.size()); ++f)
    if (!pairs.is_expanded(alone[f].members.front()))
      pairs.expand(alone[f], Pairs::partners_of(search, alone[f].fit));
  pairs.exchange_members();
  std::vector<Explanation> fresh = std::move(pairs).best_of_each();
  try_members_alone(search, fresh);
  for (Explanation& e : fresh) search.found.push_back(std::move(e));
  keep_best_of_each(search.found, search.candidates);
}

}  // namespace secular
