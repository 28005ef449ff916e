#pragma once

#include <span>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// The unit of a symbol from its powers of the coordinates' units, the excitations' units and the second, written
/// with base units: "1/s", "s/(kg m^2)"; "1" where all cancel; empty where `dimension` is empty.
std::string unit_text(std::span<const Ratio> dimension, const std::vector<std::string>& coordinate_units,
                      const std::vector<std::string>& excitation_units);

}  // namespace secular
