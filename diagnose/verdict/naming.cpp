#include "diagnose/verdict/naming.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

/// Explanations that are expected to differ by less than this in chi-squared cannot be told apart.
constexpr auto& separable = diagnose_thresholds().separable;

/// Predicting what was held out takes longer than all else that is said of a rival.
constexpr int most_neighbours = 6;

using Names = std::vector<std::string>;

bool holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Of two effects together the one that alone explains more.
std::string leading_effect(const Rival& best, const Inference& inference) {
  if (best.effects.size() == 1) return best.effects.front();
  const std::vector<std::size_t>& members = best.explanation->members;
  const auto alone = [&](std::size_t member) {
    return std::find_if(inference.explanations.begin(), inference.explanations.end(),
                        [&](const Explanation& e) { return e.members.size() == 1 && e.members.front() == member; });
  };
  const auto first = alone(members[0]), second = alone(members[1]), none = inference.explanations.end();
  // One that was not fitted alone at last: to first order.
  const bool first_leads = first != none && second != none
                               ? first->fit.chi_squared <= second->fit.chi_squared
                               : inference.linear_gain[members[0]] >= inference.linear_gain[members[1]];
  return best.effects[first_leads ? 0 : 1];
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

// What a rival has in the place of one of the best one's effects, all others being the same.
struct Exchange {
  std::string instead, of;
};
std::optional<Exchange> exchange(const Rival& rival, const Rival& best) {
  const Names instead = only_in(rival.effects, best.effects), of = only_in(best.effects, rival.effects);
  if (rival.effects.size() != best.effects.size() || instead.size() != 1 || of.size() != 1) return std::nullopt;
  return Exchange{instead.front(), of.front()};
}

// Where an effect stands that could be in the place of `of`.
Names& list_beside(const std::string& of, Naming& naming) {
  return of == naming.set.front() ? naming.set : naming.second_or;
}

}  // namespace

bool Naming::names(const std::string& effect) const {
  return holds(set, effect) || holds(together, effect);
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
    const std::optional<Exchange> limit = exchange(rival, best);
    if (!limit) continue;
    const Effect* effect = catalogue.find(limit->of);
    Names& names = list_beside(limit->of, naming);
    if (!effect || !holds(effect->contains, limit->instead) || holds(names, limit->instead)) continue;
    if (!is_shown(*rival.explanation, *best.explanation)) names.push_back(limit->instead);
  }
}

void add_neighbours(Naming& naming, const std::vector<Rival>& rivals, const ClosedShare& closing,
                    const LeftBy& left_by) {
  const Rival& best = rivals.front();
  int tried = 0;
  for (const Rival& rival : rivals) {
    const std::optional<Exchange> neighbour = exchange(rival, best);
    if (!neighbour) continue;
    Names& names = list_beside(neighbour->of, naming);
    if (holds(names, neighbour->instead) || holds(rival.contains, neighbour->of)) continue;
    const Names shared = only_in(best.effects, {neighbour->of});
    const auto beside =
        std::find_if(rivals.begin(), rivals.end(), [&](const Rival& r) { return r.effects == shared; });
    if (!shared.empty() && beside == rivals.end()) continue;
    if (tried++ == most_neighbours) return;
    const double without = shared.empty() ? closing.before : left_by(*beside->explanation);
    if (without - left_by(*rival.explanation) >= diagnose_thresholds().most_of_the_gap * (without - closing.after))
      names.push_back(neighbour->instead);
  }
}

}  // namespace secular
