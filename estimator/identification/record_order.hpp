#pragma once

#include <vector>

#include "estimator/identification/scatter_between_records.hpp"

namespace secular {

/// Of a dwell: at which level and excitation frequency and when it was made, in any units.
struct DwellPlace {
  double level = 0, frequency = 0, time = 0;
};

/// docs/inference.md (58): the smaller one of two probabilities, that shifts at random are as much alike as those
/// seen in dwells that follow one another in time, and in frequency at one level. `places`: by record of `scatter`.
double order_p_value(const ScatterBetweenRecords& scatter, const std::vector<DwellPlace>& places);

}  // namespace secular
