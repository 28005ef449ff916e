#pragma once

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
/// The same of what stands in no list of rivals, by log evidence.
bool is_credible(double log_evidence, double of_best);

/// The explanations of a gap, likeliest first.
struct Contest {
  std::vector<Rival> all;    ///< but those whose fit stalled, where one that converged is credible beside them
  std::vector<Rival> named;  ///< of these, the ones that the catalogue holds
  bool stalled = false;      ///< the likeliest is no minimum, and no other comes near it: it names nothing

  /// An exponent of its own that is credibly no better than a law of the catalogue stands for that law; not for two
  /// that only do together what it does alone. There has to be one in `all`.
  const Rival& best() const;
};

/// `candidates`: those that members of explanations are indices into. `with_null`: the model as it is takes part,
/// as the effect "parameters". `inference` has to outlive the contest.
Contest contest_of(const Inference& inference, const std::vector<Candidate>& candidates, bool with_null);

}  // namespace secular
