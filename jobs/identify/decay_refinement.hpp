#pragma once

#include <string>
#include <vector>

#include "estimator/identification/estimate.hpp"

namespace secular {

struct Identification;
struct IdentificationRequest;

/// What the full equations of motion, fitted to free decays in one piece each, make of the numbers that the
/// modulation equations give (docs/inference.md (65) to (69)).
struct DecayRefinement {
  std::string why_not;  ///< the numbers of the modulation equations stand; empty: those of the full equations do
  /// Parameters as the modulation equations and as the full ones have them; of the latter none where there was no
  /// fit.
  std::vector<EstimatedValue> by_modulation, by_full_equations;

  bool is_taken() const { return why_not.empty(); }
};

/// Fits the full equations from the estimate in `id` on and notes in `id.refinement` what came of it. Where the fit
/// holds, the parameters become its own; where it contradicts them, they are allowed what they differ by, and a
/// warning says so.
void refine_decays(const IdentificationRequest& request, Identification& id);

/// One sentence part: "by the full equations of motion, ...", or why not.
std::string text_of(const DecayRefinement& refinement);

}  // namespace secular
