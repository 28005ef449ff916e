#pragma once

#include <string>

#include "diagnose/evidence/steadiness.hpp"
#include "diagnose/inference/residual_structure.hpp"
#include "diagnose/verdict/naming.hpp"
#include "diagnose/verdict/rivals.hpp"

namespace secular {

/// What a diagnosis ends with.
struct Conclusion {
  std::string verdict;          ///< "no_gap", "cause", "set", "approximate" or "unknown"
  std::string cause;            ///< of verdict "cause": the leading effect
  std::string unknown_because;  ///< of verdict "unknown"
};

/// Where the mean motions agree with the model; what varies within dwells may not.
Conclusion conclude_without_gap(bool noise_misjudged, const Unsteadiness& unsteady);

/// What speaks against the best explanation, whatever it closes; empty: nothing. `closing`: of it.
std::string what_speaks_against(const Contest& contest, bool noise_misjudged, const Unsteadiness& unsteady,
                                const ClosedShare& closing);

/// Of a gap whose best explanation is in the catalogue and names this, unless something speaks against it.
/// `structure`: what it leaves.
Conclusion conclude(const Naming& naming, const ResidualStructure& structure, const ClosedShare& closing,
                    const std::string& against);

}  // namespace secular
