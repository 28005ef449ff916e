#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace secular {

/// Names of a column of frequencies that need not be said, the plainest first.
inline constexpr std::string_view frequency_names[] = {"frequency", "Frequency", "FREQUENCY", "freq",
                                                       "Freq",      "FREQ",      "f"};

inline bool is_frequency_name(std::string_view name) {
  return std::find(std::begin(frequency_names), std::end(frequency_names), name) != std::end(frequency_names);
}

/// Names of frequencies in rad/s: "omega", "Omega_1", "w".
inline bool is_circular_frequency_name(std::string_view name) {
  return name.starts_with("omega") || name.starts_with("Omega") || name == "w";
}

}  // namespace secular
