#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/inference/inference.hpp"

namespace secular {

/// An explanation that competes with others for the name of the cause.
struct Rival {
  const Explanation* explanation = nullptr;
  double log_evidence = 0, probability = 0;
  std::vector<std::string> effects;        ///< of its members, in their order
  bool open_law = false;                   ///< holds a law outside of the catalogue
  std::vector<std::string> contains = {};  ///< simpler effects that one of its members has as limits
};

/// Those of `a` that are not in `b`.
std::vector<std::string> only_in(const std::vector<std::string>& a, const std::vector<std::string>& b);

/// Gives rivals their probabilities and puts the likeliest first (of those that are the same but for what fits are
/// good to, the one that comes first in the catalogue).
void rank(std::vector<Rival>& rivals);

/// Whether `rival` keeps a share of the best one's probability that nobody should overlook.
bool is_credible(const Rival& rival, const Rival& best);

/// What the best rival names, and what the data cannot tell from it.
struct Naming {
  std::vector<std::string> set;        ///< the leading effect, then those that could stand in its place
  std::vector<std::string> together;   ///< two effects that act at once, the leading one first
  std::vector<std::string> second_or;  ///< effects that could stand in the place of the second of them

  /// Whether it is in the set, or one of two that act at once.
  bool names(const std::string& effect) const;
};

/// `rivals`: ranked, none of them an open law; throws std::invalid_argument where there are none.
Naming name_effects(const std::vector<Rival>& rivals, const Inference& inference);

/// Whether conditions that were held out repeat it that an explanation leaves less than `limit`.
using StepIsShown = std::function<bool(const Explanation& limit, const Explanation& explanation)>;

/// Adds the limits of the effects that are named, where a rival has them in their place and nothing shows that the
/// law itself is needed (docs/inference.md (31)): however much likelier it is, it names no more than its limit
/// then.
void keep_limits(Naming& naming, const std::vector<Rival>& rivals, const EffectCatalogue& catalogue,
                 const StepIsShown& is_shown);

}  // namespace secular
