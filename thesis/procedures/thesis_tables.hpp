#pragma once

#include <optional>
#include <string_view>

namespace secular::app {

/// A number that the source's tables print for the two-mass structure.
struct PrintedValue {
  std::string_view table, equation, name;
  double value = 0;
  std::optional<double> sd;
};

/// By the equation it was estimated from ("" for values that only a summary table has) and the unknown's name as
/// the procedures call it; nothing if no table has it.
std::optional<PrintedValue> printed_value(std::string_view equation, std::string_view name);

}  // namespace secular::app
