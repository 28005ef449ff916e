#pragma once

#include "jobs/predict/prediction.hpp"

namespace secular {

/// Sets Prediction::uncertain and ::directions from the covariance of `given`, or ::no_spread_because. Numbers of
/// the request and varied parameters are exact. `moved`: whether a rest position has given some of the numbers.
void find_uncertainty(const PredictionRequest& request, const GivenParameters& given, bool moved,
                      Prediction& prediction);

/// Sets ResponsePoint::spread, ResponsePeak::place_sd and ResponseSpecial::sd of the diagram, outside of the
/// expansion's range nothing.
void spread_diagram(const ResponseField& field, const ResponseRequest& response, unsigned threads,
                    Prediction& prediction);

/// Sets Prediction::backbone_spread and ::limit_cycle_spread.
void spread_backbones(const ResponseField& field, Prediction& prediction);

}  // namespace secular
