#include "diagnose/verdict/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/ties.hpp"

namespace secular {
namespace {

/// Others stay in the set down to this share of the best one's probability.
constexpr auto& credible_odds = diagnose_thresholds().told_apart;

// Among explanations: few unknowns, then early in the catalogue.
std::pair<std::size_t, std::vector<std::size_t>> place_of(const Rival& rival) {
  std::vector<std::size_t> members = rival.explanation->members;
  std::sort(members.begin(), members.end());
  return {rival.explanation->unknowns, std::move(members)};
}

Rival rival_of(const Explanation& explanation, const std::vector<Candidate>& candidates) {
  Rival rival{&explanation, explanation.log_evidence, 0, {}, false};
  for (const std::size_t m : explanation.members) {
    const Candidate& c = candidates[m];
    rival.effects.push_back(c.effect);
    rival.open_law = rival.open_law || c.open_law;
    rival.contains.insert(rival.contains.end(), c.contains.begin(), c.contains.end());
  }
  return rival;
}

}  // namespace

std::vector<std::string> only_in(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<std::string> only;
  for (const std::string& name : a)
    if (std::find(b.begin(), b.end(), name) == b.end()) only.push_back(name);
  return only;
}

void rank(std::vector<Rival>& rivals) {
  std::stable_sort(rivals.begin(), rivals.end(),
                   [](const Rival& a, const Rival& b) { return a.log_evidence > b.log_evidence; });
  order_ties(
      rivals, same_evidence, [](const Rival& r) { return r.log_evidence; },
      [](const Rival& a, const Rival& b) { return place_of(a) < place_of(b); });
  double sum = 0;
  for (const Rival& r : rivals) sum += std::exp(r.log_evidence - rivals.front().log_evidence);
  for (Rival& r : rivals) r.probability = std::exp(r.log_evidence - rivals.front().log_evidence) / sum;
}

bool is_credible(const Rival& rival, const Rival& best) {
  return rival.probability > credible_odds * best.probability;
}

bool is_credible(double log_evidence, double of_best) {
  return std::exp(log_evidence - of_best) > credible_odds;
}

Contest contest_of(const Inference& inference, const std::vector<Candidate>& candidates, bool with_null) {
  Contest contest;
  if (with_null) contest.all.push_back({&inference.null, inference.null.log_evidence, 0, {"parameters"}, false});
  for (const Explanation& e : inference.explanations) contest.all.push_back(rival_of(e, candidates));
  if (contest.all.empty()) return contest;
  rank(contest.all);
  // A stalled fit names nothing; and one that is likelier than all that have converged lets none of these be named.
  const auto has_converged = [](const Rival& r) { return r.explanation->fit.ending == SolverEnding::converged; };
  const auto first = std::find_if(contest.all.begin(), contest.all.end(), has_converged);
  contest.stalled = first == contest.all.end() || !is_credible(*first, contest.all.front());
  if (!contest.stalled) {
    std::erase_if(contest.all, [&](const Rival& r) { return !has_converged(r); });
    rank(contest.all);
  }
  std::copy_if(contest.all.begin(), contest.all.end(), std::back_inserter(contest.named),
               [](const Rival& r) { return !r.open_law; });
  return contest;
}

const Rival& Contest::best() const {
  const Rival& first = all.front();
  const bool catalogue_will_do = first.open_law && !named.empty() && is_credible(named.front(), first) &&
                                 named.front().effects.size() <= first.effects.size();
  return catalogue_will_do ? named.front() : first;
}

}  // namespace secular
