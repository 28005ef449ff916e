#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/formats/quantity.hpp"

namespace secular {

/// What is wrong with a unit for a quantity, or empty. SI only: acceleration m/s^2, velocity m/s, displacement m,
/// force N, voltage V, strain 1 or m/m, angle rad.
std::string unit_fault(Quantity quantity, const std::string& unit);

/// The unit of a quantity: "m/s^2".
std::string si_unit(Quantity quantity);

struct UnitMeaning {
  Quantity quantity = Quantity::acceleration;
  double si_factor = 1;  ///< SI value = si_factor * number
};

/// What a unit measures; nothing for a unit that is not known.
std::optional<UnitMeaning> unit_meaning(const std::string& unit);

/// "m/s^2" for "[m/sec2]" and other ways in which measuring programs spell units; others as they are.
std::string usual_spelling(const std::string& unit);

/// Units that measure anything: 1 and %.
bool is_bare_ratio(const std::string& unit);

/// What a unit measures that no channel measures ("frequency"); else empty.
std::string other_measure(const std::string& unit);

/// Seconds in a unit of time, however it is spelled; nothing for another unit.
std::optional<double> seconds_in(const std::string& unit);

/// Stamps in a unit of so many seconds become seconds.
void scale_to_seconds(std::vector<double>& stamps, double seconds);

}  // namespace secular
