#pragma once

#include <optional>
#include <string>

#include "measure/data/campaign.hpp"

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

}  // namespace secular
