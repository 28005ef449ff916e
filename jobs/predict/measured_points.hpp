#pragma once

#include <string>
#include <vector>

#include "jobs/predict/prediction.hpp"

namespace secular {

/// The dwells of request.measured as points for the response over prediction.vary, an excitation's frequency or
/// amplitude: one a dwell, mean peak amplitudes over its ensembles, measured excitation; dwells at rest too, at the
/// amplitude of their noise. Dwells whose other
/// excitation quantities are not those of the prediction (amplitudes within 5 %, frequencies within 0.05 %) are
/// left out; how many, and what the observation of the dwells said, goes to `warnings`. Throws InputError where no
/// dwell is left.
std::vector<MeasuredPoint> measured_points(const PredictionRequest& request, const Prediction& prediction,
                                           std::vector<std::string>& warnings);

}  // namespace secular
