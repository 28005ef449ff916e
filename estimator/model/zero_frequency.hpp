#pragma once

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// True for the component at zero frequency, which has no imaginary part and shares it with the sensor's offset.
bool is_zero_frequency(const RegressorBlock& block);

}  // namespace secular
