#pragma once

#include <functional>
#include <string>

#include "jobs/predict/prediction.hpp"

namespace secular {

/// Dwells of the full equations of motion over the varied parameter, `direction` "up" or "down", each beginning
/// where the last one ended, with the jumps between them. `done` is called after each. Throws InputError where no
/// quantity of the excitation is varied.
PredictedSweep simulated_sweep(const PredictionRequest& request, const Prediction& prediction,
                               const ResponseRequest& response, const std::string& direction,
                               const std::function<void()>& done);

}  // namespace secular
