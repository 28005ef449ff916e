#pragma once

#include <optional>
#include <string>

#include "measure/formats/quantity.hpp"
#include "measure/formats/uff_function.hpp"

namespace secular {

/// What an axis of a universal file measures and the factor that takes its values to the SI unit.
struct UffMeaning {
  Quantity quantity = Quantity::acceleration;
  double si_factor = 1;
};

/// By the specific data type and the unit label; `rotation` where the point turns instead of moving. Nothing where
/// the file does not say both, or says two things: a unit that is not known, force in m/s^2.
std::optional<UffMeaning> ordinate_meaning(const UffAxis& axis, bool rotation);

/// Seconds in the unit of a time axis (no unit: seconds). Nothing for an axis that is not of time, or a unit that
/// is not known.
std::optional<double> seconds_in_unit(const UffAxis& axis);

/// "frequency response function": what a function type other than time response is.
std::string function_type_name(int type);

}  // namespace secular
