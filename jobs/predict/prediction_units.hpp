#pragma once

#include "jobs/predict/prediction.hpp"

namespace secular {

/// Fills units and coordinate_unit: those of an estimate; what it does not say, from the channels of the measured
/// campaign.
void find_units(const PredictionRequest& request, const GivenParameters& given, Prediction& prediction);

}  // namespace secular
