#include "measure/formats/uff_units.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "measure/formats/unit.hpp"

namespace secular {
namespace {

// Specific data types of the format.
enum SpecificType {
  type_unknown = 0,
  type_general = 1,
  type_strain = 3,
  type_displacement = 8,
  type_reaction_force = 9,
  type_velocity = 11,
  type_acceleration = 12,
  type_excitation_force = 13,
  type_time = 17
};

bool says_nothing(int data_type) {
  return data_type == type_unknown || data_type == type_general;
}

std::optional<Quantity> quantity_of(int data_type, bool rotation) {
  switch (data_type) {
    case type_strain:
      return Quantity::strain;
    case type_displacement:
      return rotation ? Quantity::angle : Quantity::displacement;
    case type_velocity:
      return rotation ? std::nullopt : std::optional(Quantity::velocity);
    case type_acceleration:
      return rotation ? std::nullopt : std::optional(Quantity::acceleration);
    case type_reaction_force:
    case type_excitation_force:
      return rotation ? std::nullopt : std::optional(Quantity::force);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<UffMeaning> ordinate_meaning(const UffAxis& axis, bool rotation) {
  const std::string unit = usual_spelling(axis.unit);
  const std::optional<UnitMeaning> meaning = unit_meaning(unit);
  if (!meaning) return std::nullopt;
  if (says_nothing(axis.data_type)) {
    if (is_bare_ratio(unit)) return std::nullopt;
    return UffMeaning{meaning->quantity, meaning->si_factor};
  }
  std::optional<Quantity> quantity = quantity_of(axis.data_type, rotation);
  // Inclinometers without a direction: displacements in degrees.
  if (axis.data_type == type_displacement && meaning->quantity == Quantity::angle) quantity = Quantity::angle;
  if (quantity != meaning->quantity) return std::nullopt;
  return UffMeaning{meaning->quantity, meaning->si_factor};
}

std::optional<double> seconds_in_unit(const UffAxis& axis) {
  if (axis.data_type != type_time && !says_nothing(axis.data_type)) return std::nullopt;
  return axis.unit.empty() ? 1 : seconds_in(axis.unit);
}

std::string function_type_name(int type) {
  static constexpr std::string_view names[] = {"general function",
                                               "time response",
                                               "auto spectrum",
                                               "cross spectrum",
                                               "frequency response function",
                                               "transmissibility",
                                               "coherence",
                                               "auto correlation",
                                               "cross correlation",
                                               "power spectral density",
                                               "energy spectral density",
                                               "probability density function",
                                               "spectrum",
                                               "cumulative frequency distribution",
                                               "peaks valley",
                                               "stress over cycles",
                                               "strain over cycles",
                                               "orbit",
                                               "mode indicator function",
                                               "force pattern",
                                               "partial power",
                                               "partial coherence",
                                               "eigenvalue",
                                               "eigenvector",
                                               "shock response spectrum",
                                               "finite impulse response filter",
                                               "multiple coherence",
                                               "order function",
                                               "phase compensation"};
  if (type >= 0 && static_cast<std::size_t>(type) < std::size(names))
    return std::string(names[static_cast<std::size_t>(type)]);
  return "function of type " + std::to_string(type);
}

}  // namespace secular
