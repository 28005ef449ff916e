#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace secular {

/// What a channel measures.
enum class Quantity { acceleration, velocity, displacement, force, voltage, strain, angle };

inline constexpr std::pair<std::string_view, Quantity> quantity_names[] = {{"acceleration", Quantity::acceleration},
                                                                           {"velocity", Quantity::velocity},
                                                                           {"displacement", Quantity::displacement},
                                                                           {"force", Quantity::force},
                                                                           {"voltage", Quantity::voltage},
                                                                           {"strain", Quantity::strain},
                                                                           {"angle", Quantity::angle}};

inline constexpr std::string_view quantity_list =
    "acceleration, velocity, displacement, force, voltage, strain or angle";

/// By these names; nothing for any other text.
std::string to_string(Quantity quantity);
std::optional<Quantity> parse_quantity(std::string_view text);

}  // namespace secular
