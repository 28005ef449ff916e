#pragma once

#include <Eigen/Core>
#include <string>

#include "jobs/predict/prediction.hpp"

namespace secular {

/// What a request says of its prediction: names of the parameters, what is varied and how it is printed, all
/// numbers. The model and its case are there already. Throws InputError.
void read_prediction_inputs(const PredictionRequest& request, Prediction& prediction);

/// Place of a parameter among Prediction::names. Throws InputError that lists them.
Eigen::Index index_of(const Prediction& prediction, const std::string& name);

}  // namespace secular
