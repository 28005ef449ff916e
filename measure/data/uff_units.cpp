#include "measure/data/uff_units.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "measure/data/unit.hpp"

namespace secular {
namespace {

// Specific data types of the format.
enum DataType {
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

struct Spelling {
  std::string_view found, meant;
};

/// How measuring programs spell units that this one spells in one way.
constexpr Spelling spellings[] = {{"G", "g"},
                                  {"g's", "g"},
                                  {"M/S^2", "m/s^2"},
                                  {"M/S2", "m/s^2"},
                                  {"m/s**2", "m/s^2"},
                                  {"m/sec^2", "m/s^2"},
                                  {"m/sec2", "m/s^2"},
                                  {"M/S", "m/s"},
                                  {"m/sec", "m/s"},
                                  {"mm/sec", "mm/s"},
                                  {"M", "m"},
                                  {"Volt", "V"},
                                  {"Volts", "V"},
                                  {"volt", "V"},
                                  {"volts", "V"},
                                  {"Newton", "N"},
                                  {"newton", "N"},
                                  {"NEWTON", "N"},
                                  {"Deg", "deg"},
                                  {"DEG", "deg"},
                                  {"RAD", "rad"},
                                  {"Rad", "rad"},
                                  {"MM", "mm"},
                                  {"uE", "ustrain"},
                                  {"uStrain", "ustrain"},
                                  {"µE", "ustrain"},
                                  {"µstrain", "ustrain"},
                                  {"lb", "lbf"},
                                  {"mm/s2", "mm/s^2"},
                                  {"mm/s²", "mm/s^2"},
                                  {"in/s2", "in/s^2"},
                                  {"μm", "µm"}};

std::string without_brackets(const std::string& unit) {
  const bool bracketed = unit.size() > 2 && ((unit.front() == '(' && unit.back() == ')') ||
                                             (unit.front() == '[' && unit.back() == ']'));
  return bracketed && unit.find_first_of("([", 1) == std::string::npos ? unit.substr(1, unit.size() - 2) : unit;
}

std::string usual_spelling(const std::string& unit) {
  const std::string bare = without_brackets(unit);
  const auto known =
      std::find_if(std::begin(spellings), std::end(spellings), [&](const Spelling& s) { return s.found == bare; });
  return known == std::end(spellings) ? bare : std::string(known->meant);
}

// Units that measure anything without a data type beside them.
bool is_bare_ratio(const std::string& unit) {
  return unit == "1" || unit == "%";
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
  const std::string unit = without_brackets(axis.unit);
  for (const std::string_view second : {"", "s", "S", "sec", "Sec", "SEC", "second", "seconds", "Seconds"})
    if (unit == second) return 1;
  if (unit == "ms" || unit == "msec") return 1e-3;
  if (unit == "us" || unit == "usec" || unit == "µs" || unit == "μs") return 1e-6;
  if (unit == "min") return 60;
  if (unit == "h") return 3600;
  return std::nullopt;
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
