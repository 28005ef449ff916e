#include "measure/data/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <string_view>

namespace secular {
namespace {

struct KnownUnit {
  std::string_view name;
  Quantity quantity;
  std::string_view factor;  ///< SI value = factor * number
};

constexpr KnownUnit known_units[] = {
    {"g", Quantity::acceleration, "9.80665"},
    {"gn", Quantity::acceleration, "9.80665"},
    {"mg", Quantity::acceleration, "9.80665e-3"},
    {"Gal", Quantity::acceleration, "0.01"},
    {"mm/s^2", Quantity::acceleration, "0.001"},
    {"cm/s^2", Quantity::acceleration, "0.01"},
    {"ft/s^2", Quantity::acceleration, "0.3048"},
    {"in/s^2", Quantity::acceleration, "0.0254"},
    {"m/s2", Quantity::acceleration, "1"},
    {"m/s²", Quantity::acceleration, "1"},
    {"m/s/s", Quantity::acceleration, "1"},
    {"m s^-2", Quantity::acceleration, "1"},
    {"mm/s", Quantity::velocity, "0.001"},
    {"cm/s", Quantity::velocity, "0.01"},
    {"km/h", Quantity::velocity, "1/3.6"},
    {"in/s", Quantity::velocity, "0.0254"},
    {"ft/s", Quantity::velocity, "0.3048"},
    {"m s^-1", Quantity::velocity, "1"},
    {"mm", Quantity::displacement, "0.001"},
    {"cm", Quantity::displacement, "0.01"},
    {"um", Quantity::displacement, "1e-6"},
    {"µm", Quantity::displacement, "1e-6"},
    {"nm", Quantity::displacement, "1e-9"},
    {"in", Quantity::displacement, "0.0254"},
    {"mil", Quantity::displacement, "2.54e-5"},
    {"ft", Quantity::displacement, "0.3048"},
    {"kN", Quantity::force, "1000"},
    {"mN", Quantity::force, "0.001"},
    {"lbf", Quantity::force, "4.4482216152605"},
    {"kgf", Quantity::force, "9.80665"},
    {"mV", Quantity::voltage, "0.001"},
    {"uV", Quantity::voltage, "1e-6"},
    {"µV", Quantity::voltage, "1e-6"},
    {"kV", Quantity::voltage, "1000"},
    {"um/m", Quantity::strain, "1e-6"},
    {"µm/m", Quantity::strain, "1e-6"},
    {"ustrain", Quantity::strain, "1e-6"},
    {"microstrain", Quantity::strain, "1e-6"},
    {"mm/m", Quantity::strain, "0.001"},
    {"%", Quantity::strain, "0.01"},
    {"mm/mm", Quantity::strain, "1"},
    {"strain", Quantity::strain, "1"},
    {"deg", Quantity::angle, "pi/180"},
    {"°", Quantity::angle, "pi/180"},
    {"degree", Quantity::angle, "pi/180"},
    {"degrees", Quantity::angle, "pi/180"},
    {"mrad", Quantity::angle, "0.001"},
    {"rev", Quantity::angle, "2*pi"},
};

struct OtherUnit {
  std::string_view name, measures;
};

/// Units of what no channel measures.
constexpr OtherUnit other_units[] = {{"Hz", "frequency"},
                                     {"kHz", "frequency"},
                                     {"rpm", "rotation rate"},
                                     {"rad/s", "rotation rate"},
                                     {"deg/s", "rotation rate"},
                                     {"s", "time"},
                                     {"ms", "time"},
                                     {"kg", "mass"},
                                     {"Pa", "pressure or stress"},
                                     {"MPa", "pressure or stress"},
                                     {"A", "electric current"},
                                     {"Nm", "torque"},
                                     {"N m", "torque"}};

constexpr Quantity all_quantities[] = {Quantity::acceleration, Quantity::velocity, Quantity::displacement,
                                       Quantity::force,        Quantity::voltage,  Quantity::strain,
                                       Quantity::angle};

bool is_si(Quantity quantity, std::string_view unit) {
  return unit == si_unit(quantity) || (quantity == Quantity::strain && unit == "m/m");
}

// A product such as "pi/180" or "1/3.6".
double factor_value(std::string_view factor) {
  double value = 1;
  bool divide = false;
  while (!factor.empty()) {
    const std::size_t end = std::min(factor.find_first_of("*/"), factor.size());
    const std::string term(factor.substr(0, end));
    const double number = term == "pi" ? std::numbers::pi : std::strtod(term.c_str(), nullptr);
    value = divide ? value / number : value * number;
    divide = end < factor.size() && factor[end] == '/';
    factor.remove_prefix(std::min(end + 1, factor.size()));
  }
  return value;
}

}  // namespace

std::optional<UnitMeaning> unit_meaning(const std::string& unit) {
  for (const Quantity quantity : all_quantities)
    if (is_si(quantity, unit)) return UnitMeaning{quantity, 1};
  for (const KnownUnit& known : known_units)
    if (known.name == unit) return UnitMeaning{known.quantity, factor_value(known.factor)};
  return std::nullopt;
}

std::string si_unit(Quantity quantity) {
  switch (quantity) {
    case Quantity::acceleration:
      return "m/s^2";
    case Quantity::velocity:
      return "m/s";
    case Quantity::displacement:
      return "m";
    case Quantity::force:
      return "N";
    case Quantity::voltage:
      return "V";
    case Quantity::strain:
      return "1";
    case Quantity::angle:
      return "rad";
  }
  return {};
}

std::string unit_fault(Quantity quantity, const std::string& unit) {
  if (is_si(quantity, unit)) return {};
  const std::string right = si_unit(quantity);
  const auto known = std::find_if(std::begin(known_units), std::end(known_units),
                                  [&](const KnownUnit& k) { return k.name == unit && k.quantity == quantity; });
  if (known != std::end(known_units) && known->factor == "1")
    return fmt::format("unit '{}' is spelled differently here: write '{}'", unit, right);
  if (known != std::end(known_units))
    return fmt::format("unit '{}' is not SI: multiply the samples by {} and write '{}'", unit, known->factor,
                       right);
  std::string measures;
  for (const Quantity other : all_quantities)
    if (is_si(other, unit)) measures = to_string(other);
  for (const KnownUnit& other : known_units)
    if (measures.empty() && other.name == unit) measures = to_string(other.quantity);
  for (const OtherUnit& other : other_units)
    if (other.name == unit) measures = other.measures;
  if (measures.empty())
    return fmt::format("unit '{}' is not known: '{}' was expected for the quantity {}", unit, right,
                       to_string(quantity));
  return fmt::format("unit '{}' measures {}, the quantity is {}: '{}' was expected", unit, measures,
                     to_string(quantity), right);
}

}  // namespace secular
