#pragma once

#include <vector>

#include "jobs/predict/prediction.hpp"

namespace secular {

/// Of every moving mode the largest stable response in the diagram that is not outside of the expansion's range,
/// with its error bars (R9); modes without such a response are left out.
std::vector<LargestResponse> largest_responses(const Prediction& prediction);

}  // namespace secular
