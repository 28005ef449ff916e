#pragma once

#include <string>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// One of several terms that might do the same, alone in the model.
struct CompetingTerm {
  std::string name;
  double normalised_residual = 0;  ///< of the modulation equations over what measured noise explains; 1 is perfect
};

/// Fits the case's equations (estimate()) once for every name with the other names zero, as the source does with
/// quadratic and cubic damping (section 5.5): the same data, equally many unknowns. Best first. Throws InputError
/// for a name that is no symbol, std::invalid_argument for fewer than two names.
std::vector<CompetingTerm> compare_terms(const ObservationSet& set, const std::string& coordinate_unit,
                                         const std::vector<std::string>& excitation_units,
                                         const std::vector<std::string>& names);

}  // namespace secular
