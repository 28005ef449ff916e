#pragma once

#include <vector>

#include "diagnose/inference/explanation.hpp"

namespace secular {

/// What evidence is taken at.
struct Weights {
  double dispersion = 1;  ///< variance of the rows
  double price = 0;       ///< of one unknown more, in log evidence
  double prior_second = 1, prior_open_law = 1;
};

/// Schwarz's approximation, with the prior odds of a second effect and of an open law.
double log_evidence(const Explanation& explanation, const std::vector<Candidate>& candidates,
                    const Weights& weights);

/// Of all, which are put in order, likeliest first.
void weigh(Explanation& null, std::vector<Explanation>& found, const std::vector<Candidate>& candidates,
           const Weights& weights);

}  // namespace secular
