#include "diagnose/verdict/naming.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/next_experiment.hpp"
#include "diagnose/verdict/ties.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

/// Explanations that are expected to differ by less than this in chi-squared cannot be told apart.
constexpr auto& separable = diagnose_thresholds().separable;

/// Others stay in the set down to this share of the best one's probability.
constexpr auto& credible_odds = diagnose_thresholds().told_apart;

using Names = std::vector<std::string>;

bool holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Among explanations: few unknowns, then early in the catalogue.
std::pair<std::size_t, std::vector<std::size_t>> place_of(const Rival& rival) {
  std::vector<std::size_t> members = rival.explanation->members;
  std::sort(members.begin(), members.end());
  return {rival.explanation->unknowns, std::move(members)};
}

// Of two effects together the one that alone explains more.
std::string leading_effect(const Rival& best, const Inference& inference) {
  if (best.effects.size() == 1) return best.effects.front();
  const std::vector<std::size_t>& members = best.explanation->members;
  return best.effects[inference.linear_gain[members[0]] >= inference.linear_gain[members[1]] ? 0 : 1];
}

// What has more unknowns and still explains no better contains the best as a limit (a slider that slips at once is
// dry friction): the simpler one is named.
bool is_the_same(const Rival& rival, const Rival& best, const Explanation& null) {
  return rival.explanation->unknowns <= best.explanation->unknowns &&
         expected_separation(*best.explanation, *rival.explanation, null) < separable;
}

// A law that has an effect of the best rival as a limit and is better by no more than its further unknowns bring by
// chance: the simpler one is named.
bool is_its_limit(const Rival& rival, const Rival& best, double dispersion) {
  const Names instead = only_in(best.effects, rival.effects);
  if (instead.size() != 1 || !holds(rival.contains, instead.front())) return false;
  const auto more =
      static_cast<double>(rival.explanation->unknowns) - static_cast<double>(best.explanation->unknowns);
  const double gain = (best.explanation->fit.chi_squared - rival.explanation->fit.chi_squared) / dispersion;
  return more > 0 && chi_squared_upper_tail(std::max(0.0, gain), more) > diagnose_thresholds().told_apart;
}

}  // namespace

std::vector<std::string> only_in(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  Names only;
  for (const std::string& name : a)
    if (!holds(b, name)) only.push_back(name);
  return only;
}

bool Naming::names(const std::string& effect) const {
  return holds(set, effect) || holds(together, effect);
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

Naming name_effects(const std::vector<Rival>& rivals, const Inference& inference) {
  if (rivals.empty()) throw std::invalid_argument("name_effects: no rivals");
  const Rival& best = rivals.front();
  const std::string leading = leading_effect(best, inference);
  Naming naming;
  naming.set = {leading};
  const auto add = [&](const std::string& effect) {
    if (!holds(naming.set, effect)) naming.set.push_back(effect);
  };
  // Where moved parameters are enough, every effect that is tried beside them is one too many.
  const bool own_parameters = best.explanation->members.empty();
  // Rivals of the same number of effects: what would have to stand in the first one's place.
  for (const Rival& r : rivals) {
    if (own_parameters || r.effects.size() != best.effects.size()) continue;
    const Names instead = only_in(r.effects, best.effects);
    if (instead.size() != 1 || !holds(only_in(best.effects, r.effects), leading)) continue;
    if (is_its_limit(r, best, inference.dispersion)) continue;
    if (is_credible(r, best) || is_the_same(r, best, inference.null)) add(instead.front());
  }
  for (const Rival& r : rivals)
    if (r.effects.size() < best.effects.size() && is_credible(r, best))
      for (const std::string& effect : r.effects) add(effect);
  if (best.effects.size() < 2) return naming;
  const std::string second = best.effects[best.effects.front() == leading ? 1 : 0];
  naming.together = {leading, second};
  for (const Rival& r : rivals) {
    if (r.effects.size() != 2 || !is_credible(r, best) || is_its_limit(r, best, inference.dispersion)) continue;
    const Names instead = only_in(r.effects, naming.together);
    if (instead.size() == 1 && only_in(naming.together, r.effects) == Names{second})
      naming.second_or.push_back(instead.front());
  }
  return naming;
}

void keep_limits(Naming& naming, const std::vector<Rival>& rivals, const EffectCatalogue& catalogue,
                 const StepIsShown& is_shown) {
  const Rival& best = rivals.front();
  for (const Rival& rival : rivals) {
    const Names limit = only_in(rival.effects, best.effects), of = only_in(best.effects, rival.effects);
    if (rival.effects.size() != best.effects.size() || limit.size() != 1 || of.size() != 1) continue;
    const Effect* effect = catalogue.find(of.front());
    Names& names = of.front() == naming.set.front() ? naming.set : naming.second_or;
    if (!effect || !holds(effect->contains, limit.front()) || holds(names, limit.front())) continue;
    if (!is_shown(*rival.explanation, *best.explanation)) names.push_back(limit.front());
  }
}

}  // namespace secular
