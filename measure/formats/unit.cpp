#include "measure/formats/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <string_view>
#include <vector>

#include "input/nearest_word.hpp"

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
    {"um/s^2", Quantity::acceleration, "1e-6"},
    {"km/s^2", Quantity::acceleration, "1000"},
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

struct Spelling {
  std::string_view found, meant;
};

/// How measuring programs spell units that this one spells in one way.
constexpr Spelling spellings[] = {
    {"G", "g"},           {"g's", "g"},           {"M/S^2", "m/s^2"},   {"M/S2", "m/s^2"},
    {"m/s**2", "m/s^2"},  {"m/sec^2", "m/s^2"},   {"m/sec2", "m/s^2"},  {"M/S", "m/s"},
    {"m/sec", "m/s"},     {"mm/sec", "mm/s"},     {"M", "m"},           {"Volt", "V"},
    {"Volts", "V"},       {"VOLT", "V"},          {"volt", "V"},        {"volts", "V"},
    {"Newton", "N"},      {"newton", "N"},        {"NEWTON", "N"},      {"Deg", "deg"},
    {"DEG", "deg"},       {"RAD", "rad"},         {"Rad", "rad"},       {"MM", "mm"},
    {"uE", "ustrain"},    {"uStrain", "ustrain"}, {"µE", "ustrain"},    {"µstrain", "ustrain"},
    {"lb", "lbf"},        {"mm/s2", "mm/s^2"},    {"mm/s²", "mm/s^2"},  {"in/s2", "in/s^2"},
    {"μm", "µm"},         {"m s-2", "m/s^2"},     {"m s**-2", "m/s^2"}, {"m.s-2", "m/s^2"},
    {"ms^-2", "m/s^2"},   {"m*s^-2", "m/s^2"},    {"m·s^-2", "m/s^2"},  {"m·s⁻²", "m/s^2"},
    {"m s⁻²", "m/s^2"},   {"ms^-1", "m/s"},       {"m·s⁻¹", "m/s"},     {"m s⁻¹", "m/s"},
    {"g_n", "g"},         {"gal", "Gal"},         {"um/s²", "um/s^2"},  {"µm/s²", "um/s^2"},
    {"µm/s^2", "um/s^2"}, {"cm/s²", "cm/s^2"},    {"cm/s2", "cm/s^2"},  {"km/s²", "km/s^2"},
    {"m s-1", "m/s"},     {"m s**-1", "m/s"},     {"m.s-1", "m/s"},     {"meter", "m"},
    {"meters", "m"},      {"metre", "m"},         {"metres", "m"},      {"inch", "in"},
    {"inches", "in"},     {"newtons", "N"},       {"Newtons", "N"},     {"radian", "rad"},
    {"radians", "rad"},   {"Degrees", "deg"}};

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
                                     {"N m", "torque"},
                                     {"count", "a converter's steps"},
                                     {"counts", "a converter's steps"},
                                     {"Counts", "a converter's steps"},
                                     {"cts", "a converter's steps"},
                                     {"LSB", "a converter's steps"},
                                     {"digits", "a converter's steps"}};

struct TimeUnit {
  std::string_view name;
  double seconds;
};

constexpr TimeUnit time_units[] = {{"s", 1},
                                   {"S", 1},
                                   {"sec", 1},
                                   {"second", 1},
                                   {"seconds", 1},
                                   {"ms", 1e-3},
                                   {"msec", 1e-3},
                                   {"millisecond", 1e-3},
                                   {"milliseconds", 1e-3},
                                   {"us", 1e-6},
                                   {"usec", 1e-6},
                                   {"µs", 1e-6},
                                   {"μs", 1e-6},
                                   {"microsecond", 1e-6},
                                   {"microseconds", 1e-6},
                                   {"ns", 1e-9},
                                   {"nanoseconds", 1e-9},
                                   {"min", 60},
                                   {"minute", 60},
                                   {"minutes", 60},
                                   {"h", 3600},
                                   {"hour", 3600},
                                   {"hours", 3600},
                                   {"millis", 1e-3},
                                   {"micros", 1e-6},
                                   {"mins", 60},
                                   {"d", 86400},
                                   {"day", 86400},
                                   {"days", 86400}};

constexpr Quantity all_quantities[] = {Quantity::acceleration, Quantity::velocity, Quantity::displacement,
                                       Quantity::force,        Quantity::voltage,  Quantity::strain,
                                       Quantity::angle};

bool is_si(Quantity quantity, std::string_view unit) {
  return unit == si_unit(quantity) || (quantity == Quantity::strain && unit == "m/m");
}

std::string without_brackets(const std::string& unit) {
  const bool bracketed = unit.size() > 2 && ((unit.front() == '(' && unit.back() == ')') ||
                                             (unit.front() == '[' && unit.back() == ']'));
  return bracketed && unit.find_first_of("([", 1) == std::string::npos ? unit.substr(1, unit.size() - 2) : unit;
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

std::string usual_spelling(const std::string& unit) {
  const std::string bare = without_brackets(unit);
  const auto known =
      std::find_if(std::begin(spellings), std::end(spellings), [&](const Spelling& s) { return s.found == bare; });
  return known == std::end(spellings) ? bare : std::string(known->meant);
}

bool is_bare_ratio(const std::string& unit) {
  return unit == "1" || unit == "%";
}

std::optional<double> seconds_in(const std::string& unit) {
  const std::string bare = without_brackets(unit.substr(0, unit.find(" since ")));  // "seconds since 2020-01-01"
  for (const TimeUnit& known : time_units)
    if (known.name == bare) return known.seconds;
  // Time alone is measured here: MS and Min are no mega and no other unit.
  std::string lower = bare;
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (lower.size() > 1 && lower != bare) return seconds_in(lower);
  return std::nullopt;
}

void scale_to_seconds(std::vector<double>& stamps, double seconds) {
  if (seconds < 1) {
    const double units_a_second = std::round(1 / seconds);  // 1.5 ms are the number 0.0015
    for (double& stamp : stamps) stamp /= units_a_second;
  } else if (seconds > 1) {
    for (double& stamp : stamps) stamp *= seconds;
  }
}

std::string other_measure(const std::string& unit) {
  for (const OtherUnit& other : other_units)
    if (other.name == unit) return std::string(other.measures);
  return {};
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

namespace {

std::vector<std::string> units_of(Quantity quantity) {
  std::vector<std::string> units{si_unit(quantity)};
  for (const KnownUnit& known : known_units)
    if (known.quantity == quantity) units.emplace_back(known.name);
  return units;
}

}  // namespace

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
  if (measures.empty()) measures = other_measure(unit);
  if (measures.empty())
    return remedy_for_word(fmt::format("unit '{}' is not known: '{}' was expected for the quantity {}", unit, right,
                                       to_string(quantity)),
                           unit, units_of(quantity));
  return fmt::format("unit '{}' measures {}, the quantity is {}: '{}' was expected", unit, measures,
                     to_string(quantity), right);
}

}  // namespace secular
